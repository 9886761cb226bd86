#include "cover_search.hpp"

namespace flatdt::ref {
namespace {

long floor_quotient(long a, long b) {
  const long q = a / b;
  return a % b < 0 ? q - 1 : q;
}

}  // namespace

PlanePoint CosetSieve::reduced(PlanePoint x) const {
  const long k = floor_quotient(x.y, b_);
  x.y -= k * b_;
  x.z -= k * r_;
  x.z -= floor_quotient(x.z, c_) * c_;
  return x;
}

void CosetSieve::prepare(long b, long r, long c, long step, const Layers& layers) {
  b_ = b;
  r_ = r;
  c_ = c;
  step_ = step;
  layers_ = &layers;
  multiples_ = layers.empty() ? 0 : (static_cast<long>(layers.size()) - 1) / step;
  marks_.assign(static_cast<std::size_t>(b * c), 0);
  work_ += b * c + multiples_;
  for (long k = 1; k <= multiples_; ++k) {
    const auto& layer = layers[static_cast<std::size_t>(k * step)];
    PlanePoint last, x;
    for (const PlanePoint& forbidden : layer) {
      // Neighbours on a line, the usual case, need no division.
      if (forbidden.y == last.y && forbidden.z == last.z + 1 && &forbidden != &layer.front())
        x.z = x.z + 1 == c ? 0 : x.z + 1;
      else
        x = reduced(forbidden);
      last = forbidden;
      marks_[static_cast<std::size_t>(x.y * c + x.z)] |= std::uint64_t{1} << (k % 64);
    }
    work_ += static_cast<long>(layer.size());
  }
}

bool CosetSieve::layer_holds(long k, PlanePoint x) const {
  for (const PlanePoint& forbidden : (*layers_)[static_cast<std::size_t>(k * step_)]) {
    const PlanePoint y = reduced(forbidden);
    if (y == x) return true;
  }
  return false;
}

bool CosetSieve::is_free(PlanePoint w) {
  PlanePoint x{0, 0};
  for (long k = 1; k <= multiples_; ++k) {
    ++work_;
    // x = k w reduced, by additions only: this is the innermost loop of the search.
    x.y += w.y;
    x.z += w.z;
    if (x.y >= b_) {
      x.y -= b_;
      x.z -= r_;
    }
    if (x.z < 0) x.z += c_;
    if (x.z >= c_) x.z -= c_;
    const std::uint64_t marks = marks_[static_cast<std::size_t>(x.y * c_ + x.z)];
    // With at most 64 multiples a mark names its layer; otherwise two layers may share it.
    if ((marks >> (k % 64) & 1U) != 0 && (multiples_ <= 64 || layer_holds(k, x))) return false;
  }
  return true;
}

}  // namespace flatdt::ref
