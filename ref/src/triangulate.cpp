#include "flatdt/ref/triangulate.hpp"

#include <algorithm>

#include "flatdt/ref/delaunay_hierarchy.hpp"
#include "flatdt/ref/first_orbit.hpp"
#include "flatdt/ref/insertion_order.hpp"
#include "flatdt/ref/skeleton_cycles.hpp"
#include "instance_elements.hpp"
#include "split_mix.hpp"

namespace flatdt::ref {
namespace {

/// A random insertion order (the analysis of Section 4.3 asks for one).
std::vector<SiteId> random_order(std::size_t n, SplitMix64& random) {
  std::vector<SiteId> order(n);
  for (std::size_t i = 0; i < n; ++i) order[i] = SiteId{static_cast<std::uint32_t>(i)};
  for (std::size_t i = n; i > 1; --i) std::swap(order[i - 1], order[random.next() % i]);
  return order;
}

/// Each orbit goes one level up with probability 1/kRatio ([Devillers02] recommends about 1/30).
std::size_t random_level(SplitMix64& random) {
  constexpr std::uint64_t kRatio = 30;
  std::size_t level = 0;
  while (level < 16 && random.next() % kRatio == 0) ++level;
  return level;
}

/// The predicates take products of the metric's entries. The limit covers exponents down to 10^-1100 and
/// 2^-4400.
const Frame& checked_size(const Frame& frame) {
  constexpr std::size_t kMaxMetricBits = 4608;
  for (int i = 0; i < frame.dimension; ++i)
    for (int j = i; j < frame.dimension; ++j) {
      const Rational& entry = frame.gram(i, j);
      if (std::max(entry.numerator().bits(), entry.denominator().bits()) > kMaxMetricBits)
        throw LimitReached(
            "entry (" + std::to_string(i + 1) + "," + std::to_string(j + 1) +
            ") of the metric of the reduced lattice has a numerator or denominator of more than " +
            std::to_string(kMaxMetricBits) + " bits");
    }
  return frame;
}

template <int D>
class Run {
 public:
  Run(const Instance& instance, const GroupAnalysis& analysis, const TriangulationOptions& options)
      : frame_(checked_size(analysis.frame)),
        table_(frame_),
        sites_(make_sites(frame_, instance.points)),
        order_(frame_, table_),
        predicates_(frame_, table_, sites_, order_, options.stages),
        circumradius_(frame_, predicates_),
        elements_(frame_, sites_, table_),
        options_(options) {}

  TriangulationResult operator()() {
    TriangulationResult result;
    result.distinct_points = sites_.size();
    result.delta_squared = frame_.delta_squared;
    if (options_.insertion == Insertion::covering)
      result.working_cover = options_.cover == CoverChoice::theorem10
                                 ? theorem10_cover(frame_, options_.max_sheets)
                                 : one_at_a_time_cover(frame_, options_.max_sheets);
    const Subgroup worked_in = result.working_cover ? Subgroup::sublattice(table_, *result.working_cover)
                                                    : order_.invariance_group();
    const Setting<D> setting{
        &frame_, &table_, &sites_, &order_, &predicates_, &circumradius_, options_.region_limit};
    if (options_.insertion == Insertion::without_covers && options_.order == InsertionOrder::batch)
      insert_batch(PeriodicDelaunay<D>(setting, worked_in, options_.insertion), result);
    else
      insert_in_random_order(DelaunayHierarchy<D>(setting, worked_in, options_.insertion), result);
    return result;
  }

 private:
  void insert_batch(PeriodicDelaunay<D> level, TriangulationResult& result) {
    const std::vector<SiteId> order = batch_order(frame_, sites_, options_.order_seed);
    level.reserve(order.size());
    level.start(order[0], triangulate_first_orbit<D>(frame_, table_, sites_, order_, predicates_, order[0]));
    for (std::size_t i = 1; i < order.size(); ++i) {
      level.add_site(order[i]);
      for (std::uint32_t rep = 0; rep < level.copies(); ++rep) {
        const Element query = level.complex().subgroup().representative(rep);
        level.insert(order[i], rep, level.locate(order[i], query, {order[i - 1], query}));
      }
    }
    finish(level.complex(), result);
  }

  void insert_in_random_order(DelaunayHierarchy<D> hierarchy, TriangulationResult& result) {
    SplitMix64 random(options_.order_seed);
    for (const SiteId site : random_order(sites_.size(), random))
      hierarchy.insert_orbit(site, std::min(random_level(random), hierarchy.levels()));
    result.hierarchy_levels = hierarchy.levels();
    result.switched_after = hierarchy.switched_after();
    finish(hierarchy.full().complex(), result);
  }

