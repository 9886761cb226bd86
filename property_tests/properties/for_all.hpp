/// Runs a property on random specimens, shrinks what fails and keeps it as a file.
/// The environment:
///   FLATDT_EFFORT=N          N times as many cases
///   FLATDT_FRESH_SEED=1      a seed of the day, printed, instead of the fixed one
///   FLATDT_INSTANCE=FILE     this instance only, whatever the domain
///   FLATDT_COUNTEREXAMPLES   the directory that shrunk counterexamples are written to (default: .)
///   RC_PARAMS                RapidCheck's own: seed, max_success, reproduce, verbose_shrinking, ...
#pragma once

#include <functional>
#include <string>

#include "draw.hpp"

namespace flatdt::property_tests {

using testing::Domain;
using testing::Specimen;
using Property = std::function<void(const Specimen&)>;

/// How often a property is tried, on what.
struct Trials {
  int cases = 100;
  Domain domain;
};

/// Checks the property on the files property-*.instance of corpora/regressions that fit the domain, then on
/// random specimens. Fails the current GoogleTest test with the shrunk counterexample. The property fails by
/// throwing. Prints the number of random cases, and returns it: 0 if the property failed or one
/// instance was asked for.
int for_all(const Trials& trials, const Property& property);

/// FLATDT_EFFORT, 1 if it is not set.
int effort();

/// A domain of some manifolds, otherwise the default.
Domain domain_of(std::vector<std::string> manifolds);
/// The two manifolds of the plane; the ten of space with the mirror images.
Domain plane();
Domain space();

/// Whether the seed is that of continuous integration: of what other seeds visit nothing is known. Requires:
/// a property has been checked.
bool has_fixed_seed();

}  // namespace flatdt::property_tests
