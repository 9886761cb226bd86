/// The model of the state-machine tests of insertion: which copies of which orbits are present.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "flatdt/ref/sites.hpp"
#include "judge.hpp"

namespace flatdt::property_tests {

/// Does a set of orbits satisfy Corollary 9? Asked of the reference's whole program, which
/// corollary9_test.cpp compares with the definitions.
class Threshold {
 public:
  Threshold(ref::Instance instance, const std::vector<ref::Site>& sites) : instance_(std::move(instance)) {
    for (const ref::Site& site : sites) points_.push_back(instance_.points[site.point]);
  }
  bool is_met(const std::vector<bool>& orbits) {
    const auto [entry, is_new] = known_.try_emplace(orbits, false);
    if (is_new) {
      ref::Instance part = instance_;
      part.points.clear();
      for (std::size_t i = 0; i < orbits.size(); ++i)
        if (orbits[i]) part.points.push_back(points_[i]);
      const ref::TriangulationResult result = triangulate(part);
      entry->second = ref::Rational(4) * result.empty_diameter_squared < result.delta_squared;
    }
    return entry->second;
  }

 private:
  ref::Instance instance_;
  std::vector<ref::Vector> points_;  // of the sites
  std::map<std::vector<bool>, bool> known_;
};

/// Which copies of which sites are present. Site 0 is complete from the start.
struct Model {
  std::vector<std::vector<bool>> present;
  bool on_manifold = false;
  std::shared_ptr<Threshold> threshold;

  [[nodiscard]] static bool is_complete(const std::vector<bool>& copies) {
    return std::find(copies.begin(), copies.end(), false) == copies.end();
  }
  [[nodiscard]] std::vector<std::size_t> incomplete_sites() const {
    std::vector<std::size_t> sites;
    for (std::size_t i = 0; i < present.size(); ++i)
      if (!is_complete(present[i])) sites.push_back(i);
    return sites;
  }
  /// Whole orbits only, and they satisfy Corollary 9: then L must be empty.
  [[nodiscard]] bool may_convert() const {
    if (on_manifold) return false;
    std::vector<bool> orbits;
    for (const std::vector<bool>& copies : present) {
      orbits.push_back(is_complete(copies));
      if (!orbits.back() && std::find(copies.begin(), copies.end(), true) != copies.end()) return false;
    }
    return threshold->is_met(orbits);
  }
};

}  // namespace flatdt::property_tests
