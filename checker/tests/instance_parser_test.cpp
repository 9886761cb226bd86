// Instance files: every lexical rule and every section rule, in both directions.   Source: FORMAT.md.
#include <gtest/gtest.h>

#include <string>

#include "build.hpp"

namespace flatdt::checker::test {
namespace {

const std::string kHead = "flatdt-instance 1 dimension 2 ";
const std::string kTorus = kHead + "generators 2 1 0 1 0 1 0 1 0 0 0 1 1 ";

void expect_malformed(const std::string& text, const std::string& part_of_reason) {
  try {
    (void)read_instance(text);
    ADD_FAILURE() << "accepted: " << text.substr(0, 200);
  } catch (const MalformedInput& error) {
    EXPECT_NE(std::string(error.what()).find(part_of_reason), std::string::npos) << error.what();
  }
}

TEST(InstanceParser, ReadsTheExampleOfTheFormat) {
  const Instance instance = read_instance(
      "flatdt-instance 1\ndimension 2\nmanifold klein-bottle # a name\ngenerators 2\n 1 0 1    0 1 0 # a "
      "translation\n"
      "-1 0 0 0 1 1/2\nmetric 1 0 1\npoints 2\n1/10 1/5\n0.75 0x1.8p-2\n");
  EXPECT_EQ(instance.dimension, 2);
  EXPECT_EQ(instance.claim, "klein-bottle");
  ASSERT_EQ(instance.generators.size(), 2U);
  EXPECT_EQ(instance.generators[1].linear[0][0], -1);
  EXPECT_EQ(instance.generators[1].translation[1], Rational(1, 2));
  ASSERT_EQ(instance.points.size(), 2U);
  EXPECT_EQ(instance.points[1][0], Rational(3, 4));
  EXPECT_EQ(instance.points[1][1], Rational(3, 8));
}

TEST(InstanceParser, WhiteSpaceAndComments) {
  EXPECT_EQ(read_instance(kTorus + "points 1 0\t0\v\f\r\n").points.size(), 1U);
  EXPECT_EQ(read_instance(kTorus + "points#c\n1 0 0#the end").points.size(), 1U);  // a comment ends a token
  EXPECT_EQ(read_instance(kTorus + "points 1 0 0 # \x01\x80\xff\t last").points.size(), 1U);
  EXPECT_EQ(read_instance("# first\n#\n" + kTorus + "points 1 0 0\n").points.size(), 1U);
  expect_malformed(kTorus + "points 1 0 0", "ends directly after");
  expect_malformed(kTorus +
                       "points 1 0 \xc2\xa0"
                       "0\n",
                   "0xC2");
  expect_malformed("\xef\xbb\xbf" + kTorus + "points 1 0 0\n", "0xEF");
  expect_malformed(kTorus + "points 1 0 " + std::string(1, '\0') + " 0\n", "0x00");
  expect_malformed(kTorus + "points 1 0 \x7f 0\n", "0x7F");
}

TEST(InstanceParser, ErrorsNameFileAndLine) {
  try {
    (void)read_instance("flatdt-instance 1\n# comment\ndimension\n\n  4\n");
    FAIL();
  } catch (const MalformedInput& error) {
    EXPECT_EQ(std::string(error.what()), "instance:5: the dimension must be from 2 to 3, found '4'");
  }
}

TEST(InstanceParser, Header) {
  expect_malformed("", "expected 'flatdt-instance', found the end of the file");
  expect_malformed("# only a comment", "the end of the file");
  expect_malformed("flatdt-triangulation 1 ", "expected 'flatdt-instance'");
  expect_malformed("flatdt-instance 2 ", "expected '1'");
  expect_malformed("Flatdt-instance 1 ", "expected 'flatdt-instance'");
  expect_malformed("flatdt-instance 1 manifold torus ", "expected 'dimension'");
  expect_malformed("flatdt-instance 1 dimension 1 ", "the dimension");
  expect_malformed("flatdt-instance 1 dimension -2 ", "the dimension");
}

TEST(InstanceParser, SectionsInOrderAndAtMostOnce) {
  EXPECT_EQ(read_instance(kHead + "manifold torus points 1 0 0 ").generators.size(), 2U);
  expect_malformed(kHead + "points 1 0 0 ", "expected 'manifold' or 'generators'");
  expect_malformed(kHead + "metric 1 0 1 points 1 0 0 ", "expected 'manifold' or 'generators'");
  expect_malformed(kTorus + "manifold torus points 1 0 0 ", "expected 'points'");
  expect_malformed(kHead + "manifold torus manifold torus points 1 0 0 ", "expected 'points'");
  expect_malformed(kTorus + "metric 1 0 1 metric 1 0 1 points 1 0 0 ", "expected 'points'");
  expect_malformed(kTorus + "metric 1 0 1 generators 1 1 0 1 0 1 0 points 1 0 0 ", "expected 'points'");
  expect_malformed(kTorus + "Points 1 0 0 ", "expected 'points'");
  expect_malformed(kTorus + "metric 1 0 1 ", "expected 'points'");
  expect_malformed(kTorus + "points 1 0 0 0 ", "expected the end of the file");
  expect_malformed(kTorus + "points 1 0 0 points 1 0 0 ", "expected the end of the file");
  expect_malformed(kTorus + "points 2 0 0 0 ", "a coordinate");
}

TEST(InstanceParser, Counts) {
  expect_malformed(kHead + "generators 0 points 1 0 0 ", "number of generators must be from 1");
  expect_malformed(kHead + "generators 10001 ", "number of generators");
  expect_malformed(kTorus + "points 0 ", "number of points must be from 1");
  expect_malformed(kTorus + "points 100000001 ", "number of points");
  expect_malformed(kTorus + "points 1000000000000000000 ", "number of points");
  expect_malformed(kTorus + "points " + std::string(4000, '9') + " ", "number of points");
  expect_malformed(kTorus + "points 1.0 0 0 ", "[0-9]+");
  expect_malformed(kTorus + "points +1 0 0 ", "[0-9]+");
  expect_malformed(kTorus + "points 0x1 0 0 ", "[0-9]+");
  EXPECT_EQ(read_instance(kTorus + "points 0001 0 0 ").points.size(), 1U);
  expect_malformed(kTorus + "points 100000000 0 0 ",
                   "found the end of the file");  // a count reserves nothing
}

TEST(InstanceParser, TokenLengthLimit) {
  const std::string digits(4096, '1');
  EXPECT_EQ(read_instance(kTorus + "points 1 0 " + digits + " ").points[0][1].get_str(), digits);
  expect_malformed(kTorus + "points 1 0 1" + digits + " ", "longer than 4096");
  EXPECT_EQ(read_instance(kTorus + "points 1 0 0 #" + std::string(100'000, 'x')).points.size(), 1U);
}

TEST(InstanceParser, NumbersCarryTheirReason) {
  expect_malformed(kTorus + "points 1 0 1/0 ", "denominator is zero");
  expect_malformed(kTorus + "points 1 0 1e1101 ", "exponent beyond 1100");
  expect_malformed(kTorus + "points 1 0 0x1p-4401 ", "exponent beyond 4400");
  expect_malformed(kTorus + "points 1 0 zero ", "a coordinate");
}

TEST(InstanceParser, ManifoldNames) {
  const char* plane[] = {"torus", "p1", "klein-bottle", "pg"};
  const char* space[] = {"torocosm",
                         "G1",
                         "P1",
                         "3-torus",
                         "dicosm",
                         "G2",
                         "P21",
                         "tricosm",
                         "G3",
                         "P31",
                         "P32",
                         "tetracosm",
                         "G4",
                         "P41",
                         "P43",
                         "hexacosm",
                         "G5",
                         "P61",
                         "P65",
                         "didicosm",
                         "G6",
                         "P212121",
                         "hantzsche-wendt",
                         "first-amphicosm",
                         "B1",
                         "Pc",
                         "second-amphicosm",
                         "B2",
                         "Cc",
                         "first-amphidicosm",
                         "B3",
                         "Pca21",
                         "second-amphidicosm",
                         "B4",
                         "Pna21"};
  for (const char* name : plane) {
    EXPECT_NO_THROW((void)read_instance(kHead + "manifold " + name + " points 1 0 0 ")) << name;
    expect_malformed("flatdt-instance 1 dimension 3 manifold " + std::string(name) + " points 1 0 0 0 ",
                     "dimension");
  }
  for (const char* name : space) {
    EXPECT_NO_THROW((void)read_instance("flatdt-instance 1 dimension 3 manifold " + std::string(name) +
                                        " points 1 0 0 0 "))
        << name;
    expect_malformed(kHead + "manifold " + name + " points 1 0 0 ", "dimension");
  }
  for (const char* name : {"Torus", "p", "G", "G7", "TORUS", "p1,pg", "points"}) {
    expect_malformed(kHead + "manifold " + name + " points 1 0 0 ", "unknown manifold");
  }
  expect_malformed(kHead + "manifold ", "unknown manifold");
}

TEST(InstanceParser, AliasesOfMirrorImagesGiveMirrorImageGenerators) {
  const std::string head = "flatdt-instance 1 dimension 3 manifold ";
  for (const auto& [left, right] :
       {std::pair("P31", "P32"), std::pair("P41", "P43"), std::pair("P61", "P65")}) {
    const Instance a = read_instance(head + left + " points 1 0 0 0 ");
    const Instance b = read_instance(head + right + " points 1 0 0 0 ");
    EXPECT_NE(a.generators[1].linear, b.generators[1].linear);
    EXPECT_EQ(a.claim, b.claim);
  }
}

TEST(InstanceParser, Metric) {
  EXPECT_EQ(read_instance(kTorus + "points 1 0 0 ").metric[0][0], 1);
  const Instance hexagonal = read_instance("flatdt-instance 1 dimension 3 manifold P61 points 1 0 0 0 ");
  EXPECT_EQ(hexagonal.metric[0][1], Rational(-1, 2));
  EXPECT_EQ(hexagonal.metric[1][0], Rational(-1, 2));
  const Instance given =
      read_instance("flatdt-instance 1 dimension 3 manifold P1 metric 1 2 3 10 5 100 points 1 0 0 0 ");
  EXPECT_EQ(given.metric[2][1], 5);
  EXPECT_EQ(given.metric[2][2], 100);
  expect_malformed(kTorus + "metric 0 0 1 points 1 0 0 ", "not positive definite");
  expect_malformed(kTorus + "metric 1 1 1 points 1 0 0 ", "not positive definite");
  expect_malformed(kTorus + "metric -1 0 -1 points 1 0 0 ", "not positive definite");
  expect_malformed("flatdt-instance 1 dimension 3 manifold P1 metric 1 1 1 2 2 2 points 1 0 0 0 ", "order 3");
}

}  // namespace
}  // namespace flatdt::checker::test
