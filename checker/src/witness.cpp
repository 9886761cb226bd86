// Witness texts. They are computed afresh with rationals in the coordinates of the files, so that each can be
// followed by hand; nothing here decides.
#include "context.hpp"
#include "linear.hpp"

namespace flatdt::checker {

std::string number_text(std::size_t number) {
  return std::to_string(number);
}

std::string number_text(const Rational& number) {
  constexpr std::size_t kMostBits = 20'000;  // 10^6 cells with unrelated denominators sum to megabytes
  const std::size_t bits =
      mpz_sizeinbase(number.get_num_mpz_t(), 2) + mpz_sizeinbase(number.get_den_mpz_t(), 2);
  if (bits > kMostBits) return "(rational-of-" + std::to_string(bits) + "-bits)";
  return number.get_str();
}

std::string element_text(const Context& context, ElementId element) {
  return to_string(context.group.dimension, context.group.outer_seitz(context.table[element]));
}

// The base lift of v is coset * canonical = coset frame^-1 * (first point of the orbit).
std::string lift_text(const Context& context, VertexId v, ElementId offset) {
  const Vertex& vertex = context.complex.vertices[index(v)];
  const PointId point = context.orbits.first_point[index(vertex.orbit)];
  ElementTable& table = context.table;
  const ElementId from_point = table.product(vertex.coset, table.inverse(context.orbits.frame[index(point)]));
  return element_text(context, table.product(offset, from_point)) + "*" + std::to_string(index(point));
}

std::string face_text(const Context& context, const FaceKey& face) {
  std::string text;
  for (std::size_t k = 0; k < 4 && face.vertex[k] != kNone; ++k) {
    const ElementId offset = k == 0 ? kIdentity : make_id<ElementId>(face.offset[k - 1]);
    text += (k == 0 ? "" : ";") + lift_text(context, make_id<VertexId>(face.vertex[k]), offset);
  }
  return text;
}

std::vector<Vec<Rational>> cell_points(const Context& context, CellId cell) {
  std::vector<Vec<Rational>> points;
  for (std::size_t i = 0; i < context.complex.corners; ++i) {
    const FileVertex& vertex = context.triangulation.cells[index(cell)][i];
    points.push_back(apply(context.group.dimension, context.triangulation.element(vertex.element),
                           context.instance.points[vertex.point]));
  }
  return points;
}

std::string cell_text(const Context& context, CellId cell) {
  std::string text;
  for (const Vec<Rational>& point : cell_points(context, cell)) {
    text += (text.empty() ? "" : ";") + to_string(context.group.dimension, point);
  }
  return text;
}

// anchor_a offset_a[0][base_a] and its counterpart for b take the canonical facet to the two facets of the
// file.
ElementId file_gluing(const Context& context, const Occurrence& a, const Occurrence& b) {
  ElementTable& table = context.table;
  const auto to_file = [&](const Occurrence& o) {
    const Cell& cell = context.complex.cells[index(o.cell)];
    return table.product(cell.anchor, context.complex.offsets(cell)[0][o.base]);
  };
  return table.product(to_file(a), table.inverse(to_file(b)));
}

}  // namespace flatdt::checker
