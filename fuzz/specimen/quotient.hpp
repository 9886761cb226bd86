/// The Delaunay triangulation of the manifold itself, simplicial or not: what ref's insertion without covers
/// ends in, before it is looked at for loops and 2-cycles and perhaps lifted to a cover of up to 126 sheets.
/// It costs as little as the answer on the manifold, for every point set.
#pragma once

#include <optional>

#include "flatdt/ref/instance.hpp"
#include "flatdt/ref/periodic_delaunay.hpp"
#include "flatdt/ref/prepared_group.hpp"
#include "flatdt/ref/triangulation_format.hpp"

namespace flatdt::fuzz {

struct Quotient {
  /// The cells modulo H, in canonical order: H = G, or for the didicosm the subgroup of index 2 under which
  /// the symbolic perturbation is invariant (then has_subgroup is set).
  ref::Triangulation triangulation;
  /// For H = G: whether the edges modulo G have neither loop nor 2-cycle; by Theorem 7, whether the manifold
  /// carries the triangulation.
  std::optional<bool> simplicial;
};

struct QuotientOptions {
  /// The sites are inserted in their order, rotated by this many.
  std::size_t first = 0;
  ref::PredicateStages stages = ref::PredicateStages::filtered;
  /// See ref::Setting.
  std::size_t region_limit = ref::kRegionLimit;
};

/// Requires: group is that of the instance. Errors: LimitReached. Law: the options change nothing.
[[nodiscard]] Quotient quotient(const ref::Instance& instance, const ref::PreparedGroup& group,
                                const QuotientOptions& options = {});

}  // namespace flatdt::fuzz
