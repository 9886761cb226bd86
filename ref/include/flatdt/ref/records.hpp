/// A growing array of small records in one block of memory, for the millions of cells of a large complex.
/// Unlike std::vector it grows and shrinks in place where the system can (large blocks are remapped, not
/// copied, so that growing never holds the array twice), and an array of records can become one of smaller
/// records within its own block.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <new>
#include <type_traits>
#include <utility>

namespace flatdt::ref {

template <class T>
class Records {
  static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= alignof(std::max_align_t));

 public:
  Records() = default;
  Records(const Records& o) {
    reserve(o.size_);
    if (o.size_ > 0) std::memcpy(static_cast<void*>(data_), o.data_, o.size_ * sizeof(T));
    size_ = o.size_;
  }
  Records(Records&& o) noexcept
      : data_(std::exchange(o.data_, nullptr)),
        size_(std::exchange(o.size_, 0)),
        capacity_(std::exchange(o.capacity_, 0)) {}
  Records& operator=(Records o) noexcept {
    std::swap(data_, o.data_);
    std::swap(size_, o.size_);
    std::swap(capacity_, o.capacity_);
    return *this;
  }
  ~Records() { std::free(data_); }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] T& operator[](std::size_t i) { return data_[i]; }
  [[nodiscard]] const T& operator[](std::size_t i) const { return data_[i]; }
  [[nodiscard]] T* begin() { return data_; }
  [[nodiscard]] T* end() { return data_ + size_; }
  [[nodiscard]] const T* begin() const { return data_; }
  [[nodiscard]] const T* end() const { return data_ + size_; }

  /// Amortised O(1); invalidates references like a vector's.
  void push_back(const T& value) {
    if (size_ == capacity_) {
      const T copy = value;  // it may be one of ours
      set_capacity(capacity_ + capacity_ / 2 + 16);
      new (data_ + size_++) T(copy);
      return;
    }
    new (data_ + size_++) T(value);
  }
  /// Memory that is reserved but not used costs addresses only, where the block is a large one.
  void reserve(std::size_t capacity) {
    if (capacity > capacity_) set_capacity(capacity);
  }
  /// Keeps the first `size` records. Requires: not more than there are.
  void truncate(std::size_t size) { size_ = size; }
  /// Gives memory that is not used back.
  void shrink_to_fit() {
    if (size_ < capacity_) set_capacity(size_);
  }

  /// The records as others, not larger, in the same order and the same block: `turn(record, other)` makes one
  /// and says whether it is kept. What is left over is given back.
  template <class U, class Turn>
  [[nodiscard]] Records<U> turned(const Turn& turn) && {
    static_assert(sizeof(U) <= sizeof(T) && alignof(U) <= alignof(std::max_align_t));
    Records<U> result;
    if (data_ == nullptr) return result;
    auto* const bytes = reinterpret_cast<std::byte*>(data_);
    // Invariant: the block has `kept` records U, then records T from i on: they do not overlap, for kept <=
    // i.
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const T record = data_[i];
      U other;
      if (turn(record, other)) new (bytes + kept++ * sizeof(U)) U(other);
    }
    result.capacity_ = capacity_ * sizeof(T) / sizeof(U);
    result.size_ = kept;
    result.data_ = std::launder(reinterpret_cast<U*>(bytes));
    data_ = nullptr;
    size_ = capacity_ = 0;
    result.shrink_to_fit();
    return result;
  }

 private:
  template <class U>
  friend class Records;

  void set_capacity(std::size_t capacity) {
    if (capacity > std::numeric_limits<std::size_t>::max() / sizeof(T)) throw std::bad_alloc();
    if (capacity == 0) {
      std::free(data_);
      data_ = nullptr;
    } else {
      void* const block = std::realloc(static_cast<void*>(data_), capacity * sizeof(T));
      if (block == nullptr) throw std::bad_alloc();
      data_ = static_cast<T*>(block);
    }
    capacity_ = capacity;
  }

  T* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

}  // namespace flatdt::ref
