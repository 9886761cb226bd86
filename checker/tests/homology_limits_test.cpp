// The limits of topology.homology, on telescopes: circles, each homologous to twice the next, so that the
// last is 2^n times the first, some of them capped by disks.
//
// No surface does that in the plane; in space every triangle becomes a tetrahedron with an apex of its own,
// listed twice, which is paired with itself and leaves its edges free to be shared.
#include <gtest/gtest.h>

#include <cstddef>
#include <string>

#include "build.hpp"

namespace flatdt::checker::test {
namespace {

/// A mapping telescope of maps of degree 2 in the cubic torus.   Source: A. Hatcher, Algebraic Topology,
/// section 3.F.
class Telescope {
 public:
  /// Circle k, of three vertices, is homologous to twice circle k + 1, up to circle `maps`; the first
  /// `caps` circles are filled by triangles.
  Telescope(std::size_t maps, std::size_t caps) : points_(3 * (maps + 1)) {
    for (std::size_t k = 0; k < caps; ++k) add(vertex(k, 0), vertex(k, 1), vertex(k, 2));
    for (std::size_t k = 0; k < maps; ++k) {
      for (std::size_t j = 0; j < 3; ++j) {
        const std::size_t top = vertex(k, j);
        add(top, vertex(k + 1, 2 * j), vertex(k + 1, 2 * j + 1));
        add(top, vertex(k + 1, 2 * j + 1), vertex(k + 1, 2 * j + 2));
        add(top, vertex(k, j + 1), vertex(k + 1, 2 * j + 2));
      }
    }
  }

  [[nodiscard]] Verdict verdict() const {
    std::string instance =
        "flatdt-instance 1 dimension 3 manifold torocosm points " + std::to_string(points_);
    for (std::size_t p = 0; p < points_; ++p) {
      instance += "\n" + std::to_string(p) + "/" + std::to_string(points_) + " 0 0";
    }
    return judge(instance + "\n", "flatdt-triangulation 1 elements 1 1 0 0 0 0 1 0 0 0 0 1 0 cells " +
                                      std::to_string(cells_) + cell_text_ + "\n");
  }

 private:
  [[nodiscard]] static std::size_t vertex(std::size_t circle, std::size_t k) { return 3 * circle + k % 3; }

  void add(std::size_t a, std::size_t b, std::size_t c) {
    const std::size_t apex = points_++;
    std::string cell = "\n";
    for (const std::size_t v : {a, b, c, apex}) cell += " " + std::to_string(v) + " 0";
    cell_text_ += cell + cell;
    cells_ += 2;
  }

  std::size_t points_;
  std::size_t cells_ = 0;
  std::string cell_text_;
};

std::string homology(const Telescope& telescope) {
  const Verdict verdict = telescope.verdict();
  EXPECT_EQ(verdict[ConditionName::facets_paired].status, Status::holds);
  return std::string(to_string(verdict[ConditionName::topology_homology].status)) + " " +
         witness(verdict, ConditionName::topology_homology, "complex");
}

TEST(HomologyLimits, SmallTelescopesAreComputed) {
  EXPECT_EQ(homology({3, 0}), "fails Z");
  EXPECT_EQ(homology({3, 1}), "fails Z/8");
  EXPECT_EQ(homology({5, 3}), "fails Z/8");  // the third circle is 8 times the last
  EXPECT_EQ(homology({300, 1}), "fails Z/" + Integer(Integer(1) << 300).get_str());
}

TEST(HomologyLimits, BitsOfTheRelations) {
  EXPECT_EQ(homology({2000, 90}), "skipped ");
}

TEST(HomologyLimits, BitsOfTheChains) {
  EXPECT_EQ(homology({6000, 0}), "skipped ");
}

}  // namespace
}  // namespace flatdt::checker::test
