/// State-machine tests of incremental insertion: random sequences of insertions of copies and orbits,
/// locations and conversions. The model is the set of copies present. After each command the complex is
/// compared with the definitions, and judged by the checker as a triangulation of the copies present.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/state.h>

#include <algorithm>
#include <memory>

#include "checked.hpp"
#include "complex_audit.hpp"
#include "flatdt/ref/cover.hpp"
#include "flatdt/ref/first_orbit.hpp"
#include "insertion_model.hpp"
#include "random.hpp"
#include "rapidcheck_generators.hpp"
#include "require.hpp"

namespace flatdt::property_tests {
namespace {

using ref::OrbitPoint;
using ref::SiteId;

template <int D>
struct System {
  explicit System(const ref::Instance& instance)
      : engine(instance, ref::PredicateStages::filtered),
        sublattice(ref::one_at_a_time_cover(engine.analysis.frame, 20000)),
        level({&engine.analysis.frame, &engine.table, &engine.sites, &engine.order, &engine.predicates,
               &engine.circumradius},
              ref::Subgroup::sublattice(engine.table, sublattice)) {
    const SiteId first{0};
    level.start(first, ref::triangulate_first_orbit<D>(engine.analysis.frame, engine.table, engine.sites,
                                                       engine.order, engine.predicates, first));
  }

  [[nodiscard]] Model model() const {
    Model m;
    for (std::size_t i = 0; i < engine.sites.size(); ++i) m.present.emplace_back(level.copies(), i == 0);
    m.threshold = std::make_shared<Threshold>(engine.instance, engine.sites);
    return m;
  }

  /// The location of copy `rep`, by a walk from an image of the first site near it or far from it.
  [[nodiscard]] ref::Location locate(SiteId site, std::uint32_t rep, bool from_afar) {
    const ref::Element query = level.complex().subgroup().representative(rep);
    OrbitPoint near = level.start_near(engine.lift({site, query}));
    if (from_afar) near.g = engine.table.multiply(ref::Element{{3, -2, 0}, 0}, near.g);
    return level.locate(site, query, near);
  }

  void insert(std::size_t site, std::uint32_t rep, bool from_afar) {
    const SiteId id{static_cast<std::uint32_t>(site)};
    if (!level.complex().has_site(id)) level.add_site(id);
    level.insert(id, rep, locate(id, rep, from_afar));
  }

  void audit(const Model& after) const {
    require(level.is_on_manifold() == after.on_manifold, "the complex lives on another space");
    audit_complex<D>(engine, level, after.present,
                     after.on_manifold ? ref::Matrix::identity(D) : sublattice.basis);
  }

  Engine<D> engine;
  ref::Sublattice sublattice;
  ref::PeriodicDelaunay<D> level;
};

/// Uniform in [0, n), whatever the size that a sequence is drawn with.
template <class T>
rc::Gen<T> any_below(T n) {
  return rc::gen::resize(rc::kNominalSize, rc::gen::inRange<T>(0, n));
}

template <int D>
using Base = rc::state::Command<Model, System<D>>;

template <int D>
struct InsertCopy : Base<D> {
  std::size_t site = 0;
  std::uint32_t rep = 0;
  bool from_afar = *rc::gen::arbitrary<bool>();

  explicit InsertCopy(const Model& m) {
    RC_PRE(!m.on_manifold);
    const auto sites = m.incomplete_sites();
    RC_PRE(!sites.empty());
    site = *rc::gen::elementOf(sites);
    std::vector<std::uint32_t> missing;
    for (std::uint32_t r = 0; r < m.present[site].size(); ++r)
      if (!m.present[site][r]) missing.push_back(r);
    rep = *rc::gen::elementOf(missing);
  }
  void checkPreconditions(const Model& m) const override {
    RC_PRE(!m.on_manifold);
    RC_PRE(!m.present[site][rep]);
  }
  void apply(Model& m) const override { m.present[site][rep] = true; }
  void run(const Model& m, System<D>& system) const override {
    system.insert(site, rep, from_afar);
    system.audit(this->nextState(m));
  }
  void show(std::ostream& out) const override {
    out << "insert copy " << rep << " of site " << site << (from_afar ? " from afar" : "");
  }
};

/// The missing copies of some sites, orbit by orbit, each in a random order; on the manifold one copy.
template <int D>
struct InsertOrbits : Base<D> {
  std::size_t count = 0;
  std::uint64_t order = *any_below<std::uint64_t>(1000);

