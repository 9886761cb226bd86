#include "limb_pool.hpp"

#include <gmp.h>

#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

// Only where ASan is linked. This file itself is compiled without instrumentation: it works on poisoned
// memory.
// NOLINTNEXTLINE(bugprone-reserved-identifier): ASan's name
extern "C" __attribute__((weak)) void __asan_get_shadow_mapping(std::size_t*, std::size_t*);

namespace flatdt::fuzz {
namespace {

constexpr std::size_t kLimbBytes = sizeof(mp_limb_t);
constexpr std::size_t kMaxLimbs = 32;
constexpr std::size_t kChunkBytes = std::size_t{1} << 16;

void* from_malloc(std::size_t size) {
  void* const block = std::malloc(size);
  if (block == nullptr) std::abort();  // GMP has no way to be told
  return block;
}

/// Whether blocks of this size come from the pool: strings that GMP makes have any size.
bool is_pooled(std::size_t size) {
  return size % kLimbBytes == 0 && size > 0 && size <= kMaxLimbs * kLimbBytes;
}

/// ASan's record of which bytes may be used, one byte for each 8; nothing without ASan.
class Shadow {
 public:
  Shadow() {
    std::size_t scale = 0;
    if (__asan_get_shadow_mapping != nullptr) __asan_get_shadow_mapping(&scale, &offset_);
    known_ = scale == 3;
  }
  void poison(void* block, std::size_t size) const { set(block, size, kPoisonedByUser); }
  void unpoison(void* block, std::size_t size) const { set(block, size, 0); }
  [[nodiscard]] bool is_poisoned(void* block) const { return known_ && *of(block) != 0; }

 private:
  static constexpr unsigned char kPoisonedByUser = 0xf7;
  static_assert(kLimbBytes == 8);

  [[nodiscard]] volatile unsigned char* of(void* block) const {
    // NOLINTNEXTLINE(performance-no-int-to-ptr): the shadow is found by arithmetic on addresses
    return reinterpret_cast<volatile unsigned char*>((reinterpret_cast<std::uintptr_t>(block) >> 3) +
                                                     offset_);
  }
  /// Byte by byte: std::memset is ASan's own, which does not want to write here.
  void set(void* block, std::size_t size, unsigned char value) const {
    if (!known_) return;
    for (std::size_t k = 0; k < size / 8; ++k) of(block)[k] = value;
  }

  bool known_ = false;
  std::size_t offset_ = 0;
};

/// Of a pool that several threads use.
class Guard {
 public:
  explicit Guard(std::atomic_flag& busy) : busy_(busy) {
    while (busy_.test_and_set(std::memory_order_acquire)) {
    }
  }
  ~Guard() { busy_.clear(std::memory_order_release); }
  Guard(const Guard&) = delete;
  Guard& operator=(const Guard&) = delete;

 private:
  std::atomic_flag& busy_;
};

/// Lists of free blocks. A block may come back to another pool than it was taken from.
class LimbPool {
 public:
  void* take(std::size_t size) {
    Block*& first = free_[size / kLimbBytes];
    if (first == nullptr) add_chunk(size, first);
    Block* const block = first;
    first = block->next;
    shadow_.unpoison(block, size);
    return block;
  }

  void give(void* memory, std::size_t size) {
    if (shadow_.is_poisoned(memory)) {
      std::fputs("fuzz: a number is freed twice\n", stderr);
      std::abort();
    }
    shadow_.poison(memory, size);
    Block*& first = free_[size / kLimbBytes];
    first = new (memory) Block{first};
  }

 private:
  struct Block {
    Block* next;
  };
  /// The first limb of a chunk, not poisoned: the leak checker follows no pointers in poisoned memory, so
  /// that chunks known by free blocks alone would be leaks.
  struct Chunk {
    Chunk* previous;
  };
  static_assert(sizeof(Chunk) == kLimbBytes);

  void add_chunk(std::size_t size, Block*& first) {
    const std::size_t stride = size + kLimbBytes;  // a poisoned limb between blocks
    auto* const chunk = static_cast<char*>(from_malloc(kChunkBytes));
    last_chunk_ = new (chunk) Chunk{last_chunk_};
    shadow_.poison(chunk + kLimbBytes, kChunkBytes - kLimbBytes);
    for (std::size_t at = 2 * kLimbBytes; at + stride <= kChunkBytes; at += stride) {
      first = new (chunk + at) Block{first};
    }
  }

  Chunk* last_chunk_ = nullptr;
  Block* free_[kMaxLimbs + 1] = {};
  Shadow shadow_;
};

/// The thread that runs the inputs has a pool to itself, all others together have one: the checker may count
/// in several threads, and the engine has one of its own, so that a lock would be taken for every number.
struct Pools {
  LimbPool own;
  LimbPool shared;
  std::atomic_flag shared_is_busy = ATOMIC_FLAG_INIT;
};

/// Never destroyed: constants of the libraries are freed after everything else.
Pools* pools = nullptr;
thread_local bool runs_inputs = false;

void* allocate(std::size_t size) {
  if (!is_pooled(size)) return from_malloc(size);
  if (runs_inputs) return pools->own.take(size);
  const Guard guard(pools->shared_is_busy);
  return pools->shared.take(size);
}

void release(void* block, std::size_t size) {
  if (!is_pooled(size)) {
    std::free(block);
  } else if (runs_inputs) {
    pools->own.give(block, size);
  } else {
    const Guard guard(pools->shared_is_busy);
    pools->shared.give(block, size);
  }
}

void* reallocate(void* block, std::size_t old_size, std::size_t new_size) {
  void* const moved = allocate(new_size);
  std::memcpy(moved, block, old_size < new_size ? old_size : new_size);
  release(block, old_size);
  return moved;
}

}  // namespace

void use_limb_pool() {
  if (pools == nullptr) pools = new Pools;
  runs_inputs = true;
  mp_set_memory_functions(allocate, reallocate, release);
}

}  // namespace flatdt::fuzz
