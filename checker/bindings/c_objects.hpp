// What the opaque handles of the C interface are, and how exceptions become codes.
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <span>
#include <string>

#include "flatdt/checker/c.h"
#include "text_builder.hpp"

struct flatdt_instance {
  flatdt::checker::InstanceBuilder builder;
  std::string text;
};

struct flatdt_triangulation {
  flatdt::checker::TriangulationBuilder builder;
  std::string text;
};

namespace flatdt::checker {

/// Runs an action; the code for what it throws.
template <class Action>
flatdt_error guarded(const Action& action) noexcept {
  try {
    action();
    return FLATDT_OK;
  } catch (const RefusedPiece&) {
    return FLATDT_INVALID_ARGUMENT;
  } catch (const std::bad_alloc&) {
    return FLATDT_OUT_OF_MEMORY;
  } catch (...) {
    return FLATDT_INTERNAL_ERROR;
  }
}

/// Gives what `make` returns, which the caller then owns.
template <class Object, class Make>
flatdt_error give(Object** result, const Make& make) noexcept {
  if (result == nullptr) return FLATDT_INVALID_ARGUMENT;
  *result = nullptr;
  return guarded([&] { *result = make().release(); });
}

template <class T>
std::span<const T> span_of(const T* first, std::size_t count) {
  if (first == nullptr && count != 0) throw RefusedPiece("a NULL where a list must stand");
  return {first, count};
}

}  // namespace flatdt::checker
