#include "flatdt/ref/triangulate.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "flatdt/ref/delaunay_hierarchy.hpp"
#include "flatdt/ref/skeleton_cycles.hpp"
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

/// Group elements of the internal frame, applied to sites, as elements of the instance applied to its points.
class InstanceElements {
 public:
  InstanceElements(const Frame& frame, const GroupTable& table, const std::vector<Site>& sites)
      : table_(&table),
        sites_(&sites),
        to_instance_{frame.basis, frame.origin},
        from_instance_(to_instance_.inverse()) {
    for (const Site& site : sites) point_to_site_.push_back(site.from_site.inverse() * from_instance_);
    untranslated_.resize(sites.size() * static_cast<std::size_t>(table.cosets()));
  }
  /// The element e of the instance's group with e * points[site.point] = p.
  [[nodiscard]] Isometry at(const OrbitPoint& p) {
    // Products of rational matrices once for each site and coset; a translation then only adds lattice
    // vectors.
    std::optional<Isometry>& base =
        untranslated_[index_of(p.site) * static_cast<std::size_t>(table_->cosets()) + p.g.coset];
    if (!base)
      base = to_instance_ * table_->isometry(Element{{}, p.g.coset}) * point_to_site_[index_of(p.site)];
    Isometry element = *base;
    for (int j = 0; j < table_->dimension(); ++j) {
      const long t = p.g.t[static_cast<std::size_t>(j)];
      if (t == 0) continue;
      for (int i = 0; i < table_->dimension(); ++i)
        element.translation[i] += Rational(t) * to_instance_.linear(i, j);
    }
    return element;
  }
  /// For an edge from site a to g * (site b): the element e with the edge from points[a] to e * points[b].
  [[nodiscard]] Isometry between(SiteId a, const OrbitPoint& b) const {
    return to_instance_ * (*sites_)[index_of(a)].from_site * table_->isometry(b.g) *
           point_to_site_[index_of(b.site)];
  }
  [[nodiscard]] Isometry conjugate(const Isometry& g) const { return to_instance_ * g * from_instance_; }

 private:
  const GroupTable* table_;
  const std::vector<Site>* sites_;
  Isometry to_instance_;
  Isometry from_instance_;
  std::vector<Isometry> point_to_site_;
  std::vector<std::optional<Isometry>> untranslated_;
};

template <int D>
Triangulation to_triangulation(const std::vector<CellPoints<D>>& cells, const std::vector<Site>& sites,
                               InstanceElements& elements) {
  Triangulation result;
  result.dimension = D;
  std::map<Isometry, std::uint32_t> numbers;
  std::map<OrbitPoint, std::uint32_t> known;
  for (const CellPoints<D>& cell : cells) {
    std::array<Triangulation::CellVertex, 4> vertices{};
    for (std::size_t k = 0; k <= D; ++k) {
      const auto [entry, inserted] = known.try_emplace(cell[k], 0U);
      if (inserted) {
        Isometry element = elements.at(cell[k]);
        const auto [number, is_new] =
            numbers.try_emplace(element, static_cast<std::uint32_t>(result.elements.size()));
        if (is_new) result.elements.push_back(std::move(element));
        entry->second = number->second;
      }
      vertices[k] = {sites[index_of(cell[k].site)].point, entry->second};
    }
    result.cells.push_back(vertices);
  }
  return result;
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
        elements_(frame_, table_, sites_),
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
    DelaunayHierarchy<D> hierarchy(
        {&frame_, &table_, &sites_, &order_, &predicates_, &circumradius_, options_.region_limit}, worked_in,
        options_.insertion);
    SplitMix64 random(options_.order_seed);
    for (const SiteId site : random_order(sites_.size(), random))
      hierarchy.insert_orbit(site, std::min(random_level(random), hierarchy.levels()));
    result.hierarchy_levels = hierarchy.levels();
    result.switched_after = hierarchy.switched_after();
    finish(hierarchy.full().complex(), result);
    return result;
  }

 private:
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
    result.empty_diameter_squared = squared_diameter(complex, cells);

    // The end-of-run test of Section 4.1: modulo G, if the triangulation is invariant under all of G, look
    // for a loop or a 2-cycle (Theorem 7 and its converse).
    std::optional<std::vector<CellPoints<D>>> quotient = cells;
    if (!complex.subgroup().is_whole() && !invariance.is_whole())
      quotient = cells_modulo<D>(table_, whole, cells, invariance.index());
    if (!quotient) {
      result.reason = not_invariant(cells);
    } else if (const auto cycle = find_short_cycle<D>(table_, *quotient)) {
      result.reason = explain(*cycle);
    } else {
      result.triangulation = to_triangulation<D>(*quotient, sites_, elements_);
      return;
    }
    ensure(!result.switched_after.has_value(), "Corollary 9: no loop or 2-cycle after the switch");
    write_cover(cells, result);
  }

  void write_cover(const std::vector<CellPoints<D>>& cells, TriangulationResult& result) {
    const Sublattice smallest = complete_orbit_cover(frame_);
    const Subgroup target = Subgroup::sublattice(table_, smallest);
    const std::vector<CellPoints<D>> unfolded = unfold<D>(table_, order_.invariance_group(), target, cells);
    ensure(is_simplicial<D>(table_, target, unfolded),
           "the complete-orbit cover is simplicial for every point set");
    result.triangulation = to_triangulation<D>(unfolded, sites_, elements_);
    result.triangulation.has_subgroup = true;
    for (int j = 0; j < D; ++j)
      result.triangulation.subgroup.push_back(
          elements_.conjugate(Isometry::translate(smallest.basis.column(j))));
    result.sheets = smallest.sheets;
  }

  Rational squared_diameter(const QuotientComplex<D>& complex, const std::vector<CellPoints<D>>& cells) {
    std::vector<std::array<Lift, D + 1>> lifts(cells.size());
    for (std::size_t c = 0; c < cells.size(); ++c)
      for (std::size_t k = 0; k <= D; ++k) lifts[c][k] = complex.lift(cells[c][k]);
    return circumradius_.squared_diameter(lifts);
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
