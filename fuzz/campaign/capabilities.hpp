/// What an implementation accepts: cases are drawn so that they fit, and what does not fit is counted as
/// unsupported, never as wrong. Source: docs/campaigns.md, "Capabilities".
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "specimen.hpp"

namespace flatdt::campaign {

/// The most points that a case may have.
inline constexpr std::size_t kMostPoints = 1'000'000;

/// What the implementation's output claims.
enum class Claim {
  triangulation,  // flatdt-triangulation 1, judged by the checker
  edges,          // flatdt-edges 1: the Delaunay graph (edge_claim.hpp)
};

struct Capabilities {
  /// Canonical names or aliases; empty: all.
  std::vector<std::string> manifolds;
  /// Only the catalogue's metric.
  bool canonical_metric_only = false;
  /// Only points with coordinates in [0,1) that are multiples of 2^-50: their images under the catalogue's
  /// elements are doubles too, where translations are dyadic.
  bool doubles_only = false;
  /// Only the catalogue's coordinates, with the name and without a generators section.
  bool names_only = false;
  /// Only points in different orbits.
  bool distinct_only = false;
  std::size_t min_points = 1;
  std::optional<std::size_t> max_points_in_plane;
  std::optional<std::size_t> max_points_in_space;
  Claim claim = Claim::triangulation;
  /// Claims of edges: a Voronoi facet that is no wider than this, in lengths of the shortest translation, may
  /// be missed. 0: none may.
  ref::Rational facet_resolution{0};
  /// The exit code that says "this instance is not supported".
  int unsupported_exit = 4;
};

/// Reads a capabilities file (JSON, schema "flatdt-capabilities 1").
/// Errors: std::runtime_error for a file that cannot be read, is no such JSON, has a key that is not known,
/// or a value of another type or out of its range; the message names file, key and value, and says what is
/// right.
[[nodiscard]] Capabilities read_capabilities(const std::string& path);

/// Is this specimen one that the implementation says it accepts?
[[nodiscard]] bool accepts(const Capabilities& capabilities, const testing::Specimen& specimen);

/// The specimen changed as little as needed to be accepted: catalogue metric and coordinates, coordinates
/// rounded down to doubles, repeated points left out. The manifold stays, and so may the number of points:
/// accepts() has the last word.
[[nodiscard]] testing::Specimen conform(const Capabilities& capabilities, testing::Specimen specimen);

}  // namespace flatdt::campaign
