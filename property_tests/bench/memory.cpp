#include "memory.hpp"

#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "ours.hpp"
#include "peer.hpp"

namespace flatdt::bench {
namespace {

/// A line "Name:   123 kB" of /proc/self/status.
long status_kb(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind(name + ":", 0) == 0) return std::stol(line.substr(name.size() + 1));
  throw std::runtime_error("/proc/self/status has no " + name);
}

/// The points are made and let go of before the work begins, so that each program holds its own form only.
Work prepared(const std::string& part, const Settings& settings) {
  const PointSet set = point_set("uniform", 3, settings.points);
  if (part == "flatdt") return our_triangulation(torus_instance(set));
  if (part == "cgal") return peer_batch(set);
  throw std::invalid_argument("no part of the memory experiment is called " + part);
}

}  // namespace

void run_memory(const std::string& part, const Settings& settings) {
  long input = 0;
  Done done;
  if (part != "nothing") {
    const Work work = prepared(part, settings);
    input = status_kb("VmRSS");
    done = work();
  }
  std::printf(
      "{\"experiment\":\"memory\",\"part\":\"%s\",\"items\":%zu,\"peak_kb\":%ld,\"input_kb\":%ld,"
      "\"cells\":%zu}\n",
      part.c_str(), settings.points, status_kb("VmHWM"), input, done.cells);
}

}  // namespace flatdt::bench
