#include "judged.hpp"

#include "../engine/expect.hpp"
#include "../engine/memory_stream.hpp"
#include "flatdt/checker/errors.hpp"

namespace flatdt::fuzz {

std::optional<checker::Instance> read_instance(const std::string& text) {
  try {
    MemoryStream in(text);
    return checker::parse_instance(in, "instance");
  } catch (const checker::MalformedInput&) {
    return std::nullopt;
  }
}

std::optional<checker::Triangulation> read_triangulation(const std::string& text,
                                                         const checker::Instance& instance) {
  try {
    MemoryStream in(text);
    return checker::parse_triangulation(in, "triangulation", instance);
  } catch (const checker::MalformedInput&) {
    return std::nullopt;
  }
}

checker::Triangulation for_checker(const ref::Triangulation& triangulation) {
  checker::Triangulation result;
  result.dimension = triangulation.dimension;
  const auto d = static_cast<std::size_t>(triangulation.dimension);
  const auto entry = [](const ref::Isometry& g, std::size_t row, std::size_t column) -> mpq_class {
    const auto i = static_cast<int>(row);
    const auto j = static_cast<int>(column);
    return j == g.dimension() ? g.translation[i].mpq() : g.linear(i, j).mpq();
  };
  if (triangulation.has_subgroup) {
    result.subgroup.emplace();
    for (const ref::Isometry& g : triangulation.subgroup) {
      checker::Seitz& copy = result.subgroup->emplace_back();
      for (std::size_t i = 0; i < d; ++i) {
        for (std::size_t j = 0; j < d; ++j) copy.linear[i][j] = entry(g, i, j);
        copy.translation[i] = entry(g, i, d);
      }
    }
  }
  for (const ref::Isometry& g : triangulation.elements) {
    std::array<std::uint32_t, 12>& copy = result.elements.emplace_back();
    for (std::size_t i = 0; i < d; ++i) {
      for (std::size_t j = 0; j <= d; ++j) {
        copy[i * (d + 1) + j] = static_cast<std::uint32_t>(result.numbers.size());
        result.numbers.push_back(entry(g, i, j));
      }
    }
  }
  for (const auto& cell : triangulation.cells) {
    checker::FileCell& copy = result.cells.emplace_back();
    for (std::size_t k = 0; k <= d; ++k) copy[k] = {cell[k].point, cell[k].element};
  }
  return result;
}

std::optional<checker::Verdict> judge(const checker::Instance& instance,
                                      const checker::Triangulation& triangulation) {
  checker::Verdict verdict = checker::check(instance, triangulation);
  if (verdict.outcome != checker::Outcome::unknown) return verdict;
  expect(verdict.reason.rfind("limit of the checker", 0) == 0, "no verdict is unknown: " + verdict.reason);
  return std::nullopt;
}

}  // namespace flatdt::fuzz
