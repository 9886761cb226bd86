/// A specimen is what the bytes of a structured target mean: an instance, and for some targets a
/// triangulation of it or points of its orbits. Invariants: at most kMaxPoints points, kMaxGenerators
/// generators, kMaxElements elements and kMaxCells cells; numbers are within 64 bits when written as bytes.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "flatdt/ref/instance.hpp"
#include "flatdt/ref/triangulation_format.hpp"
#include "named_group.hpp"

namespace flatdt::fuzz {

inline constexpr int kMaxPoints = 8;
inline constexpr int kMaxGenerators = 5;
inline constexpr int kMaxWords = 7;
inline constexpr int kMaxElements = 255;
inline constexpr int kMaxCells = 511;
inline constexpr int kMaxQueries = 63;

/// What the bytes hold beside an instance.
struct Shape {
  bool triangulation = false;
  bool queries = false;
};

/// A group element: of a named group by coset and lattice translation, so that bytes at random are an
/// element; or any affine map, as numbers.
struct CodedElement {
  std::uint8_t coset = 0;
  std::array<std::int8_t, 3> shift{};
  std::optional<ref::Isometry> listed;
  friend bool operator==(const CodedElement& a, const CodedElement& b) {
    return a.coset == b.coset && a.shift == b.shift && a.listed == b.listed;
  }
};

struct CodedVertex {
  std::uint8_t point = 0;
  std::uint8_t element = 0;
  friend bool operator==(const CodedVertex&, const CodedVertex&) = default;
};
using CodedCell = std::array<CodedVertex, 4>;

/// A point of an orbit, for predicates.
struct CodedQuery {
  std::uint8_t point = 0;
  std::uint8_t coset = 0;
  std::array<std::int8_t, 3> shift{};
};

struct Specimen {
  /// An index into named_groups(); or kListedPlane, kListedSpace: the group is given by its generators alone.
  int group = 0;
  /// 0: no claim; k > 0: the file claims the name of named_groups()[k - 1].
  int claim = 0;
  /// For a named group: the file gives the name and no generators. Then `claim`, `words` and `change` mean
  /// nothing.
  bool name_only = false;
  /// Nielsen moves on the generators of a named group: each replaces one by its product with another or by
  /// its inverse, and leaves the group as it is.
  std::vector<std::uint8_t> words;
  /// x_file = change * x, for a named group; bijective.
  std::optional<ref::Isometry> change;
  /// Of a listed group.
  std::vector<ref::Isometry> generators;
  /// Absent: the canonical metric (the identity for a listed group). For a named group it is made invariant
  /// by taking the mean over the linear parts; where that is not positive definite, the canonical one is
  /// meant.
  std::optional<ref::Matrix> gram;
  std::vector<ref::Vector> points;

  bool has_subgroup = false;
  std::vector<CodedElement> subgroup;
  std::vector<CodedElement> elements;
  std::vector<CodedCell> cells;

  std::vector<CodedQuery> queries;

  [[nodiscard]] int dimension() const;
  /// Nothing for a listed group.
  [[nodiscard]] const NamedGroup* named() const;
};

/// The values of Specimen::group beyond the named groups.
[[nodiscard]] int listed_group(int dimension);

/// Every byte string means a specimen.
[[nodiscard]] Specimen decode(std::span<const std::uint8_t> bytes, const Shape& shape);
/// The bytes, or nothing if a number does not fit. Law: decode(encode(s)) means the same files as s.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> encode(const Specimen& specimen, const Shape& shape);

/// The metric in the specimen's own coordinates: invariant and positive definite for a named group.
[[nodiscard]] ref::Matrix metric_of(const Specimen& specimen);
/// The element in the specimen's own coordinates.
[[nodiscard]] ref::Isometry element_of(const Specimen& specimen, const CodedElement& element);

/// In the coordinates of the file.
[[nodiscard]] ref::Instance instance_of(const Specimen& specimen);
[[nodiscard]] ref::Triangulation triangulation_of(const Specimen& specimen);

/// The specimen that means these files; nothing if they are beyond the limits above. A group is named if the
/// file gives it by its name alone, otherwise listed.
[[nodiscard]] std::optional<Specimen> specimen_of(const ref::Instance& instance);
/// Adds a triangulation (in file coordinates) to a specimen; false if it is beyond the limits.
[[nodiscard]] bool set_triangulation(Specimen& specimen, const ref::Triangulation& triangulation);

}  // namespace flatdt::fuzz
