/// Our side of the comparisons, through the public headers of ref and checker.
#pragma once

#include <string>

#include "experiment.hpp"
#include "flatdt/ref/triangulate.hpp"

namespace flatdt::bench {

/// triangulate_in_frame(): from the instance's rationals to the sorted list of cells in memory, with the
/// decision and the cover; the group is prepared beforehand.
Work our_triangulation(ref::Instance instance, ref::Insertion insertion = ref::Insertion::without_covers);
/// The same for each of several instances of one group, which is prepared once for all of them, beforehand
/// (`analysed_each_time`: analysed and prepared with each instance, within the work).
Work our_triangulations(std::vector<ref::Instance> instances, bool analysed_each_time = false);
/// check() of our own triangulation of the instance, both parsed beforehand: all conditions, but homology
/// only up to the checker's limit for it. Errors: std::runtime_error if it is not VERIFIED.
Work our_check(const ref::Instance& instance);

}  // namespace flatdt::bench
