/// The grammar of `flatdt-instance 1` (FORMAT), section by section.
#include "flatdt/ref/instance_format.hpp"

#include <gtest/gtest.h>

#include "flatdt/ref/catalogue.hpp"
#include "flatdt/ref/errors.hpp"

namespace flatdt::ref {
namespace {

Instance parsed(const std::string& text) {
  return parse_instance(text, "t");
}

std::string reason(const std::string& text) {
  try {
    parsed(text);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "accepted";
}

void expect_equal(const Instance& a, const Instance& b) {
  EXPECT_EQ(a.dimension, b.dimension);
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.generators, b.generators);
  EXPECT_EQ(a.generators_given, b.generators_given);
  EXPECT_EQ(a.gram, b.gram);
  EXPECT_EQ(a.points, b.points);
}

constexpr const char* kExample = R"(flatdt-instance 1
dimension 2
manifold klein-bottle          # a name
generators 2
  1 0 1    0 1 0               # a translation
  -1 0 0   0 1 1/2             # a glide reflection
metric 1 0 1
points 2
  1/10 1/5
  0.75 0x1.8p-2
)";

TEST(InstanceFormat, ReadsTheExampleOfTheFormat) {
  const Instance instance = parsed(kExample);
  EXPECT_EQ(instance.dimension, 2);
  EXPECT_EQ(instance.name, "klein-bottle");
  EXPECT_TRUE(instance.generators_given);
  ASSERT_EQ(instance.generators.size(), 2U);
  EXPECT_EQ(instance.generators[1].to_string(), "-1 0 0 0 1 1/2");
  EXPECT_TRUE(instance.gram.is_identity());
  ASSERT_EQ(instance.points.size(), 2U);
  EXPECT_EQ(instance.points[1].to_string(), "3/4 3/8");
}

TEST(InstanceFormat, LineBreaksMeanNothing) {
  std::string one_line;
  bool comment = false;
  for (const char* c = kExample; *c != '\0'; ++c) {
    comment = *c != '\n' && (comment || *c == '#');
    if (!comment) one_line += *c == '\n' ? '\f' : *c;
  }
  expect_equal(parsed(one_line), parsed(kExample));
}

TEST(InstanceFormat, TheDimensionIsACount) {
  EXPECT_EQ(parsed("flatdt-instance 1 dimension 02 manifold p1 points 01 0 0 ").dimension, 2);
}

TEST(InstanceFormat, SectionsRememberTheirLines) {
  const Instance instance = parsed(kExample);
  EXPECT_EQ(instance.lines.manifold, 3);
  EXPECT_EQ(instance.lines.generators, 4);
  EXPECT_EQ(instance.lines.metric, 7);
  EXPECT_EQ(parsed("flatdt-instance 1 dimension 2 manifold p1 points 1 0 0 ").lines.metric, 0);
}

TEST(InstanceFormat, ANameMeansItsGenerators) {
  for (const CatalogueEntry& entry : catalogue()) {
    std::vector<std::string> names = entry.aliases;
    names.push_back(entry.name);
    for (const std::string& name : names) {
      const std::string zeros = entry.dimension == 2 ? "0 0" : "0 0 0";
      const Instance instance = parsed("flatdt-instance 1 dimension " + std::to_string(entry.dimension) +
                                       " manifold " + name + " points 1 " + zeros + "\n");
      const bool mirror = name == "P32" || name == "P43" || name == "P65";
      EXPECT_EQ(instance.generators, mirror ? entry.mirror_image_generators : entry.generators) << name;
      EXPECT_EQ(instance.gram, entry.canonical_gram);
      EXPECT_FALSE(instance.generators_given);
      EXPECT_EQ(instance.name, name);
    }
  }
}

TEST(InstanceFormat, TheMetricDefaultsToTheIdentityBesideGenerators) {
  const std::string generators = "generators 1 1 0 0 1  0 1 0 0  0 0 1 0 ";
  const Instance claimed =
      parsed("flatdt-instance 1 dimension 3 manifold tricosm " + generators + "points 1 0 0 0 ");
  EXPECT_TRUE(claimed.gram.is_identity());
  const Instance named = parsed("flatdt-instance 1 dimension 3 manifold tricosm points 1 0 0 0 ");
  EXPECT_EQ(named.gram.to_string(), "1 -1/2 0 -1/2 1 0 0 0 1");
  const Instance given =
      parsed("flatdt-instance 1 dimension 3 manifold P1 metric 1 2 3 4 5 6 points 1 0 0 0 ");
  EXPECT_EQ(given.gram.to_string(), "1 2 3 2 4 5 3 5 6");  // the analysis refuses it, not the grammar
}

TEST(InstanceFormat, WhatIsWrittenIsReadBack) {
  const std::string named = "flatdt-instance 1 dimension 3 manifold P65 points 2 1/3 -2 0.125 1e3 0 0x1p-3 ";
  for (const std::string& text : {std::string(kExample), named}) {
    const Instance instance = parsed(text);
    const std::string written = write_instance(instance);
    expect_equal(parsed(written), instance);
    EXPECT_EQ(write_instance(parsed(written)), written);
  }
  EXPECT_EQ(write_instance(parsed(named)),
            "flatdt-instance 1\ndimension 3\nmanifold P65\nmetric 1 -1/2 0 1 0 1\npoints 2\n  1/3 -2 1/8\n  "
            "1000 0 1/8\n");
}

TEST(InstanceFormat, RefusesWhatTheGrammarDoesNotSay) {
  const std::string head = "flatdt-instance 1\ndimension 2\n";
  const std::string torus = head + "manifold torus\n";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "t:1: the file ends where \"flatdt-instance\" must stand"},
      {"flatdt-instance 2 ", "t:1: \"2\" stands where \"1\" must stand"},
      {"flatdt-triangulation 1 ",
       "t:1: \"flatdt-triangulation\" stands where \"flatdt-instance\" must stand"},
      {"Flatdt-instance 1 ", "t:1: \"Flatdt-instance\" stands where \"flatdt-instance\" must stand"},
      {"flatdt-instance 1 dimension 4 ", "t:1: the dimension: \"4\" is beyond the limit of 3"},
      {"flatdt-instance 1 dimension 1 ", "t:1: the dimension must be 2 or 3"},
      {head + "points 1 0 0 ", "t:3: a \"manifold\" or a \"generators\" section must follow the dimension"},
      {head + "manifold Torus points 1 0 0 ",
       "t:3: no manifold is called \"Torus\": `flatdt manifolds` lists the names"},
      {head + "manifold P1 points 1 0 0 ", "t:3: P1 has dimension 3, the file says 2"},
      {head + "manifold torus manifold torus points 1 0 0 ",
       "t:3: \"manifold\" stands where \"points\" must stand"},
      {head + "generators 0 points 1 0 0 ", "t:3: there must be at least one generator"},
      {head + "generators 10001 ", "t:3: the number of generators: \"10001\" is beyond the limit of 10000"},
      {head + "generators 1 1 0 0 0 1 points 1 0 0 ",
       "t:3: generator 0: \"points\" is not a number: write a number like 3/4, -0.75, 75e-2 or 0x1.8p-1"},
      {torus + "generators 1 1 0 1 0 1 0 generators 1 1 0 1 0 1 0 points 1 0 0 ",
       "t:4: \"generators\" stands where \"points\" must stand"},
      {torus + "metric 1 0 1 metric 1 0 1 points 1 0 0 ",
       "t:4: \"metric\" stands where \"points\" must stand"},
      {torus + "metric 1 0 0 1 points 1 0 0 ", "t:4: \"1\" stands where \"points\" must stand"},
      {torus + "points 1 0 0 metric 1 0 1 ", "t:4: \"metric\" stands after the last point"},
      {torus + "points 0 ", "t:4: there must be at least one point"},
      {torus + "points -1 ", "t:4: the number of points: \"-1\" is not a number of digits 0 to 9 only"},
      {torus + "points 100000001 0 0 ",
       "t:4: the number of points: \"100000001\" is beyond the limit of 100000000"},
      {torus + "points 100000000 0 0 ", "t:4: the file ends where a point must stand"},
      {torus + "points 1 0 ", "t:4: the file ends where a point must stand"},
      {torus + "points 1 0 0",
       "t:4: the file ends directly after \"0\", so it may have been cut short: end it with a line break"},
      {torus + "points 1 0 0 0 ", "t:4: \"0\" stands after the last point"},
      {torus + "points\n1\n0\n1/0\n",
       "t:7: a point: \"1/0\" has denominator 0: a denominator must not be zero"},
      {torus, "t:4: the file ends where \"points\" must stand"},
  };
  for (const auto& [text, message] : cases) EXPECT_EQ(reason(text), message) << text;
  EXPECT_EQ(reason(torus + "points 1 0 0 "), "accepted");
}

TEST(InstanceFormat, EveryProperPrefixOfAFileIsRefused) {
  const std::string text = kExample;
  for (std::size_t size = 0; size + 1 < text.size(); ++size)
    EXPECT_NE(reason(text.substr(0, size)), "accepted") << size;
  EXPECT_EQ(reason(text), "accepted");
}

}  // namespace
}  // namespace flatdt::ref
