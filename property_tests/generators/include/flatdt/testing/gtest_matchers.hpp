/// GoogleTest matchers. They need the headers of GoogleTest only; EXPECT_THAT is part of GoogleMock.
#pragma once

#include <gtest/gtest.h>

#include <iosfwd>
#include <string>

#include "flatdt/testing/explain.hpp"

namespace flatdt::testing {

/// Matches a triangulation (ref's, or the text of a file) that the checker proves to be a Delaunay
/// triangulation of the instance (an instance, a specimen, or the text of a file), of its manifold or of the
/// covering space that the file names. The failure message holds the verdict and the witnesses of all
/// conditions that fail.
///   EXPECT_THAT(my_triangulation(instance), IsDelaunayTriangulationOf(instance));
class IsDelaunayTriangulationOf {
 public:
  using is_gtest_matcher = void;

  explicit IsDelaunayTriangulationOf(InstanceText instance);
  bool MatchAndExplain(const TriangulationText& triangulation, std::ostream* explanation) const;
  void DescribeTo(std::ostream* out) const;
  void DescribeNegationTo(std::ostream* out) const;

 private:
  InstanceText instance_;
};

/// Matches a triangulation on which the named condition fails ("delaunay.empty", docs/format.md), whatever
/// the others do. The name must be one of the checker's: a misspelt one is std::invalid_argument.
///   EXPECT_THAT(what_the_bug_gives(instance), ViolatesCondition("delaunay.empty", instance));
class ViolatesCondition {
 public:
  using is_gtest_matcher = void;

  ViolatesCondition(const std::string& condition, InstanceText instance);
  bool MatchAndExplain(const TriangulationText& triangulation, std::ostream* explanation) const;
  void DescribeTo(std::ostream* out) const;
  void DescribeNegationTo(std::ostream* out) const;

 private:
  checker::ConditionName condition_{};
  InstanceText instance_;
};

/// The same without GoogleMock: EXPECT_TRUE(is_delaunay_triangulation(text, instance)).
[[nodiscard]] ::testing::AssertionResult is_delaunay_triangulation(const TriangulationText& triangulation,
                                                                   const InstanceText& instance);

}  // namespace flatdt::testing
