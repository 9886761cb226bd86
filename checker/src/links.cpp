// The condition links.spheres: the link of the base lift of a vertex v consists of the simplices opposite to
// it in the cells of its star.   Source: FORMAT.md; docs/soundness.md, section 6.
#include <algorithm>

#include "context.hpp"
#include "star.hpp"

namespace flatdt::checker {

bool is_doubled(const Star& star, const Star::Facet& facet) {
  return facet.occurrences == 2 && star.apex(facet.first) == star.apex(facet.second);
}

const char* link_defect(const Star& star, std::size_t corners, UnionFind& components) {
  const bool plane = corners == 3;
  components.reset(star.simplices().size());
  for (const Star::Facet& facet : star.facets()) {
    if (facet.occurrences != 2 || is_doubled(star, facet)) {
      return plane ? "a-vertex-of-the-link-has-not-two-edges" : "an-edge-of-the-link-has-not-two-triangles";
    }
    components.join(facet.first.simplex, facet.second.simplex);
  }
  if (components.count() != 1) return "the-link-is-not-connected";
  if (plane || star.lifts().size() + star.simplices().size() == star.facets().size() + 2) return nullptr;
  return "the-Euler-number-of-the-link-is-not-2";
}

std::size_t distinct_cells(const Star& star, std::size_t corners) {
  const auto doubled = std::count_if(star.facets().begin(), star.facets().end(),
                                     [&](const Star::Facet& facet) { return is_doubled(star, facet); });
  return star.simplices().size() - static_cast<std::size_t>(doubled) / (corners - 1);
}

void check_links(const Context& context) {
  using enum ConditionName;
  if (!context.has(facets_paired) || !context.has(cells_nondegenerate)) return;
  if (const std::optional<Faces::BadLink>& bad = context.faces.bad_link) {
    context.fails(links_spheres, {{"vertex", lift_text(context, bad->vertex, kIdentity)},
                                  {"reason", bad->reason},
                                  {"cells-at-vertex", number_text(bad->cells)},
                                  {"vertices-of-link", number_text(bad->vertices)}});
  } else {
    context.holds(links_spheres, {{"links", number_text(context.complex.vertices.size())}});
  }
}

}  // namespace flatdt::checker
