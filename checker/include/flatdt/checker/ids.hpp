// Strong ids: a number of one kind is never taken for one of another.
#pragma once

#include <cstddef>
#include <cstdint>

namespace flatdt::checker {

/// A point of the instance file, counted from 0.
enum class PointId : std::uint32_t {};
/// A G-orbit of points, in the order of their first points.
enum class OrbitId : std::uint32_t {};
/// An element of G in an ElementTable; the identity is ElementId{0}.
enum class ElementId : std::uint32_t {};
/// A vertex modulo H that some cell uses.
enum class VertexId : std::uint32_t {};
/// A cell of the triangulation file, counted from 0.
enum class CellId : std::uint32_t {};

/// The number behind an id.
template <class Id>
[[nodiscard]] constexpr std::size_t index(Id id) {
  return static_cast<std::size_t>(id);
}

/// The id with a number. Requires: the number fits.
template <class Id>
[[nodiscard]] constexpr Id make_id(std::size_t number) {
  return static_cast<Id>(number);
}

}  // namespace flatdt::checker
