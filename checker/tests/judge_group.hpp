// The group of an instance, and the verdict on the group alone.
#pragma once

#include <string>

#include "build.hpp"
#include "group.hpp"

namespace flatdt::checker::test {

inline Group group_of(const Instance& instance) {
  return make_group(
      std::get<Crystal>(close_group(instance.dimension, instance.generators, &instance.metric)));
}

/// Verdict on the instance with an empty triangulation: only the group conditions matter.
inline Verdict judge_group(const Instance& instance) {
  return check(instance, read_triangulation("flatdt-triangulation 1 elements 0 cells 0 ", instance));
}

inline Verdict judge_group(const std::string& text) {
  return judge_group(read_instance(text));
}

}  // namespace flatdt::checker::test
