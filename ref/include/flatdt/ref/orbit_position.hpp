/// Exact coordinates of points of GP in the frame.
#pragma once

#include <vector>

#include "flatdt/ref/exact_predicates.hpp"

namespace flatdt::ref {

/// The coordinates of p in the frame.
Vector position(const GroupTable& table, const std::vector<Site>& sites, const OrbitPoint& p);

}  // namespace flatdt::ref
