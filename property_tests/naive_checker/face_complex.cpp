#include "naive_checker/face_complex.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace flatdt::naive {

using oracle::image;
using oracle::Seitz;
using oracle::Vector;

std::size_t FaceComplex::apex(const Occurrence& facet) {
  std::size_t j = 0;
  while (std::find(facet.corners.begin(), facet.corners.end(), j) != facet.corners.end()) ++j;
  return j;
}

FaceComplex face_complex(int dimension, const oracle::Group& subgroup,
                         std::vector<std::vector<Vector>> cells) {
  FaceComplex complex{dimension, subgroup, std::move(cells), false, {}};
  std::map<Vector, Seitz> to_canonical;  // movers already found
  for (std::size_t c = 0; c < complex.cells.size(); ++c) {
    const std::vector<Vector>& cell = complex.cells[c];
    for (const Vector& x : cell)
      if (!to_canonical.contains(x)) to_canonical.emplace(x, subgroup.canonical(x).second);
    for (std::size_t subset = 1; subset < std::size_t{1} << complex.corners(); ++subset) {
      std::vector<std::size_t> corners;
      for (std::size_t j = 0; j < complex.corners(); ++j)
        if ((subset >> j & 1U) != 0) corners.push_back(j);
      std::optional<std::pair<Face, Seitz>> best;
      for (const std::size_t base : corners) {
        const Seitz& mover = to_canonical.at(cell[base]);
        Face moved;
        for (const std::size_t j : corners) moved.push_back(image(mover, cell[j]));
        std::sort(moved.begin(), moved.end());
        if (!best || moved < best->first) best.emplace(std::move(moved), mover);
      }
      if (std::adjacent_find(best->first.begin(), best->first.end()) != best->first.end())
        complex.has_repeated_vertex = true;  // the same set of points is a smaller subset
      else
        complex.faces[corners.size() - 1][best->first].push_back({c, corners, best->second});
    }
  }
  return complex;
}

}  // namespace flatdt::naive