  explicit InsertOrbits(const Model& m) {
    RC_PRE(!m.incomplete_sites().empty());
    count = 1 + *any_below(m.incomplete_sites().size());
  }
  void checkPreconditions(const Model& m) const override { RC_PRE(!m.incomplete_sites().empty()); }
  [[nodiscard]] std::vector<std::size_t> sites(const Model& m) const {
    std::vector<std::size_t> chosen = m.incomplete_sites();
    testing::Random random(order);
    random.shuffle(chosen);
    chosen.resize(std::min(chosen.size(), count));
    return chosen;
  }
  void apply(Model& m) const override {
    for (const std::size_t site : sites(m)) m.present[site].assign(m.present[site].size(), true);
  }
  void run(const Model& m, System<D>& system) const override {
    testing::Random random(order);
    for (const std::size_t site : sites(m)) {
      std::vector<std::uint32_t> missing;
      for (std::uint32_t r = 0; r < (m.on_manifold ? 1 : m.present[site].size()); ++r)
        if (!m.present[site][r]) missing.push_back(r);
      random.shuffle(missing);
      for (const std::uint32_t rep : missing) system.insert(site, rep, false);
    }
    system.audit(this->nextState(m));
  }
  void show(std::ostream& out) const override {
    out << "insert up to " << count << " orbits, order " << order;
  }
};

template <int D>
struct Locate : Base<D> {
  std::size_t site = 0;
  bool from_afar = *rc::gen::arbitrary<bool>();

  explicit Locate(const Model& m) : site(*any_below(m.present.size())) {}
  void run(const Model&, System<D>& system) const override {
    const SiteId id{static_cast<std::uint32_t>(site)};
    require_in_closure<D>(system.engine, system.level, id, system.locate(id, 0, from_afar));
  }
  void show(std::ostream& out) const override {
    out << "locate site " << site << (from_afar ? " from afar" : "");
  }
};

/// The switch of Section 4.1, as soon as it is allowed or later.
template <int D>
struct Convert : Base<D> {
  explicit Convert(const Model& m) { RC_PRE(m.may_convert()); }
  void checkPreconditions(const Model& m) const override { RC_PRE(m.may_convert()); }
  void apply(Model& m) const override { m.on_manifold = true; }
  void run(const Model& m, System<D>& system) const override {
    require(system.level.large_cells() == 0, "Corollary 9 is satisfied, and L is not empty");
    system.level.convert_to_manifold();
    system.audit(this->nextState(m));
  }
  void show(std::ostream& out) const override { out << "convert to the manifold"; }
};

/// Runs sequences of at most `longest` + 1 commands; returns how many ended on the manifold.
template <int D>
int run_sequences(int cases, int longest, const testing::Domain& domain) {
  int on_manifold = 0;
  check_property(cases, [&] {
    const testing::Specimen specimen = *testing::specimens(domain).as("specimen");
    System<D> system(instance_of(specimen));
    const Model initial = system.model();
    system.audit(initial);
    const auto commands = *rc::gen::resize(
        longest,
        rc::state::gen::commands(
            initial,
            rc::state::gen::execOneOfWithArgs<InsertCopy<D>, InsertOrbits<D>, Locate<D>, Convert<D>>()));
    rc::state::runAll(commands, initial, system);
    if (system.level.is_on_manifold()) ++on_manifold;
  });
  return on_manifold;
}

testing::Domain torus_and_klein_bottle(long points) {
  testing::Domain domain;
  domain.manifolds = testing::manifolds_of_the_plane();
  domain.max_points_in_plane = points;
  domain.max_stretch_in_plane = 2;
  return domain;
}

TEST(InsertionStates, FewPointsOfThePlane) {
  run_sequences<2>(60, 10, torus_and_klein_bottle(6));
}

TEST(InsertionStates, SwitchInThePlane) {
  testing::Domain domain = torus_and_klein_bottle(60);
  domain.other_metrics = false;
  domain.rules = {"uniform", "grid", "lattice"};
  const int on_manifold = run_sequences<2>(60, 12, domain);
  EXPECT_GT(on_manifold, 2);
}

TEST(InsertionStates, Space) {
  testing::Domain domain;
  domain.manifolds = {"torocosm", "dicosm", "second-amphicosm", "didicosm"};
  domain.max_points_in_space = 3;
  run_sequences<3>(8, 5, domain);
}

}  // namespace
}  // namespace flatdt::property_tests
