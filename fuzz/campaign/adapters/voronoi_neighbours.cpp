// voro++ on a triclinic torus: its neighbour graph, as a claim of edges (docs/campaigns.md). It computes with
// doubles and a tolerance, so the points are rounded, and neighbours across tiny facets are not to be
// expected.
#include <voro++/voro++.hh>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "adapter.hpp"
#include "flatdt/ref/group_analysis.hpp"

namespace flatdt::adapters {
namespace {

using ref::Isometry;
using ref::Rational;
using ref::Vector;
using Triple = std::array<double, 3>;
using Translation = std::array<int, 3>;

// Neighbours in a reduced basis lie in cells next to each other, or next but one.
constexpr int kReach = 2;
constexpr double kBlockPoints = 5;  // points in a block of the container: what its authors advise

double rounded(const Rational& x) {
  return mpq_class(x.numerator().mpz(), x.denominator().mpz()).get_d();
}

/// The reduced cell with its first vector on the x axis and its second in the xy plane.
struct Cell {
  double bx, bxy, by, bxz, byz, bz;
  [[nodiscard]] Triple cartesian(const Triple& f) const {
    return {bx * f[0] + bxy * f[1] + bxz * f[2], by * f[1] + byz * f[2], bz * f[2]};
  }
};

Cell cell_of(const ref::Matrix& gram) {
  const double scale = rounded(gram(0, 0));  // keeps metrics with large exponents in range
  const auto g = [&](int i, int j) { return rounded(gram(i, j) / gram(0, 0)); };
  if (!(scale > 0) || !std::isfinite(scale)) throw Unsupported("the metric does not fit into doubles");
  const double bx = 1, bxy = g(0, 1), by = std::sqrt(g(1, 1) - bxy * bxy), bxz = g(0, 2),
               byz = (g(1, 2) - bxy * bxz) / by, bz = std::sqrt(g(2, 2) - bxz * bxz - byz * byz);
  return {bx, bxy, by, bxz, byz, bz};
}

struct Edge {
  std::size_t from, to;
  Translation translation;
  friend auto operator<=>(const Edge&, const Edge&) = default;
};

class Neighbours {
 public:
  Neighbours(const Cell& cell, const std::vector<Triple>& places) : cell_(cell), places_(places) {
    const double edge =
        std::cbrt(cell.bx * cell.by * cell.bz * kBlockPoints / static_cast<double>(places.size()));
    const auto blocks = [&](double length) { return std::max(1, static_cast<int>(length / edge)); };
    voro::container_periodic container(cell.bx, cell.bxy, cell.by, cell.bxz, cell.byz, cell.bz,
                                       blocks(cell.bx), blocks(cell.by), blocks(cell.bz), 8);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Triple x = cell.cartesian(places[i]);
      container.put(static_cast<int>(i), x[0], x[1], x[2]);
    }
    voro::c_loop_all_periodic loop(container);
    voro::voronoicell_neighbor voronoi_cell;
    if (!loop.start()) return;
    do
      if (container.compute_cell(voronoi_cell, loop))
        read(static_cast<std::size_t>(loop.pid()), voronoi_cell);
    while (loop.inc());
  }
  [[nodiscard]] const std::set<Edge>& edges() const { return edges_; }

 private:
  void read(std::size_t from, voro::voronoicell_neighbor& voronoi_cell) {
    std::vector<int> neighbours, faces;
    std::vector<double> vertices;
    voronoi_cell.neighbors(neighbours);
    voronoi_cell.face_vertices(faces);
    voronoi_cell.vertices(vertices);
    std::size_t at = 0;
    for (const int to : neighbours) {
      const auto count = static_cast<std::size_t>(faces[at]);
      std::vector<Triple> corners;
      for (std::size_t k = 1; k <= count; ++k) {
        const auto v = 3 * static_cast<std::size_t>(faces[at + k]);
        corners.push_back({vertices[v], vertices[v + 1], vertices[v + 2]});
      }
      at += count + 1;
      if (to >= 0)
        edges_.insert(
            {from, static_cast<std::size_t>(to), image(from, static_cast<std::size_t>(to), corners)});
    }
  }

  /// voro++ does not say which image is the neighbour: the one whose bisector is nearest to the face.
  [[nodiscard]] Translation image(std::size_t from, std::size_t to,
                                  const std::vector<Triple>& corners) const {
    Translation best{};
    double least = HUGE_VAL;
    for (int a = -kReach; a <= kReach; ++a)
      for (int b = -kReach; b <= kReach; ++b)
        for (int c = -kReach; c <= kReach; ++c) {
          const Triple w =
              cell_.cartesian({places_[to][0] + a - places_[from][0], places_[to][1] + b - places_[from][1],
                               places_[to][2] + c - places_[from][2]});
          const double square = w[0] * w[0] + w[1] * w[1] + w[2] * w[2];
          if (square == 0) continue;
          double distance = 0;
          for (const Triple& p : corners)
            distance = std::max(
                distance, std::abs(p[0] * w[0] + p[1] * w[1] + p[2] * w[2] - square / 2) / std::sqrt(square));
          if (distance < least) std::tie(least, best) = std::tuple(distance, Translation{a, b, c});
        }
    return best;
  }

  Cell cell_;
  const std::vector<Triple>& places_;
  std::set<Edge> edges_;
};

std::string answer(const ref::Instance& instance) {
  const ref::GroupAnalysis analysis = ref::analyse(instance);
  if (instance.dimension != 3 || analysis.cosets.size() != 1) throw Unsupported("not a torus of dimension 3");
  const ref::Frame& frame = analysis.frame;
  const ref::Matrix to_frame = frame.basis.inverse();
  std::vector<Triple> places;
  std::vector<Vector> floors;  // the periods that were taken off each point, in the frame
  for (const Vector& x : instance.points) {
    const Vector y = to_frame * (x - frame.origin);
    Vector whole(3);
    Triple place{};
    for (int k = 0; k < 3; ++k) {
      whole[k] = Rational(floor(y[k]));
      place[static_cast<std::size_t>(k)] = rounded(y[k] - whole[k]);
    }
    floors.push_back(whole);
    places.push_back(place);
  }
  const Cell cell = cell_of(frame.gram);
  const Neighbours neighbours(cell, places);
  std::map<Vector, std::size_t> numbers;
  std::string elements, edges;
  const auto number_of = [&](const Vector& periods) {
    const auto [at, fresh] = numbers.try_emplace(periods, numbers.size());
    if (fresh) elements += "  " + Isometry::translate(frame.basis * periods).to_string() + "\n";
    return std::to_string(at->second);
  };
  const std::string identity = number_of(Vector(3));
  for (const Edge& e : neighbours.edges()) {
    Vector periods = floors[e.from] - floors[e.to];
    for (int k = 0; k < 3; ++k) periods[k] += Rational(e.translation[static_cast<std::size_t>(k)]);
    edges += "  " + std::to_string(e.from) + " " + identity + "  " + std::to_string(e.to) + " " +
             number_of(periods) + "\n";
  }
  return "flatdt-edges 1\nelements " + std::to_string(numbers.size()) + "\n" + elements + "edges " +
         std::to_string(neighbours.edges().size()) + "\n" + edges;
}

}  // namespace
}  // namespace flatdt::adapters

int main(int argc, char** argv) {
  return flatdt::adapters::run_adapter("flatdt-voro", std::vector<std::string>(argv + 1, argv + argc),
                                       flatdt::adapters::answer);
}
