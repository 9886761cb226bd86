// Hostile input: bounded time and memory, and a typed answer.
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "build.hpp"

namespace flatdt::checker::test {
namespace {

std::string decimal(const Integer& x) {
  return x.get_str();
}

TEST(Hostile, ManyGeneratorsWithUnrelatedDenominators) {
  std::string text = "flatdt-instance 1 dimension 2 generators 10000 ";
  Integer denominator("1" + std::string(300, '0'));
  for (int i = 0; i < 10'000; ++i) {
    denominator += 1;
    text += "1 0 1/" + decimal(denominator) + " 0 1 0 ";
  }
  const Verdict v = judge(text + "points 1 0 0 ", "flatdt-triangulation 1 elements 0 cells 0 ");
  EXPECT_EQ(v.outcome, Outcome::unknown);
  EXPECT_NE(v.reason.find("limit of the checker"), std::string::npos);
}

TEST(Hostile, ManySmallGeneratorsRefineTheLattice) {
  std::string text = "flatdt-instance 1 dimension 2 generators 10000 1 0 0 0 1 1 ";
  for (int i = 1; i < 10'000; ++i) text += "1 0 1/" + std::to_string(1 + i % 30) + " 0 1 0 ";
  const Verdict v = judge(text + "points 1 0 0 ", "flatdt-triangulation 1 elements 0 cells 0 ");
  EXPECT_EQ(v.outcome, Outcome::refuted);
}

TEST(Hostile, HugeRotations) {  // rational rotations of infinite order with thousands of digits
  const Integer a("1" + std::string(1500, '3'));
  const Integer n = a * a + 1;
  const std::string c = decimal(a * a - 1) + "/" + decimal(n);
  const std::string s = decimal(2 * a) + "/" + decimal(n);
  ASSERT_LT(c.size(), 8000U);
  const std::string small_c = "3/5";
  const Integer b("7" + std::string(600, '1'));
  const Integer m = b * b + 1;
  const std::string fit_c = decimal(b * b - 1) + "/" + decimal(m);
  const std::string fit_s = decimal(2 * b) + "/" + decimal(m);
  const Verdict v = judge("flatdt-instance 1 dimension 2 generators 1 " + fit_c + " -" + fit_s + " 0 " +
                              fit_s + " " + fit_c + " 0 points 1 0 0 ",
                          "flatdt-triangulation 1 elements 0 cells 0 ");
  EXPECT_EQ(witness(v, ConditionName::group_crystallographic, "reason"), "infinite-order");
}

TEST(Hostile, HugeSkewBasis) {  // Z^2 described with a shear by 10^1000: exact, no limit needed
  const std::string big = "1" + std::string(1000, '0');
  const std::string square = "1" + std::string(2000, '0');
  // basis (1,0), (10^1000,1): coordinates (x,y) stand for x + 10^1000 y, y; metric [1, b; b, b^2+1]
  std::string text = "flatdt-instance 1 dimension 2 generators 2 1 0 1 0 1 0  1 0 -" + big +
                     " 0 1 1 metric 1 " + big + " " + square.substr(0, square.size() - 1) + "1 points 9 ";
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 3; ++x) {
      const Rational px = Rational(x, 3) - Rational(y, 3) * Rational(Integer(big));
      text += px.get_str() + " " + std::to_string(y) + "/3 ";
    }
  }
  TriangulationText t = grid_triangulation(3, 3);
  for (auto& cell : t.cells) {
    for (auto& [point, element] : cell) {
      std::istringstream in(element);
      int a = 0;
      int b = 0;
      std::string skip;
      in >> skip >> skip >> a >> skip >> skip >> b;
      element = "1 0 " + Integer(a - b * Integer(big)).get_str() + " 0 1 " + std::to_string(b);
    }
  }
  const Verdict v = judge(text, t.str());
  EXPECT_EQ(v.outcome, Outcome::verified) << statuses(v) << v.reason;
}

TEST(Hostile, TruncationsNeverPass) {
  const std::string instance = grid_instance(3, 3);
  const std::string triangulation = grid_triangulation(3, 3).str();
  const Instance whole = read_instance(instance);
  for (std::size_t n = 0; n < triangulation.size() - 1; ++n) {
    EXPECT_THROW((void)read_triangulation(triangulation.substr(0, n), whole), MalformedInput) << n;
  }
  for (std::size_t n = 0; n + 2 < instance.size(); ++n) {
    EXPECT_THROW((void)read_instance(instance.substr(0, n)), MalformedInput) << n;
  }
}

TEST(Hostile, RandomBytesAndEditsAreJudgedOrRefused) {
  std::mt19937 random(11);
  const std::string alphabet = " \n#0123456789-+/.exp";
  const std::string instance = grid_instance(3, 3);
  const std::string triangulation = grid_triangulation(3, 3).str();
  int refused = 0;
  int refuted = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string a = instance;
    std::string b = triangulation;
    for (int k = 0; k < 2; ++k) {
      std::string& s = random() % 2 == 0 ? a : b;
      s[random() % s.size()] =
          random() % 4 == 0 ? static_cast<char>(random() % 256) : alphabet[random() % alphabet.size()];
    }
    try {
      refuted += judge(a, b).outcome == Outcome::refuted ? 1 : 0;
    } catch (const MalformedInput&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 100);
  EXPECT_GT(refuted, 50);
}

}  // namespace
}  // namespace flatdt::checker::test
