// All manifolds, on random points: the gift-wrapped triangulation is accepted, in the manifold itself or in a
// covering by a sublattice or by a subgroup that need not be normal; every edit of it is refuted.
#include "gift_wrap.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "build.hpp"
#include "linear.hpp"
#include "subgroup.hpp"

namespace flatdt::checker::test {
namespace {

/// A manifold with a metric generic enough for random points to have no ties.
struct Named {
  const char* name;
  int dimension;
  const char* metric;
};
const Named kAll[] = {{"torus", 2, " metric 10 3 7"},
                      {"klein-bottle", 2, " metric 10 0 90"},
                      {"torocosm", 3, " metric 10 3 2 11 4 13"},
                      {"dicosm", 3, " metric 10 3 0 11 0 9"},
                      {"tricosm", 3, ""},
                      {"P32", 3, ""},
                      {"tetracosm", 3, ""},
                      {"P43", 3, ""},
                      {"hexacosm", 3, ""},
                      {"P65", 3, ""},
                      {"didicosm", 3, " metric 10 0 0 11 0 13"},
                      {"first-amphicosm", 3, " metric 10 0 3 11 0 13"},
                      {"second-amphicosm", 3, " metric 10 3 2 10 2 13"},
                      {"first-amphidicosm", 3, " metric 10 0 0 11 0 13"},
                      {"second-amphidicosm", 3, " metric 10 0 0 11 0 13"}};

constexpr long kDenominator = 12 * 61;  // the groups' translations have denominators 2, 3, 4, 6

struct Sample {
  std::string instance;
  Instance parsed;
  Group group;
  std::vector<std::vector<std::pair<std::size_t, Element>>> cells;  // modulo G
};

/// The catalogue's lattice is Z^d, so its lattice coordinates are the file's.
Sample make_sample(const Named& m, std::size_t n, std::mt19937& random) {
  const int d = m.dimension;
  for (int tries = 0; tries < 50; ++tries) {
    std::vector<std::array<long, 3>> points(n);
    std::string text = "flatdt-instance 1 dimension " + std::to_string(d) + " manifold " + m.name + m.metric +
                       " points " + std::to_string(n) + " ";
    for (auto& p : points) {
      for (std::size_t i = 0; i < static_cast<std::size_t>(d); ++i) {
        p[i] = static_cast<long>(random() % kDenominator);
        text += std::to_string(p[i]) + "/" + std::to_string(kDenominator) + " ";
      }
    }
    Instance parsed = read_instance(text);
    Group group = make_group(std::get<Crystal>(close_group(d, parsed.generators, &parsed.metric)));
    EXPECT_EQ(group.basis, identity<Rational>(d));
    try {
      auto cells = GiftWrap(group, parsed.metric, points, kDenominator).cells();
      return {text, std::move(parsed), std::move(group), std::move(cells)};
    } catch (const Tie&) {
      continue;
    }
  }
  throw std::logic_error(std::string("no generic points found in ") + m.name);
}

std::vector<Element> coset_representatives(const Group& group, const Subgroup& subgroup) {
  ElementTable table(group);
  std::vector<ElementId> found = {subgroup.locate(table, kIdentity).representative};
  std::vector<Element> steps;
  for (std::size_t r = 0; r < group.order(); ++r) steps.push_back({static_cast<std::uint8_t>(r), {}});
  for (std::size_t i = 0; i < static_cast<std::size_t>(group.dimension); ++i) {
    Element e;
    e.shift[i] = 1;
    steps.push_back(e);
  }
  for (std::size_t k = 0; k < found.size(); ++k) {
    for (const Element& s : steps) {
      const ElementId next = subgroup.locate(table, table.product(found[k], table.intern(s))).representative;
      if (std::find(found.begin(), found.end(), next) == found.end()) found.push_back(next);
    }
  }
  std::vector<Element> elements;
  for (const ElementId id : found) elements.push_back(table[id]);
  return elements;
}

/// The H-orbits of cells, each moved by a random element of H's generators now and then.
TriangulationText covering(const Sample& sample, const std::vector<Element>& generators) {
  const Group& group = sample.group;
  TriangulationText t;
  std::vector<Seitz> seitz;
  for (const Element& g : generators) {
    seitz.push_back(group.outer_seitz(g));
    t.subgroup.push_back(seitz_text(group.dimension, seitz.back()));
  }
  const auto made = Subgroup::make(group, generators.empty() ? nullptr : &seitz);
  const std::vector<Element> cosets = coset_representatives(group, std::get<Subgroup>(made));
  EXPECT_EQ(std::get<Subgroup>(made).index(), static_cast<unsigned long>(cosets.size()));
  std::size_t number = 0;
  for (const Element& coset : cosets) {
    for (const auto& cell : sample.cells) {
      Element mover = coset;
      if (!generators.empty()) mover = group.multiply(generators[number++ % generators.size()], coset);
      auto& out = t.cells.emplace_back();
      for (const auto& [point, element] : cell) {
        out.emplace_back(point,
                         seitz_text(group.dimension, group.outer_seitz(group.multiply(mover, element))));
      }
    }
  }
  return t;
}

std::vector<Element> sublattice(int d, long k) {
  std::vector<Element> generators(static_cast<std::size_t>(d));
  for (std::size_t i = 0; i < generators.size(); ++i) generators[i].shift[i] = k;
  return generators;
}

/// Everything that must hold for a tiling, whatever the 1-skeleton is.
void expect_tiling(const Verdict& v, const std::string& what) {
  const std::string s = statuses(v);
  EXPECT_EQ(s.substr(0, 12), "hhh h hhhhhh") << what << v.reason;
  EXPECT_EQ(s.substr(s.size() - 6), "h hhhh") << what << v.reason;
  EXPECT_TRUE(v.outcome == Outcome::verified || v.outcome == Outcome::refuted) << what << v.reason;
}

TEST(GiftWrap, AllManifolds) {
  std::mt19937 random(2024);
  int verified = 0;
  int refuted = 0;
  for (const Named& m : kAll) {
    for (const std::size_t n :
         m.dimension == 2 ? std::vector<std::size_t>{1, 2, 4, 12, 20} : std::vector<std::size_t>{1, 2}) {
      const Sample sample = make_sample(m, n, random);
      const std::string what = std::string(m.name) + " " + std::to_string(n) + " ";
      const Verdict base = judge(sample.instance, covering(sample, {}).str());
      expect_tiling(base, what);
      (base.outcome == Outcome::verified ? verified : refuted)++;
      if (n > 2) continue;
      const Verdict cover = judge(sample.instance, covering(sample, sublattice(m.dimension, 3)).str());
      EXPECT_EQ(statuses(cover), "hhh h hhhhhh hhhh h hhhh") << what << cover.reason;
      EXPECT_EQ(cover.outcome, Outcome::verified) << what;
    }
  }
  EXPECT_GT(verified, 0);
  EXPECT_GT(refuted, 20);  // few points: loops and double edges nearly always
}

TEST(GiftWrap, SubgroupsWithRotationsAndReflections) {
  std::mt19937 random(77);
  for (const Named& m : kAll) {
    const Sample sample = make_sample(m, 1, random);
    for (std::size_t r = 1; r < sample.group.order(); ++r) {
      std::vector<Element> generators = sublattice(m.dimension, 3);
      Element g{static_cast<std::uint8_t>(r), {}};
      for (std::size_t i = 0; i < static_cast<std::size_t>(m.dimension); ++i)
        g.shift[i] = static_cast<long>(random() % 5);
      generators.push_back(g);
      expect_tiling(judge(sample.instance, covering(sample, generators).str()), m.name);
    }
  }
}

TEST(GiftWrap, ManyPointsOnTheManifoldItself) {
  std::mt19937 random(5);
  for (const Named& m : {kAll[0], kAll[1]}) {
    const Sample sample = make_sample(m, 40, random);
    EXPECT_EQ(judge(sample.instance, covering(sample, {}).str()).outcome, Outcome::verified) << m.name;
  }
}

// The points are generic, so there is one Delaunay triangulation: whatever an edit makes of it must not be
// verified.
TEST(GiftWrap, EveryEditIsRefuted) {
  std::mt19937 random(31);
  std::map<int, int> refuted;
  for (const Named& m : {kAll[0], kAll[1], kAll[3], kAll[10], kAll[13]}) {
    const Sample sample = make_sample(m, 2, random);
    const TriangulationText good = covering(sample, sublattice(m.dimension, 3));
    for (int round = 0; round < 18; ++round) {
      TriangulationText t = good;
      auto& cell = t.cells[random() % t.cells.size()];
      auto& vertex = cell[random() % cell.size()];
      const int edit = round % 6;
      if (edit == 0) cell = t.cells[random() % t.cells.size()];
      if (edit == 1) t.cells.push_back(cell);
      if (edit == 2) t.cells.erase(t.cells.begin() + static_cast<std::ptrdiff_t>(random() % t.cells.size()));
      if (edit == 3) vertex.first = 1 - vertex.first;
      if (edit == 4) vertex.second = t.cells[random() % t.cells.size()][0].second;
      if (edit == 5)
        t.subgroup[0] = seitz_text(m.dimension, sample.group.outer_seitz(sublattice(m.dimension, 6)[0]));
      if (t.str() == good.str()) continue;
      const Verdict v = judge(sample.instance, t.str());
      EXPECT_EQ(v.outcome, Outcome::refuted) << m.name << " edit " << edit << ' ' << statuses(v) << v.reason;
      ++refuted[edit];
    }
  }
  EXPECT_EQ(refuted.size(), 6U);
}

}  // namespace
}  // namespace flatdt::checker::test
