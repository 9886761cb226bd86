/// Section 4: insertion of all orbits, and the test at the end.
#include "flatdt/ref/frame_triangulation.hpp"

#include <algorithm>

#include "flatdt/ref/delaunay_hierarchy.hpp"
#include "flatdt/ref/first_orbit.hpp"
#include "flatdt/ref/insertion_order.hpp"
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

template <int D>
class Run {
 public:
  Run(std::vector<Site> sites, const PreparedGroup& group, const TriangulationOptions& options)
      : group_(group),
        sites_(std::move(sites)),
        predicates_(group.predicate_constants<D>(), group.table(), sites_, group.order(), options.stages),
        circumradius_(group.circumradius_constants<D>(), predicates_),
        options_(options) {}

  FrameTriangulation<D> operator()() && {
    if (options_.insertion == Insertion::covering)
      result_.working_cover = options_.cover == CoverChoice::theorem10
                                  ? theorem10_cover(group_.frame(), options_.max_sheets)
                                  : one_at_a_time_cover(group_.frame(), options_.max_sheets);
    const Subgroup worked_in = result_.working_cover
                                   ? Subgroup::sublattice(group_.table(), *result_.working_cover)
                                   : group_.order().invariance_group();
    const Setting<D> setting{&group_.frame(), &group_.table(),      &sites_, &group_.order(), &predicates_,
                             &circumradius_,  options_.region_limit};
    if (options_.insertion == Insertion::without_covers && options_.order == InsertionOrder::batch)
      insert_batch(setting);
    else
      insert_in_random_order(DelaunayHierarchy<D>(setting, worked_in, options_.insertion));
    result_.sites = std::move(sites_);
    return std::move(result_);
  }

 private:
  /// By rank on the whole group; where the ranks do not decide, once more modulo the group that the tie order
  /// is invariant under. The cells are the same (docs/theory.md, section 7).
  void insert_batch(const Setting<D>& setting) {
    const std::vector<SiteId> order = batch_order(group_.frame(), sites_, options_.order_seed);
    std::vector<CellPoints<D>> first;
    if (lattice_complex() == nullptr)
      first = triangulate_first_orbit<D>(group_.frame(), group_.table(), sites_, group_.order(), predicates_,
                                         order[0]);
    if (insert_batch_modulo(Subgroup::whole(group_.table()), setting, order, first)) return;
    const bool inserted = insert_batch_modulo(group_.order().invariance_group(), setting, order, first);
    ensure(inserted, "the tie order decides every tie modulo its own group");
  }

  /// `first`: the cells of the first orbit, unused where the group has them. Whether it came to an end.
  bool insert_batch_modulo(const Subgroup& subgroup, const Setting<D>& setting,
                           const std::vector<SiteId>& order, const std::vector<CellPoints<D>>& first) {
    PeriodicDelaunay<D> level(setting, subgroup, options_.insertion);
    level.reserve(order.size());
    if (const QuotientComplex<D>* const any = lattice_complex())
      level.start(order[0], *any);
    else
      level.start(order[0], first);
    for (std::size_t i = 1; i < order.size() && !level.needs_smaller_group(); ++i) {
      level.add_site(order[i]);
      for (std::uint32_t rep = 0; rep < level.copies(); ++rep) {
        const Element query = level.complex().subgroup().representative(rep);
        level.insert(order[i], rep, level.locate(order[i], query, {order[i - 1], query}));
      }
    }
    if (level.needs_smaller_group()) return false;
    finish(std::move(level).release_complex());
    return true;
  }

  /// The group's, which all stages of the predicates have made; where some are switched off, none.
  [[nodiscard]] const QuotientComplex<D>* lattice_complex() const {
    return options_.stages == PredicateStages::filtered ? group_.lattice_complex<D>() : nullptr;
  }

  void insert_in_random_order(DelaunayHierarchy<D> hierarchy) {
    SplitMix64 random(options_.order_seed);
    for (const SiteId site : random_order(sites_.size(), random))
      hierarchy.insert_orbit(site, std::min(random_level(random), hierarchy.levels()));
    result_.hierarchy_levels = hierarchy.levels();
    result_.switched_after = hierarchy.switched_after();
    finish(std::move(hierarchy).release_complex());
  }