  void finish(const QuotientComplex<D>& complex, TriangulationResult& result) {
    const Subgroup whole = Subgroup::whole(table_);
    const Subgroup& invariance = order_.invariance_group();
    std::vector<CellPoints<D>> cells = complex.all_cells();
    if (!complex.subgroup().is_whole()) {
      auto folded =
          cells_modulo<D>(table_, invariance, cells, complex.subgroup().index() / invariance.index());
      ensure(folded.has_value(),
             "complete orbits give a triangulation invariant under the tie order's group");
      cells = *std::move(folded);
    } else {
      cells = *cells_modulo<D>(table_, whole, cells, 1);
    }
    result.empty_diameter_squared =
        circumradius_.squared_diameter(cells, [&complex](const OrbitPoint& p) { return complex.lift(p); });

    // The end-of-run test of Section 4.1: modulo G, if the triangulation is invariant under all of G, look
    // for a loop or a 2-cycle (Theorem 7 and its converse).
    std::optional<std::vector<CellPoints<D>>> quotient = cells;
    if (!complex.subgroup().is_whole() && !invariance.is_whole())
      quotient = cells_modulo<D>(table_, whole, cells, invariance.index());
    if (!quotient) {
      result.reason = not_invariant(cells);
    } else if (const auto cycle = find_cycle(*quotient, result.empty_diameter_squared)) {
      result.reason = explain(*cycle);
    } else {
      result.triangulation = to_triangulation<D>(*quotient, elements_);
      return;
    }
    ensure(!result.switched_after.has_value(), "Corollary 9: no loop or 2-cycle after the switch");
    write_cover(cells, result);
  }

  /// Corollary 9: no loop or 2-cycle if the largest empty ball's diameter is below delta/2.
  std::optional<ShortCycle> find_cycle(const std::vector<CellPoints<D>>& cells,
                                       const Rational& diameter_squared) {
    if (Rational(4) * diameter_squared < frame_.delta_squared) return std::nullopt;
    return find_short_cycle<D>(table_, cells);
  }

  void write_cover(const std::vector<CellPoints<D>>& cells, TriangulationResult& result) {
    const Sublattice smallest = complete_orbit_cover(frame_);
    const Subgroup target = Subgroup::sublattice(table_, smallest);
    const std::vector<CellPoints<D>> unfolded = unfold<D>(table_, order_.invariance_group(), target, cells);
    ensure(is_simplicial<D>(table_, order_.invariance_group(), target, cells),
           "the complete-orbit cover is simplicial for every point set");
    result.triangulation = to_triangulation<D>(unfolded, elements_);
    result.triangulation.has_subgroup = true;
    for (int j = 0; j < D; ++j)
      result.triangulation.subgroup.push_back(
          elements_.conjugate(Isometry::translate(smallest.basis.column(j))));
    result.sheets = smallest.sheets;
  }

  StayedInCover explain(const ShortCycle& cycle) const {
    StayedInCover reason;
    reason.kind = cycle.loop ? StayedInCover::Kind::loop : StayedInCover::Kind::two_cycle;
    reason.first = sites_[index_of(cycle.first)].point;
    reason.second = sites_[index_of(cycle.second)].point;
    reason.g = elements_.between(cycle.first, {cycle.second, cycle.g});
    reason.h = elements_.between(cycle.first, {cycle.second, cycle.h});
    return reason;
  }

  StayedInCover not_invariant(const std::vector<CellPoints<D>>& cells) {
    const Subgroup& group = order_.invariance_group();
    const Element a = group.representative(1);
    for (const CellPoints<D>& cell : cells) {
      const auto image = canonical_face<D + 1>(table_, group, moved<D + 1>(table_, a, cell)).key;
      if (std::binary_search(cells.begin(), cells.end(), image)) continue;
      StayedInCover reason;
      reason.kind = StayedInCover::Kind::not_invariant;
      reason.g = elements_.conjugate(table_.isometry(a));
      for (const OrbitPoint& p : cell) {
        if (!reason.cell.empty()) reason.cell += ", ";
        reason.cell += "(" + elements_.at(p).to_string() + ") * points[" +
                       std::to_string(sites_[index_of(p.site)].point) + "]";
      }
      return reason;
    }
    throw InternalError("a set of cells that is not invariant has a cell without its image");
  }

  const Frame& frame_;
  GroupTable table_;
  std::vector<Site> sites_;
  TieOrder order_;
  Predicates<D> predicates_;
  Circumradius<D> circumradius_;
  InstanceElements elements_;
  TriangulationOptions options_;
};

}  // namespace

TriangulationResult triangulate(const Instance& instance, const GroupAnalysis& analysis,
                                const TriangulationOptions& options) {
  if (instance.dimension == 2) return Run<2>(instance, analysis, options)();
  return Run<3>(instance, analysis, options)();
}

std::vector<std::string> describe(const TriangulationResult& result) {
  std::vector<std::string> lines;
  if (!result.reason) {
    lines.emplace_back("Delaunay triangulation of the manifold");
    return lines;
  }
  const StayedInCover& reason = *result.reason;
  lines.push_back("Delaunay triangulation of a covering space with " + std::to_string(result.sheets) +
                  " sheets: for this tie-break the manifold itself carries none, because");
  switch (reason.kind) {
    case StayedInCover::Kind::loop:
      lines.push_back("loop: the edge from points[" + std::to_string(reason.first) + "] to (" +
                      reason.g.to_string() + ") * points[" + std::to_string(reason.second) + "]");
      break;
    case StayedInCover::Kind::two_cycle:
      lines.push_back("2-cycle: the edges from points[" + std::to_string(reason.first) + "] to (" +
                      reason.g.to_string() + ") * points[" + std::to_string(reason.second) + "] and to (" +
                      reason.h.to_string() + ") * points[" + std::to_string(reason.second) + "]");
      break;
    case StayedInCover::Kind::not_invariant:
      lines.push_back("not invariant: the cell " + reason.cell + " is not mapped to a cell by (" +
                      reason.g.to_string() + ")");
      break;
  }
  return lines;
}

}  // namespace flatdt::ref
