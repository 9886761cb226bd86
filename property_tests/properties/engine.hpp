/// The reference's parts put together as ref::triangulate does, for tests that look inside.
/// Everything is in frame coordinates: x_instance = basis * x + origin.
#pragma once

#include <vector>

#include "flatdt/ref/circumradius.hpp"
#include "flatdt/ref/periodic_delaunay.hpp"

namespace flatdt::property_tests {

template <int D>
struct Engine {
  Engine(const ref::Instance& of_instance, ref::PredicateStages stages)
      : instance(of_instance),
        analysis(ref::analyse(instance)),
        table(analysis.frame),
        sites(ref::make_sites(analysis.frame, instance.points)),
        order(analysis.frame, table),
        predicates(analysis.frame, table, sites, order, stages),
        circumradius(analysis.frame, predicates) {}
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  [[nodiscard]] ref::Lift lift(const ref::OrbitPoint& p) const {
    return {table.apply(p.g, sites[index_of(p.site)].approximate()), p};
  }
  /// Exact coordinates of a point of GP.
  [[nodiscard]] ref::Vector position(const ref::OrbitPoint& p) const {
    ref::Vector x(D);
    const ref::Site& site = sites[index_of(p.site)];
    for (int i = 0; i < D; ++i) x[i] = ref::Rational(site.numerator(i), site.denominator());
    return table.isometry(p.g) * x;
  }

  ref::Instance instance;
  ref::GroupAnalysis analysis;
  ref::GroupTable table;
  std::vector<ref::Site> sites;
  ref::TieOrder order;
  ref::Predicates<D> predicates;
  ref::Circumradius<D> circumradius;
};

}  // namespace flatdt::property_tests
