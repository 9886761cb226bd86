/// The generators: what they promise, and that a failing property ends in a small readable file.
#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "flatdt/ref/group_analysis.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "for_all.hpp"
#include "judge.hpp"
#include "metrics.hpp"
#include "quotient.hpp"
#include "rapidcheck_generators.hpp"
#include "require.hpp"
#include "simplify.hpp"

namespace flatdt::property_tests {
namespace {

using testing::draw_specimen;
using testing::Naming;
using testing::simpler;
using testing::weight;

Domain everything() {
  Domain domain = domain_of(testing::all_manifolds());
  domain.max_points_in_space = 8;
  return domain;
}

std::string text_of(const Specimen& s) {
  std::ostringstream out;
  out << s;
  return out.str();
}

TEST(Generators, SpecimensAreAdmissibleAndVisitEverything) {
  const Domain domain = everything();
  std::map<std::string, int> manifolds, rules, traits;
  for (std::uint64_t seed = 0; seed < 800; ++seed) {
    const Specimen s = draw_specimen(domain, seed, static_cast<int>(seed % 101));
    const ref::Instance instance = instance_of(s);
    const ref::GroupAnalysis analysis = ref::analyse(instance);
    ASSERT_EQ(analysis.entry, s.entry) << s;
    if (!s.entry->mirror_image_generators.empty()) {
      // A change of coordinates that reverses orientation turns a hand into the other.
      const bool reversed = s.coordinates.linear.determinant().sign() == ref::Sign::negative;
      ASSERT_EQ(analysis.frame.mirrored, s.mirrored != reversed) << s;
    }
    ASSERT_LE(static_cast<long>(s.points.size()), domain.max_points(s.dimension()));
    ++manifolds[name_of(s)];
    ++rules[s.family];
    traits["name only"] += !instance.generators_given;
    traits["generators only"] += !instance.name;
    traits["claim and generators"] += instance.name && instance.generators_given;
    traits["alias"] += instance.name && *instance.name != name_of(s);
    traits["other origin"] += !s.coordinates.translation.is_zero();
    traits["rational basis"] += !s.coordinates.linear.is_integral();
    traits["unimodular basis"] += !s.coordinates.linear.is_identity() && s.coordinates.linear.is_integral();
    traits["other generators"] += s.generators != catalogue_generators(s);
    traits["canonical metric"] += s.gram == s.entry->canonical_gram;
    traits["other metric"] += s.gram != s.entry->canonical_gram;
    const Quotient quotient(s);
    std::set<Vector> orbits;
    bool far = false;
    for (const Vector& x : s.points) {
      orbits.insert(quotient.canonical(x).point);
      for (int i = 0; i < s.dimension(); ++i) far = far || x[i] < Rational(0) || x[i] >= Rational(1);
    }
    traits["repeated orbits"] += orbits.size() < s.points.size();
    traits["outside the cell"] += far;
  }
  for (const std::string& name : testing::all_manifolds()) EXPECT_GT(manifolds[name], 20) << name;
  for (const std::string& rule : testing::point_rules()) EXPECT_GT(rules[rule], 20) << rule;
  for (const auto& [trait, count] : traits) EXPECT_GT(count, 40) << trait;
}

TEST(Generators, DegeneraciesAreVisited) {
  int ties = 0, generic = 0;
  Domain domain = domain_of(testing::manifolds_of_the_plane());
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Specimen s = draw_specimen(domain, seed, static_cast<int>(seed));
    const ref::Instance instance = instance_of(s);
    const Quotient quotient(s);
    const auto cells = corners_of(instance, triangulate(instance).triangulation, s.coordinates);
    ++(has_ties(tessellate(quotient, s.gram, fold(quotient, cells)), 2) ? ties : generic);
  }
  EXPECT_GT(ties, 20);
  EXPECT_GT(generic, 20);
}

TEST(Generators, APrintedSpecimenIsReadBack) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Specimen s = draw_specimen(everything(), seed, 50);
    const std::string text = text_of(s);
    const Specimen read = testing::read_specimen(text, "specimen");
    ASSERT_EQ(write_instance(instance_of(read)), write_instance(instance_of(s)));
    ASSERT_EQ(read.choice, s.choice);
    ASSERT_EQ(text_of(draw_specimen(everything(), seed, 50)), text);
  }
}

TEST(Generators, SimplerSpecimensAreLighterAndAdmissible) {
  const Domain domain = everything();
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const Specimen s = draw_specimen(domain, seed, 30);
    for (const Specimen& t : simpler(s, domain)) {
      ASSERT_LT(weight(t, domain), weight(s, domain));
      ASSERT_TRUE(testing::is_admissible(t.gram, testing::cosets_of(catalogue_generators(t)))) << t;
      ASSERT_FALSE(t.points.empty());
    }
  }
}

