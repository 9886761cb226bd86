/// Shared by the tests of the oracles: files, and ref's answer brought through the file formats.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "flatdt/checker/input.hpp"
#include "flatdt/ref/group_analysis.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "flatdt/ref/triangulate.hpp"
#include "flatdt/ref/triangulation_format.hpp"
#include "oracle/linear.hpp"

namespace flatdt::oracle_tests {

inline std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  EXPECT_TRUE(in.good() && std::filesystem::is_regular_file(file)) << file;
  return text.str();
}

inline checker::Instance read_instance(const std::string& text) {
  std::istringstream in(text);
  return checker::parse_instance(in, "instance");
}

inline checker::Triangulation read_triangulation(const std::string& text, const checker::Instance& instance) {
  std::istringstream in(text);
  return checker::parse_triangulation(in, "triangulation", instance);
}

/// How much of the dear part is done: a number from the environment, else that of CI.
inline std::size_t setting(const char* name, std::size_t in_ci) {
  const char* const value = std::getenv(name);
  return value == nullptr ? in_ci : std::stoul(value);
}

/// The files of a folder whose names end in `extension`, in order; a path without the extension each.
inline std::vector<std::filesystem::path> stems(const std::filesystem::path& folder,
                                                const std::string& extension) {
  std::vector<std::filesystem::path> found;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.path().extension() == extension)
      found.push_back(entry.path().parent_path() / entry.path().stem());
  std::sort(found.begin(), found.end());
  EXPECT_FALSE(found.empty()) << folder;
  return found;
}

inline std::filesystem::path with(const std::filesystem::path& stem, const std::string& extension) {
  return stem.string() + extension;
}

/// ref's answer to an instance, as the checker's parsers read both files.
struct Answer {
  checker::Instance instance;
  ref::TriangulationResult result;
  checker::Triangulation triangulation;
};

inline Answer answer_of_ref(const std::string& instance_text) {
  const ref::Instance given = ref::parse_instance(instance_text, "instance");
  ref::TriangulationResult result = ref::triangulate(given, ref::analyse(given), {});
  checker::Instance instance = read_instance(instance_text);
  checker::Triangulation triangulation =
      read_triangulation(ref::write_triangulation(result.triangulation, ref::describe(result)), instance);
  return {std::move(instance), std::move(result), std::move(triangulation)};
}

}  // namespace flatdt::oracle_tests
