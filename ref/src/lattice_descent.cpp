#include "lattice_descent.hpp"

namespace flatdt::ref {

std::vector<Vector> proper_subset_sums(const std::vector<Vector>& superbase) {
  std::vector<Vector> sums;
  const unsigned all = (1U << superbase.size()) - 1;
  for (unsigned subset = 1; subset < all; ++subset) {
    Vector sum(superbase[0].dimension());
    for (std::size_t i = 0; i < superbase.size(); ++i)
      if ((subset >> i & 1U) != 0) sum = sum + superbase[i];
    sums.push_back(sum);
  }
  return sums;
}

Vector descend(const Matrix& gram, const std::vector<Vector>& relevant, Vector x) {
  for (;;) {
    // |x - n|^2 - |x|^2 = <n,n> - 2 <x,n>; every step lowers |x|^2 within x + lattice, so the loop ends.
    const Vector* best = nullptr;
    Rational best_change;
    for (const Vector& n : relevant) {
      const Rational change = inner_product(gram, n - (x + x), n);
      if (change < best_change) {
        best_change = change;
        best = &n;
      }
    }
    if (best == nullptr) return x;
    x = x - *best;
  }
}

}  // namespace flatdt::ref