/// Greedy simplification, as RapidCheck does it.
template <class Fails>
Specimen simplest(Specimen s, const Domain& domain, const Fails& fails) {
  for (bool shrunk = true; shrunk;) {  // weights decrease and are well-ordered
    shrunk = false;
    for (const Specimen& t : simpler(s, domain)) {
      if (!fails(t)) continue;
      s = t;
      shrunk = true;
      break;
    }
  }
  return s;
}

TEST(Generators, ShrinkingEndsInFewPointsWithShortNumbers) {
  const Domain domain = everything();
  const auto three_points_of_a_screw = [](const Specimen& s) {
    return s.points.size() >= 3 && s.entry->holonomy_order > 1 && s.dimension() == 3 &&
           s.points[0][0] > Rational(ref::Integer(1), ref::Integer(3));
  };
  int tried = 0;
  for (std::uint64_t seed = 0; seed < 80; ++seed) {
    const Specimen s = draw_specimen(domain, seed, 100);
    if (!three_points_of_a_screw(s)) continue;
    ++tried;
    const Specimen end = simplest(s, domain, three_points_of_a_screw);
    EXPECT_EQ(write_instance(instance_of(end)),
              "flatdt-instance 1\ndimension 3\nmanifold dicosm\nmetric 1 0 0 1 0 1\npoints 3\n"
              "  1 0 0\n  0 0 0\n  0 0 0\n")
        << "from " << s;
  }
  EXPECT_GT(tried, 10);
}

/// A property that is false for two points of the Klein bottle, to see a failure from end to end.
void false_on_two_points(const Specimen& s) {
  require(s.points.size() < 2 || s.entry->orientable, "two points of a surface with one side");
}

TEST(Generators, AFailureIsShrunkPrintedAndKept) {
  if (std::getenv("FLATDT_INSTANCE") != nullptr) GTEST_SKIP() << "one instance was asked for";
  EXPECT_NONFATAL_FAILURE(for_all({50, plane()}, false_on_two_points), "two points of a surface");
  const char* directory = std::getenv("FLATDT_COUNTEREXAMPLES");
  const std::filesystem::path kept = std::filesystem::path(directory == nullptr ? "." : directory) /
                                     "property-Generators.AFailureIsShrunkPrintedAndKept.instance";
  std::ifstream in(kept);
  std::ostringstream text;
  text << in.rdbuf();
  EXPECT_EQ(write_instance(ref::parse_instance(text.str(), kept.string())),
            "flatdt-instance 1\ndimension 2\nmanifold klein-bottle\nmetric 1 0 1\npoints 2\n  0 0\n  0 0\n");
  in.close();
  std::filesystem::remove(kept);
}

TEST(Generators, GroupsMetricsAndPointSetsAreSectionsOfAdmissibleInstances) {
  for (int seed = 0; seed < 40; ++seed) {
    const auto random = [&] { return rc::Random(static_cast<std::uint64_t>(seed)); };
    const testing::Group group = testing::groups(everything())(random(), 50).value();
    std::ostringstream text;
    text << "flatdt-instance 1\n"
         << group << "points 1\n " << ref::Vector(group.gram.dimension()).to_string();
    const ref::Instance instance = ref::parse_instance(text.str() + "\n", "group");
    ASSERT_EQ(ref::analyse(instance).entry, ref::find_entry(group.manifold)) << text.str();
    ASSERT_EQ(instance.gram, group.gram);

    std::ostringstream sections;
    const auto points = testing::point_sets("G4", 7)(random(), 100).value();
    sections << "flatdt-instance 1\ndimension 3\nmanifold G4\n"
             << testing::metrics("G4", 3)(random(), 50).value() << points;
    const ref::Instance whole = ref::parse_instance(sections.str(), "sections");
    ASSERT_EQ(ref::analyse(whole).entry->name, "tetracosm");
    ASSERT_EQ(whole.points, points.points);
    ASSERT_LE(points.points.size(), 7U);
  }
  EXPECT_THROW(testing::metrics("no-such-manifold"), std::invalid_argument);
  EXPECT_THROW(testing::point_sets("no-such-manifold", 3), std::invalid_argument);
}

TEST(Generators, TriangulatedSpecimensPrintBothFiles) {
  const auto drawn = testing::triangulated_specimens(plane())(rc::Random(1), 10).value();
  std::ostringstream out;
  out << drawn;
  const std::size_t cut = out.str().find("# triangulation\n");
  ASSERT_NE(cut, std::string::npos);
  EXPECT_EQ(judge(out.str().substr(0, cut), out.str().substr(cut)).outcome, checker::Outcome::verified);
}

}  // namespace
}  // namespace flatdt::property_tests