  /// The answer is made in the memory of the complex: in place of its cells, which are not smaller.
  void finish(QuotientComplex<D> complex) {
    const GroupTable& table = group_.table();
    const Subgroup whole = Subgroup::whole(table);
    const Subgroup& invariance = group_.order().invariance_group();
    const bool is_on_manifold = complex.subgroup().is_whole();
    const Subgroup& modulo = is_on_manifold ? whole : invariance;
    const std::uint32_t multiplicity = complex.subgroup().index() / modulo.index();
    result_.widest = circumradius_.widest(complex);
    auto cells = cells_modulo<D>(table, modulo, released_cells(std::move(complex)), multiplicity);
    ensure(cells.has_value(), "complete orbits give a triangulation invariant under the tie order's group");

    // The end-of-run test of Section 4.1: modulo G, if the triangulation is invariant under all of G, look
    // for a loop or a 2-cycle (Theorem 7 and its converse).
    if (!is_on_manifold && !invariance.is_whole()) {
      auto quotient = cells_modulo<D>(table, whole, *cells, invariance.index());
      if (!quotient) {
        result_.variance = find_variance(*cells);
      } else if (result_.cycle = find_cycle(*quotient); !result_.cycle) {
        result_.cells = *std::move(quotient);
        return;
      }
    } else if (result_.cycle = find_cycle(*cells); !result_.cycle) {
      result_.cells = *std::move(cells);
      return;
    } else if (!invariance.is_whole()) {
      cells = CellList<D>(unfold<D>(table, whole, invariance, cells->listed()));
    }
    ensure(!result_.switched_after.has_value(), "Corollary 9: no loop or 2-cycle after the switch");
    const std::vector<CellPoints<D>> listed = cells->listed();
    result_.cover = options_.smallest_cover
                        ? smallest_cover_without(group_.frame(),
                                                 vectors(cycle_translations<D>(table, invariance, listed)))
                        : group_.complete_orbit_cover();
    const auto is_simplicial = [&](const Subgroup& target) {
      return !has_short_cycle<D>(table, invariance, target, listed);
    };
    if (options_.smallest_cover)
      ensure(is_simplicial(Subgroup::sublattice(table, *result_.cover)),
             "the smallest cover is one without short cycles");
    else
      ensure(is_simplicial(group_.complete_orbit_subgroup()),
             "the complete-orbit cover is simplicial for every point set");
    result_.cells = *std::move(cells);
  }

  /// What else the complex holds is freed when this returns.
  static CellList<D> released_cells(QuotientComplex<D> complex) { return std::move(complex).release_cells(); }

  /// The translations and their opposites.
  static std::vector<Vector> vectors(const std::vector<Element>& translations) {
    std::vector<Vector> result;
    for (const Element& t : translations) {
      Vector v(D);
      for (int i = 0; i < D; ++i) v[i] = static_cast<long>(t.t[static_cast<std::size_t>(i)]);
      result.push_back(v);
      result.push_back(-v);
    }
    return result;
  }

  /// Corollary 9: no loop or 2-cycle if the largest empty ball's diameter is below delta/2. Among few cells
  /// they are looked for all the same: it costs little, and a wrong threshold cannot stay unnoticed.
  std::optional<ShortCycle> find_cycle(const CellList<D>& cells) {
    constexpr std::size_t kFewCells = 2000;
    const bool has_none = !circumradius_.has_large(result_.widest);
    if (has_none && cells.size() > kFewCells) return std::nullopt;
    const std::optional<ShortCycle> cycle = find_short_cycle<D>(group_.table(), cells.listed());
    ensure(!has_none || !cycle, "Corollary 9: no loop or 2-cycle where all empty balls are small");
    return cycle;
  }

  typename FrameTriangulation<D>::Variance find_variance(const CellList<D>& cells) {
    const Subgroup& subgroup = group_.order().invariance_group();
    const Element a = subgroup.representative(1);
    for (const CellPoints<D>& cell : cells) {
      const auto image =
          canonical_face<D + 1>(group_.table(), subgroup, moved<D + 1>(group_.table(), a, cell)).key;
      if (!cells.has(image)) return {cell, a};
    }
    throw InternalError("a set of cells that is not invariant has a cell without its image");
  }

  const PreparedGroup& group_;
  std::vector<Site> sites_;
  Predicates<D> predicates_;
  Circumradius<D> circumradius_;
  TriangulationOptions options_;
  FrameTriangulation<D> result_;
};

}  // namespace

template <int D>
Rational empty_diameter_squared(const FrameTriangulation<D>& answer, const PreparedGroup& group) {
  ExactPredicates<D> exact(group.predicate_constants<D>().integral, group.table(), answer.sites);
  return squared_diameter<D>(answer.widest.cells, exact);
}

template Rational empty_diameter_squared<2>(const FrameTriangulation<2>&, const PreparedGroup&);
template Rational empty_diameter_squared<3>(const FrameTriangulation<3>&, const PreparedGroup&);

template <int D>
FrameTriangulation<D> triangulate_in_frame(const std::vector<Vector>& points, const PreparedGroup& group,
                                           const TriangulationOptions& options) {
  return Run<D>(make_sites(group.frame(), group.site_maps(), points), group, options)();
}

template <int D>
FrameTriangulation<D> triangulate_in_frame(std::vector<Vector>&& points, const PreparedGroup& group,
                                           const TriangulationOptions& options) {
  std::vector<Site> sites = make_sites(group.frame(), group.site_maps(), points);
  std::vector<Vector>().swap(points);
  return Run<D>(std::move(sites), group, options)();
}

template FrameTriangulation<2> triangulate_in_frame<2>(const std::vector<Vector>&, const PreparedGroup&,
                                                       const TriangulationOptions&);
template FrameTriangulation<3> triangulate_in_frame<3>(const std::vector<Vector>&, const PreparedGroup&,
                                                       const TriangulationOptions&);
template FrameTriangulation<2> triangulate_in_frame<2>(std::vector<Vector>&&, const PreparedGroup&,
                                                       const TriangulationOptions&);
template FrameTriangulation<3> triangulate_in_frame<3>(std::vector<Vector>&&, const PreparedGroup&,
                                                       const TriangulationOptions&);

}  // namespace flatdt::ref
