#include "draft.hpp"

#include <algorithm>

#include "flatdt/ref/instance_format.hpp"

namespace flatdt::edits {

using ref::Isometry;

std::uint32_t Draft::index_of(const Isometry& g) {
  std::vector<Isometry>& elements = case_.triangulation.elements;
  if (index_.empty())
    for (std::uint32_t k = 0; k < elements.size(); ++k) index_.emplace(elements[k], k);
  const auto [found, added] = index_.emplace(g, static_cast<std::uint32_t>(elements.size()));
  if (added) elements.push_back(g);
  return found->second;
}

FileCell Draft::moved(const Isometry& g, FileCell cell) {
  for (std::size_t i = 0; i <= static_cast<std::size_t>(case_.instance.dimension); ++i)
    cell[i] = moved(g, cell[i]);
  return cell;
}

void Draft::remove_cells(std::vector<std::size_t> numbers) {
  std::sort(numbers.begin(), numbers.end(), std::greater<>());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  for (const std::size_t c : numbers) cells().erase(cells().begin() + static_cast<std::ptrdiff_t>(c));
}

void Draft::set_generators(std::vector<Isometry> generators) {
  case_.instance.generators = std::move(generators);
  case_.instance.generators_given = true;
}

Files Draft::files() const {
  return {ref::write_instance(case_.instance), ref::write_triangulation(case_.triangulation, {})};
}

}  // namespace flatdt::edits
