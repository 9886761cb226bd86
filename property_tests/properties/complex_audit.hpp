/// What must hold of the reference's incremental complex between two insertions, from the definitions.
#pragma once

#include <vector>

#include "engine.hpp"

namespace flatdt::property_tests {

/// Throws Violation unless
///   - neighbours know each other, and a cell and its glued neighbour have the facet's points in common;
///   - base lifts are positively oriented, and vertices know a cell of theirs;
///   - the list L has exactly the cells with 16 R^2 >= delta^2 (while covering);
///   - the checker verifies the cells as a triangulation of E^d/H with the copies present:
///     present[site][rep], of which on the manifold only rep = 0 is looked at.
/// lattice: the translations of H in frame coordinates, columns.
template <int D>
void audit_complex(const Engine<D>& engine, const ref::PeriodicDelaunay<D>& level,
                   const std::vector<std::vector<bool>>& present, const ref::Matrix& lattice);

/// Throws Violation unless the located cell's closure contains the query.
template <int D>
void require_in_closure(const Engine<D>& engine, const ref::PeriodicDelaunay<D>& level, ref::SiteId site,
                        const ref::Location& at);

}  // namespace flatdt::property_tests
