#include "checkerboard.hpp"

#include "draft.hpp"

namespace flatdt::edits {

using ref::Isometry;
using ref::Rational;

std::optional<Files> checkerboard(const Base& base, Random& /*random*/) {
  if (base.dimension() != 3 || !base.points_are_distinct() || base.group().cosets().size() > 1)
    return std::nullopt;
  if (!base.group().lattice().is_identity()) return std::nullopt;
  int k = 3;
  while (k * k * k < static_cast<int>(base.instance().points.size())) k += 2;
  if (k * k * k != static_cast<int>(base.instance().points.size())) return std::nullopt;
  const std::vector<ref::Vector>& points = base.instance().points;
  Draft draft(base);
  const auto vertex = [&](int x, int y, int z) -> std::optional<FileVertex> {
    ref::Vector wanted(3);
    wanted[0] = Rational(x) * Rational(ref::Integer(1), ref::Integer(k));
    wanted[1] = Rational(y) * Rational(ref::Integer(1), ref::Integer(k));
    wanted[2] = Rational(z) * Rational(ref::Integer(1), ref::Integer(k));
    for (std::uint32_t p = 0; p < points.size(); ++p)
      if ((wanted - points[p]).is_integral())
        return FileVertex{p, draft.index_of(Isometry::translate(wanted - points[p]))};
    return std::nullopt;
  };
  draft.cells().clear();
  for (int x = 0; x < 2 * k; ++x)
    for (int y = 0; y < k; ++y)
      for (int z = 0; z < k; ++z) {
        FileCell middle{};
        std::size_t evens = 0;
        for (int corner = 0; corner < 8; ++corner) {
          const std::array<int, 3> at = {x + (corner & 1), y + (corner >> 1 & 1), z + (corner >> 2)};
          const bool even = (at[0] + at[1] + at[2]) % 2 == 0;
          const std::optional<FileVertex> here = vertex(at[0], at[1], at[2]);
          if (!here) return std::nullopt;
          if (even) {
            middle[evens++] = *here;
            continue;
          }
          // The corner and its three neighbours in the cube, each on the other side along one axis.
          FileCell cut{*here, {}, {}, {}};
          for (std::size_t axis = 0; axis < 3; ++axis) {
            std::array<int, 3> to = at;
            to[axis] += (corner >> axis & 1) == 1 ? -1 : 1;
            const std::optional<FileVertex> neighbour = vertex(to[0], to[1], to[2]);
            if (!neighbour) return std::nullopt;
            cut[axis + 1] = *neighbour;
          }
          draft.cells().push_back(cut);
        }
        draft.cells().push_back(middle);
      }
  draft.triangulation().has_subgroup = false;
  draft.triangulation().subgroup.clear();
  return draft.files();
}

}  // namespace flatdt::edits
