// Implementations that are wrong in one way each:  flawed WAY INSTANCE OUTPUT,  flawed WAY --loop
//
// Ways: right; drop-cell (the last one); flip (an edge, on the torus of dimension 2 from 12 points on); abort
// (from 5 points on); hang (from 3 points on); memory (from 2 points on); flood (writes without end);
// garbage; exit-7; unsupported (dimension 3, else right); forget (writes nothing);
// pipe, link, folder (which it makes in the place of the output).
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "flatdt/ref/group_analysis.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "flatdt/ref/triangulate.hpp"

namespace {

using flatdt::ref::Instance;
using flatdt::ref::Isometry;
using flatdt::ref::Rational;
using flatdt::ref::Triangulation;
using flatdt::ref::Vector;

struct Lift {
  std::uint32_t point;
  Vector place;
};

Lift lift(const Instance& instance, const Triangulation& t, const Triangulation::CellVertex& v) {
  return {v.point, t.elements[v.element] * instance.points[v.point]};
}

Rational area(const Vector& a, const Vector& b, const Vector& c) {
  const Vector u = b - a, v = c - a;
  return u[0] * v[1] - u[1] * v[0];
}

/// The element that takes corner w of some cell behind the edge from b to c, if that cell has the edge moved
/// by a translation and w is its third corner.
std::optional<Isometry> across(const Instance& instance, const Triangulation& t, const Lift& b, const Lift& c,
                               const std::array<Triangulation::CellVertex, 4>& cell, std::size_t w) {
  const Lift p = lift(instance, t, cell[(w + 1) % 3]), q = lift(instance, t, cell[(w + 2) % 3]);
  for (const auto& [from, to] : {std::pair(p, q), std::pair(q, p)})
    if (from.point == b.point && to.point == c.point && b.place - from.place == c.place - to.place)
      return Isometry::translate(b.place - from.place) * t.elements[cell[w].element];
  return std::nullopt;
}

/// Flips the first edge whose two cells form a convex quadrilateral. Requires: a torus of dimension 2.
void flip(const Instance& instance, Triangulation& t) {
  for (std::size_t i = 0; i < t.cells.size(); ++i)
    for (std::size_t corner = 0; corner < 3; ++corner)
      for (std::size_t j = 0; j < t.cells.size(); ++j)
        for (std::size_t w = 0; w < 3 && i != j; ++w) {
          const auto cell = t.cells[i];
          const Lift a = lift(instance, t, cell[corner]), b = lift(instance, t, cell[(corner + 1) % 3]),
                     c = lift(instance, t, cell[(corner + 2) % 3]);
          const auto element = across(instance, t, b, c, t.cells[j], w);
          if (!element) continue;
          const Vector d = *element * instance.points[t.cells[j][w].point];
          if ((area(a.place, b.place, d).sign() != area(a.place, d, c.place).sign()) ||
              area(a.place, b.place, d).is_zero() || area(a.place, d, c.place).is_zero())
            continue;
          t.elements.push_back(*element);
          const Triangulation::CellVertex apex{t.cells[j][w].point,
                                               static_cast<std::uint32_t>(t.elements.size() - 1)};
          t.cells[i] = {cell[corner], cell[(corner + 1) % 3], apex, {}};
          t.cells[j] = {cell[corner], apex, cell[(corner + 2) % 3], {}};
          return;
        }
}

[[noreturn]] void take_memory() {
  std::vector<std::vector<char>> blocks;
  for (;;) blocks.emplace_back(std::size_t{1} << 22, 'x');
}

[[noreturn]] void spin() {
  static std::atomic<std::uint64_t> rounds = 0;
  for (;;) ++rounds;
}

std::string answer(const std::string& way, const std::string& text) {
  const Instance instance = flatdt::ref::parse_instance(text, "instance");
  const std::size_t n = instance.points.size();
  if (way == "abort" && n >= 5) std::abort();
  if (way == "memory" && n >= 2) take_memory();
  if (way == "garbage") return "Segmentation fault (not really)\n";
  if (way == "forget") return {};
  if (way == "hang" && n >= 3) spin();
  const auto analysis = flatdt::ref::analyse(instance);
  Triangulation t = flatdt::ref::triangulate(instance, analysis, {}).triangulation;
  if (way == "drop-cell") t.cells.pop_back();
  if (way == "flip" && n >= 12 && instance.dimension == 2 && analysis.cosets.size() == 1 && !t.has_subgroup)
    flip(instance, t);
  return flatdt::ref::write_triangulation(t, {});
}

[[noreturn]] void flood(std::ostream& out) {
  for (;;)
    out << "flatdt-triangulation 1 elements 1000000 1 0 0 0 1 0 1 0 0 0 1 0 1 0 0 0 1 0\n" << std::flush;
}

bool is_solid(const std::string& text) {
  return text.find("dimension 3") != std::string::npos;
}

int loop(const std::string& way) {
  std::string text;
  for (std::string line; std::getline(std::cin, line);) {
    if (line != "end") {
      text += line + "\n";
      continue;
    }
    if (way == "flood") flood(std::cout);
    if (way == "exit-7") return 7;
    std::cout << (way == "unsupported" && is_solid(text) ? "unsupported dimension\n" : answer(way, text))
              << "end\n"
              << std::flush;
    text.clear();
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 3 && argv[2] == std::string("--loop")) return loop(argv[1]);
  if (argc != 4) return 2;
  const std::string way = argv[1];
  if (way == "exit-7") return 7;
  std::ifstream in(argv[2]);
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (way == "unsupported" && is_solid(text)) return 4;
  if (way == "pipe") return mkfifo(argv[3], 0600);
  if (way == "link") return symlink("/dev/zero", argv[3]);
  if (way == "folder") return mkdir(argv[3], 0700);
  std::ofstream out(argv[3]);
  if (way == "flood") flood(out);
  out << answer(way, text);
  return 0;
}
