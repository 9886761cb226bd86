/// Texts as triangulation files: the first byte chooses dimension and number of points of the instance, the
/// rest is the text. Both parsers accept the same texts and read the same data; what ref writes means what it
/// read.
#include <map>
#include <utility>

#include "../engine/expect.hpp"
#include "../engine/laws.hpp"
#include "../engine/memory_stream.hpp"
#include "../engine/target.hpp"
#include "flatdt/checker/errors.hpp"
#include "flatdt/checker/input.hpp"
#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "flatdt/ref/triangulation_format.hpp"
#include "line_of.hpp"

namespace {

using flatdt::fuzz::expect;
namespace checker = flatdt::checker;
namespace ref = flatdt::ref;

struct Setting {
  int dimension;
  std::size_t points;
};

Setting setting_of(std::span<const std::uint8_t> bytes) {
  const int first = bytes.empty() ? 0 : bytes[0];
  return {2 + first % 2, 1 + static_cast<std::size_t>(first / 2) % 100};
}

std::string text_of(std::span<const std::uint8_t> bytes) {
  return bytes.empty() ? std::string()
                       : std::string(reinterpret_cast<const char*>(bytes.data()) + 1, bytes.size() - 1);
}

/// What the checker looks at of an instance before a triangulation of it. Made once for each setting.
const checker::Instance& instance_of(const Setting& setting) {
  static std::map<std::pair<int, std::size_t>, checker::Instance> instances;
  checker::Instance& instance = instances[{setting.dimension, setting.points}];
  instance.dimension = setting.dimension;
  instance.points.resize(setting.points);
  return instance;
}

bool same(const ref::Isometry& a, const checker::Seitz& b) {
  for (int i = 0; i < a.dimension(); ++i) {
    const auto row = static_cast<std::size_t>(i);
    if (a.translation[i].mpq() != b.translation[row]) return false;
    for (int j = 0; j < a.dimension(); ++j)
      if (a.linear(i, j).mpq() != b.linear[row][static_cast<std::size_t>(j)]) return false;
  }
  return true;
}

void expect_same(const ref::Triangulation& a, const checker::Triangulation& b) {
  expect(a.has_subgroup == b.subgroup.has_value(), "both parsers read a subgroup or none");
  if (a.has_subgroup) {
    expect(a.subgroup.size() == b.subgroup->size(), "both parsers read as many generators of the subgroup");
    for (std::size_t k = 0; k < a.subgroup.size(); ++k)
      expect(same(a.subgroup[k], (*b.subgroup)[k]), "both parsers read the same subgroup");
  }
  expect(a.elements.size() == b.elements.size(), "both parsers read as many elements");
  for (std::size_t k = 0; k < a.elements.size(); ++k)
    expect(same(a.elements[k], b.element(k)), "both parsers read the same elements");
  expect(a.cells.size() == b.cells.size(), "both parsers read as many cells");
  for (std::size_t k = 0; k < a.cells.size(); ++k)
    for (std::size_t i = 0; i <= static_cast<std::size_t>(a.dimension); ++i)
      expect(a.cells[k][i].point == b.cells[k][i].point && a.cells[k][i].element == b.cells[k][i].element,
             "both parsers read the same cells");
}

void expect_round_trip(const ref::Triangulation& triangulation, const Setting& setting) {
  std::string text;
  try {
    text = ref::write_triangulation(triangulation, {});
  } catch (const ref::LimitReached&) {
    return;
  }
  const ref::Triangulation again = ref::parse_triangulation(text, "again", setting.dimension, setting.points);
  expect(again.elements == triangulation.elements && again.subgroup == triangulation.subgroup &&
             again.cells.size() == triangulation.cells.size(),
         "what is written means what was read");
  expect(ref::write_triangulation(again, {}) == text, "what is written is canonical");
}

}  // namespace

namespace flatdt::fuzz {

std::vector<File> print(std::span<const std::uint8_t> bytes) {
  const Setting setting = setting_of(bytes);
  std::string instance = "flatdt-instance 1\ndimension " + std::to_string(setting.dimension) + "\nmanifold " +
                         (setting.dimension == 2 ? "torus" : "torocosm") + "\npoints " +
                         std::to_string(setting.points) + "\n";
  for (std::size_t k = 0; k < setting.points; ++k) {
    instance += "  " + std::to_string(k) + "/" + std::to_string(setting.points);
    instance += setting.dimension == 2 ? " 0\n" : " 0 0\n";
  }
  return {{"instance", instance}, {"triangulation", text_of(bytes)}};
}

/// An instance and a triangulation.
std::optional<Bytes> encode(const std::vector<std::string>& texts) {
  if (texts.size() != 2) return std::nullopt;
  try {
    const ref::Instance instance = ref::parse_instance(texts[0], "instance");
    if (instance.points.size() > 100) return std::nullopt;
    Bytes bytes = {static_cast<std::uint8_t>((instance.dimension - 2) +
                                             2 * static_cast<int>(instance.points.size() - 1))};
    bytes.insert(bytes.end(), texts[1].begin(), texts[1].end());
    return bytes;
  } catch (const ref::InvalidInput&) {
    return std::nullopt;
  }
}

}  // namespace flatdt::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Setting setting = setting_of({data, size});
  const std::string text = text_of({data, size});
  std::optional<ref::Triangulation> by_ref;
  std::optional<checker::Triangulation> by_checker;
  try {
    by_ref = ref::parse_triangulation(text, "f", setting.dimension, setting.points);
  } catch (const ref::InvalidInput& error) {
    expect(flatdt::fuzz::line_of(error.what()) > 0, "ref names a line");
  }
  try {
    flatdt::fuzz::MemoryStream in(text);
    by_checker = checker::parse_triangulation(in, "f", instance_of(setting));
  } catch (const checker::MalformedInput& error) {
    expect(flatdt::fuzz::line_of(error.what()) > 0, "the checker names a line");
  }
  expect(by_ref.has_value() == by_checker.has_value(), "both parsers accept the same triangulations");
  if (!by_ref) return 0;
  expect_same(*by_ref, *by_checker);
  if (flatdt::fuzz::is_asked({data, size}, 0, 4)) expect_round_trip(*by_ref, setting);
  return 0;
}
