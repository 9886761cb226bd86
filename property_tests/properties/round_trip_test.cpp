/// Both formats through both parsers: what is written is read as the same data, and written again as the same
/// bytes; other spellings of the same numbers are the same data.
#include <gtest/gtest.h>

#include <sstream>

#include "flatdt/checker/input.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "for_all.hpp"
#include "judge.hpp"
#include "require.hpp"
#include "spelling.hpp"

namespace flatdt::property_tests {
namespace {

using ref::Isometry;
using ref::Matrix;
using ref::Rational;
using ref::Vector;

bool same(const Vector& a, const checker::Vec<checker::Rational>& b) {
  for (int i = 0; i < a.dimension(); ++i)
    if (a[i].mpq() != b[static_cast<std::size_t>(i)]) return false;
  return true;
}

bool same(const Matrix& a, const checker::Mat<checker::Rational>& b) {
  for (int i = 0; i < a.dimension(); ++i)
    for (int j = 0; j < a.dimension(); ++j)
      if (a(i, j).mpq() != b[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]) return false;
  return true;
}

template <class A, class B, class Equal>
bool same_lists(const std::vector<A>& a, const std::vector<B>& b, const Equal& equal) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!equal(a[i], b[i])) return false;
  return true;
}

bool same_isometry(const Isometry& a, const checker::Seitz& b) {
  return same(a.linear, b.linear) && same(a.translation, b.translation);
}

void require_same(const Specimen& s, const ref::Instance& instance, const checker::Instance& parsed) {
  require(parsed.dimension == instance.dimension, "the checker reads another dimension");
  require(parsed.claim.has_value() == instance.name.has_value(), "the checker reads another claim");
  require(!parsed.claim || *parsed.claim == s.entry->name, "the checker reads another name");
  require(same_lists(instance.generators, parsed.generators, same_isometry),
          "the checker reads other generators");
  require(same(instance.gram, parsed.metric), "the checker reads another metric");
  require(same_lists(instance.points, parsed.points, [](const auto& a, const auto& b) { return same(a, b); }),
          "the checker reads other points");
}

void require_same(const ref::Instance& a, const ref::Instance& b) {
  require(a.dimension == b.dimension && a.name == b.name && a.generators_given == b.generators_given &&
              a.generators == b.generators && a.gram == b.gram && a.points == b.points,
          "the reference reads something else than it wrote");
}

checker::Instance checker_parses(const std::string& text) {
  std::istringstream in(text);
  return checker::parse_instance(in, "instance");
}

void instances(const Specimen& s) {
  const ref::Instance instance = instance_of(s);
  const std::string text = write_instance(instance);
  const ref::Instance parsed = ref::parse_instance(text, "instance");
  require_same(instance, parsed);
  require(write_instance(parsed) == text, "write(parse(write(x))) differs from write(x)");
  require_same(s, instance, checker_parses(text));
}

void spellings(const Specimen& s) {
  const ref::Instance instance = instance_of(s);
  const std::string text = respell(write_instance(instance), s.choice);
  require_same(instance, ref::parse_instance(text, "instance"));
  require_same(s, instance, checker_parses(text));
}

void triangulations(const Specimen& s) {
  const ref::Instance instance = instance_of(s);
  const auto result = triangulate(instance);
  const ref::Triangulation& t = result.triangulation;
  const checker::Instance checker_instance = checker_parses(write_instance(instance));
  const std::string text = write_triangulation(t, describe(result));
  for (const std::string& spelled : {text, respell(text, s.choice)}) {
    const ref::Triangulation parsed =
        ref::parse_triangulation(spelled, "triangulation", s.dimension(), instance.points.size());
    require(write_triangulation(parsed, describe(result)) == text,
            "write(parse(write(x))) differs from write(x)");
    std::istringstream in(spelled);
    const checker::Triangulation read = checker::parse_triangulation(in, "triangulation", checker_instance);
    require(read.subgroup.has_value() == t.has_subgroup, "the checker reads another kind of space");
    require(!t.has_subgroup || same_lists(t.subgroup, *read.subgroup, same_isometry),
            "the checker reads another subgroup");
    require(read.elements.size() == t.elements.size(), "the checker reads another number of elements");
    for (std::size_t k = 0; k < t.elements.size(); ++k)
      require(same_isometry(t.elements[k], read.element(k)), "the checker reads another element");
    require(same_lists(t.cells, read.cells,
                       [&](const auto& a, const auto& b) {
                         for (std::size_t k = 0; k <= static_cast<std::size_t>(t.dimension); ++k)
                           if (a[k].point != b[k].point || a[k].element != b[k].element) return false;
                         return true;
                       }),
            "the checker reads other cells");
  }
}

Domain everything() {
  Domain domain = domain_of(testing::all_manifolds());
  domain.max_points_in_space = 12;
  return domain;
}

TEST(RoundTrip, Instances) {
  for_all({400, everything()}, instances);
}
TEST(RoundTrip, OtherSpellingsOfInstances) {
  for_all({400, everything()}, spellings);
}
TEST(RoundTrip, TriangulationsOfThePlane) {
  for_all({100, plane()}, triangulations);
}
TEST(RoundTrip, TriangulationsOfSpace) {
  Domain domain = space();
  domain.max_points_in_space = 1;
  for_all({10, domain}, triangulations);
}

}  // namespace
}  // namespace flatdt::property_tests
