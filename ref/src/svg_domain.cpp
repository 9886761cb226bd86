#include <cmath>

#include "svg_internal.hpp"

namespace flatdt::ref::picture {
namespace {

constexpr double kArrow = 13;  // page units

std::string arrow_heads(const Place& from, const Place& to, std::size_t count) {
  const double dx = to.x - from.x, dy = to.y - from.y, length = std::sqrt(dx * dx + dy * dy);
  if (!(length > 4 * kArrow)) return {};
  const double tx = dx / length * kArrow, ty = dy / length * kArrow;
  std::string text;
  for (std::size_t k = 0; k < count; ++k) {
    const double along = static_cast<double>(k) - static_cast<double>(count) / 2;
    const Place tail{(from.x + to.x) / 2 + along * tx, (from.y + to.y) / 2 + along * ty};
    text += path({{tail.x + tx, tail.y + ty},
                  {tail.x - ty * 0.55, tail.y + tx * 0.55},
                  {tail.x + ty * 0.55, tail.y - tx * 0.55}},
                 true, "arrow");
  }
  return text;
}

}  // namespace

Domain::Domain(const ShownGroup& shown)
    : corner(2), sides{Rational(1), Rational(1)}, is_glued(shown.has_copies) {
  const PictureGroup& group = shown.group;
  if (!is_glued || group.cosets.size() != 2) return;
  // The lattice of pg is rectangular, and the reduced basis of such a lattice is along the axes: the glide
  // reflection fixes one basis vector and turns the other. Its mirror line is where the turned coordinate is
  // half the translation; the domain begins there, so that its ends are glued to each other.
  const Isometry& g = group.cosets[1];
  const Vector t = group.inverse * g.translation;
  const Rational half(Integer(1), Integer(2));
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const Vector along = group.basis.column(static_cast<int>(axis));
    const int across = 1 - static_cast<int>(axis);
    const Vector turned = group.basis.column(across);
    if (g.linear * along != along || g.linear * turned != -turned) continue;
    glide = axis;
    sides[axis] = half;
    const Rational line = half * t[across];
    corner[across] = line - half * Rational(floor(Rational(2) * line));
  }
}

bool Domain::contains(const Vector& u) const {
  for (std::size_t i = 0; i < 2; ++i) {
    const Rational inner = u[static_cast<int>(i)] - corner[static_cast<int>(i)];
    if (inner < Rational(0) || inner >= sides[i]) return false;
  }
  return true;
}

Vector Domain::shift_into_cell(const PictureGroup& group, const Vector& x) const {
  Vector u = group.inverse * x - corner;
  for (int i = 0; i < 2; ++i) u[i] = -Rational(floor(u[i]));
  return group.basis * u;
}

Isometry Domain::into(const PictureGroup& group, const Vector& x) const {
  for (const Isometry& g : group.cosets) {
    const Vector image = g * x, shift = shift_into_cell(group, image);
    if (contains(group.inverse * (image + shift))) return Isometry::translate(shift) * g;
  }
  return Isometry::translate(shift_into_cell(group, x));
}

std::string domain_text(const Domain& domain, const Page& page) {
  const double u = domain.corner[0].to_double(), v = domain.corner[1].to_double();
  const double du = domain.sides[0].to_double(), dv = domain.sides[1].to_double();
  const Place a = page.place(u, v), b = page.place(u + du, v), c = page.place(u + du, v + dv),
              d = page.place(u, v + dv);
  // The glide reflection glues the two sides across its direction with a turn.
  const bool turns_first = domain.glide == 1, turns_second = domain.glide == 0;
  std::string text = path({a, b, c, d}, true, "domain");
  if (!domain.is_glued) return text;
  text += arrow_heads(a, b, 1) + (turns_first ? arrow_heads(c, d, 1) : arrow_heads(d, c, 1));
  text += arrow_heads(a, d, 2) + (turns_second ? arrow_heads(c, b, 2) : arrow_heads(b, c, 2));
  return text;
}

std::string lattice_cell_text(const PictureGroup& group, const Page& page) {
  const Vector zero(2), a = group.basis.column(0), b = group.basis.column(1);
  return path({page.place(zero), page.place(a), page.place(a + b), page.place(b)}, true, "lattice");
}

}  // namespace flatdt::ref::picture
