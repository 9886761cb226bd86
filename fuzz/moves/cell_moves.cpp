/// Moves of the triangulation: those that keep it right (other lifts, other order), and those that break it.
#include <algorithm>

#include "../specimen/known_group.hpp"
#include "../specimen/quotient.hpp"
#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/triangulate.hpp"
#include "moves.hpp"

namespace flatdt::fuzz {
namespace {

using ref::Isometry;

std::size_t corners(const Specimen& specimen) {
  return static_cast<std::size_t>(specimen.dimension()) + 1;
}

/// The number of an element in the list, added if it is new and there is room.
std::optional<std::uint8_t> number_of(Specimen& specimen, const CodedElement& element) {
  auto& elements = specimen.elements;
  const auto found = std::find(elements.begin(), elements.end(), element);
  if (found == elements.end()) {
    if (elements.size() >= kMaxElements) return std::nullopt;
    elements.push_back(element);
    return static_cast<std::uint8_t>(elements.size() - 1);
  }
  return static_cast<std::uint8_t>(found - elements.begin());
}

/// g times the element of a vertex, as a coded element. For a named group it stays coded while small.
CodedElement moved(const Specimen& specimen, const Isometry& g, const CodedElement& element) {
  const Isometry product = g * element_of(specimen, element);
  if (const NamedGroup* group = specimen.named()) {
    for (std::size_t c = 0; c < group->cosets.size(); ++c) {
      if (group->cosets[c].linear != product.linear) continue;
      const ref::Vector shift = product.translation - group->cosets[c].translation;
      CodedElement coded;
      coded.coset = static_cast<std::uint8_t>(c);
      bool fits = true;
      for (int i = 0; i < product.dimension(); ++i) {
        fits = fits && shift[i].is_integer() && abs(shift[i]) <= ref::Rational(127);
        if (fits)
          coded.shift[static_cast<std::size_t>(i)] = static_cast<std::int8_t>(shift[i].numerator().to_long());
      }
      if (fits) return coded;
    }
  }
  CodedElement listed;
  listed.listed = product;
  return listed;
}

bool move_vertex(Specimen& specimen, CodedVertex& vertex, const Isometry& g) {
  const auto number = number_of(specimen, moved(specimen, g, specimen.elements[vertex.element]));
  if (!number) return false;
  vertex.element = *number;
  return true;
}

/// The whole cell by one element: the same cell where the element is in H.
bool move_cell(Specimen& specimen, CodedCell cell, std::size_t at, const Isometry& g) {
  for (std::size_t i = 0; i < corners(specimen); ++i)
    if (!move_vertex(specimen, cell[i], g)) return false;
  specimen.cells[at] = cell;
  return true;
}

/// Two cells that share d vertices as listed are replaced by those of a bistellar flip: 2-2 in the plane, 2-3
/// in space. With other lifts of the cells the facet is not found: no matter.
bool flip(Specimen& specimen, Random& random) {
  const std::size_t n = specimen.cells.size();
  const std::size_t m = corners(specimen);
  const std::size_t a = random.index(n);
  for (std::size_t step = 1; step < n; ++step) {
    const std::size_t b = (a + step) % n;
    const CodedCell first = specimen.cells[a];
    const CodedCell second = specimen.cells[b];
    std::vector<CodedVertex> shared;
    std::vector<CodedVertex> apices;
    for (std::size_t i = 0; i < m; ++i) {
      const auto end = second.begin() + static_cast<std::ptrdiff_t>(m);
      (std::find(second.begin(), end, first[i]) != end ? shared : apices).push_back(first[i]);
    }
    for (std::size_t i = 0; i < m; ++i)
      if (std::find(shared.begin(), shared.end(), second[i]) == shared.end()) apices.push_back(second[i]);
    if (shared.size() + 1 != m || apices.size() != 2) continue;
    std::vector<CodedCell> made;
    for (std::size_t left_out = 0; left_out < shared.size(); ++left_out) {
      CodedCell cell{};
      std::size_t k = 0;
      for (const CodedVertex& apex : apices) cell[k++] = apex;
      for (std::size_t i = 0; i < shared.size(); ++i)
        if (i != left_out) cell[k++] = shared[i];
      made.push_back(cell);
    }
    specimen.cells[a] = made[0];
    specimen.cells[b] = made[1];
    if (made.size() == 3 && n < kMaxCells) specimen.cells.push_back(made[2]);
    return true;
  }
  return false;
}

/// A cell becomes d+1, all at a new vertex.
bool split(Specimen& specimen, Random& random, std::size_t at) {
  const CodedCell cell = specimen.cells[at];
  const CodedVertex vertex = {static_cast<std::uint8_t>(random.index(specimen.points.size())),
                              static_cast<std::uint8_t>(random.index(specimen.elements.size()))};
  if (specimen.cells.size() + corners(specimen) > kMaxCells) return false;
  for (std::size_t i = 0; i < corners(specimen); ++i) {
    CodedCell part = cell;
    part[i] = vertex;
    if (i == 0) {
      specimen.cells[at] = part;
    } else {
      specimen.cells.push_back(part);
    }
  }
  return true;
}

bool move_subgroup(Specimen& specimen, Random& random) {
  std::vector<CodedElement>& subgroup = specimen.subgroup;
  if (!specimen.has_subgroup) {
    specimen.has_subgroup = true;
    for (int i = 0; i < specimen.dimension(); ++i) {
      CodedElement translation;
      translation.shift[static_cast<std::size_t>(i)] = static_cast<std::int8_t>(1 + random.below(3));
      if (specimen.named() == nullptr) translation.listed = random_element(specimen, random);
      subgroup.push_back(translation);
    }
    return true;
  }
  if (subgroup.empty() || random.one_in(5)) {
    specimen.has_subgroup = false;
    subgroup.clear();
    return true;
  }
  CodedElement& g = subgroup[random.index(subgroup.size())];
  if (random.one_in(4)) {
    subgroup.erase(subgroup.begin() + static_cast<std::ptrdiff_t>(random.index(subgroup.size())));
  } else if (random.one_in(3) && subgroup.size() < kMaxGenerators) {
    subgroup.push_back(moved(specimen, random_element(specimen, random), g));
  } else {
    g = moved(specimen, random_element(specimen, random), g);
  }
  return true;
}

/// One vertex, wrongly.
bool break_vertex(Specimen& specimen, CodedVertex& vertex, Random& random) {
  switch (random.below(3)) {
    case 0:
      vertex.point = static_cast<std::uint8_t>(random.index(specimen.points.size()));
      return true;
    case 1:
      vertex.element = static_cast<std::uint8_t>(random.index(specimen.elements.size()));
      return true;
    default:
      return move_vertex(specimen, vertex, random_element(specimen, random));
  }
}

}  // namespace

bool recompute_cells(Specimen& specimen, Random& random) {
  try {
    const ref::Instance instance = instance_of(specimen);
    if (!ref::is_positive_definite(instance.gram)) return false;
    const auto group = prepared(instance);
    // A cover has 3^d sheets for each linear part at most, with about 2 or 7 cells for each point.
    const std::size_t cells = instance.points.size() * group->frame().cosets.size() *
                              (instance.dimension == 2 ? 9U * 2U : 27U * 7U);
    const bool of_cover = cells <= kMaxCells && random.one_in(2);
    return set_triangulation(specimen, of_cover ? ref::triangulate(instance, *group, {}).triangulation
                                                : quotient(instance, *group).triangulation);
  } catch (const ref::InvalidInput&) {
    return false;
  } catch (const ref::LimitReached&) {
    return false;
  }
}

bool move_cells(Specimen& specimen, Random& random) {
  if (specimen.cells.empty() || specimen.elements.empty()) return recompute_cells(specimen, random);
  const std::size_t at = random.index(specimen.cells.size());
  CodedCell& cell = specimen.cells[at];
  const std::size_t corner = random.index(corners(specimen));
  switch (random.below(11)) {
    case 0:
      return recompute_cells(specimen, random);
    case 1:
      return flip(specimen, random);
    case 2:
      return split(specimen, random, at);
    case 3:
      specimen.cells.erase(specimen.cells.begin() + static_cast<std::ptrdiff_t>(at));
      return true;
    case 4:
      if (specimen.cells.size() >= kMaxCells) return false;
      specimen.cells.push_back(CodedCell(cell));
      return true;
    case 5:
      std::swap(cell[corner], cell[random.index(corners(specimen))]);
      return true;
    case 6:
      std::swap(cell, specimen.cells[random.index(specimen.cells.size())]);
      return true;
    case 7:
      return move_cell(specimen, cell, at, random_element(specimen, random));
    case 8: {
      CodedElement& element = specimen.elements[random.index(specimen.elements.size())];
      element = moved(specimen, random_element(specimen, random), element);
      return true;
    }
    case 9:
      return move_subgroup(specimen, random);
    default: {
      CodedVertex vertex = cell[corner];
      if (!break_vertex(specimen, vertex, random)) return false;
      specimen.cells[at][corner] = vertex;
      return true;
    }
  }
}

}  // namespace flatdt::fuzz
