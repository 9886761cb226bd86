#include "flatdt/ref/predicates.hpp"

#include <algorithm>
#include <numeric>

namespace flatdt::ref {

template <int D>
bool Predicates<D>::perturbed_conflict(const Simplex& cell, const Lift& w) {
  // Indices 0..D are the cell's vertices, D+1 is w; largest in the tie order first.
  std::array<std::size_t, D + 2> order;
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto point = [&](std::size_t k) -> const OrbitPoint& { return k == D + 1 ? w.point : cell[k].point; };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return order_->less(point(b).site, point(b).g, point(a).site, point(a).g);
  });
  // The lifted heights are raised by symbolic epsilons, the largest point's first: the sign is that of the
  // first nonzero coefficient. Raising w's own height takes it out of every ball. For a vertex u the
  // coefficient is the orientation of the cell with w in u's place, relative to the cell's own (positive).
  int rounds = 0;
  for (std::size_t i = 0; i <= D + 1; ++i) {
    const std::size_t u = order[i];
    if (i <= D && point(u).site == point(order[i + 1]).site) ++ties_within_orbits_;
    if (u == D + 1) return false;
    Simplex replaced = cell;
    replaced[u] = w;
    const Sign f = orientation(replaced);
    if (f != Sign::zero) return f == Sign::positive;
    // A circle has no three collinear points: in 2D the first round decides, in 3D the second (INSERTION 2).
    ensure(++rounds < D - 1, "the perturbation decides in one round in 2D and two in 3D");
  }
  throw InternalError("the perturbation always decides");
}

template class Predicates<2>;
template class Predicates<3>;

}  // namespace flatdt::ref
