// The parser of triangulation files.   Source: FORMAT.md, "Triangulation".
#include <map>
#include <string>
#include <string_view>

#include "flatdt/checker/errors.hpp"
#include "flatdt/checker/input.hpp"
#include "id_map.hpp"
#include "lexer.hpp"
#include "parse_element.hpp"
#include "reserve_ahead.hpp"

namespace flatdt::checker {
namespace {

constexpr std::uint64_t kMaxElements = 100'000'000;
constexpr std::uint64_t kMaxCells = 1'000'000'000;

/// Stores each distinct number once: elements repeat a few numbers very often.
class NumberPool {
 public:
  explicit NumberPool(std::vector<Rational>& numbers) : numbers_(numbers) {}

  std::uint32_t read(Lexer& lexer) {
    Rational value;
    lexer.number("an entry of an element", value);
    const auto next = static_cast<std::uint32_t>(numbers_.size());
    const bool is_short = value.get_den() == 1 && value.get_num().fits_slong_p();
    const std::uint32_t number =
        is_short ? integers_.insert(static_cast<std::uint64_t>(value.get_num().get_si()), next)
                 : others_.try_emplace(value.get_str(16), next).first->second;
    if (number == next) numbers_.push_back(std::move(value));
    return number;
  }

 private:
  std::vector<Rational>& numbers_;
  IdMap integers_;  // by the two's complement
  std::map<std::string, std::uint32_t> others_;
};

inline std::uint32_t parse_index(Lexer& lexer, std::string_view what, std::size_t size) {
  if (size == 0) {
    lexer.next();
    lexer.fail(std::string(what) + " out of range: there are none, found " + lexer.found());
  }
  return static_cast<std::uint32_t>(lexer.count(what, 0, size - 1));
}

}  // namespace

Seitz Triangulation::element(std::size_t k) const {
  Seitz g;
  const auto d = static_cast<std::size_t>(dimension);
  for (std::size_t row = 0; row < d; ++row) {
    for (std::size_t i = 0; i < d; ++i) g.linear[row][i] = numbers[elements[k][row * (d + 1) + i]];
    g.translation[row] = numbers[elements[k][row * (d + 1) + d]];
  }
  return g;
}

Triangulation parse_triangulation(std::istream& in, const std::string& file, const Instance& instance) {
  Lexer lexer(in, file);
  lexer.expect("flatdt-triangulation");
  lexer.expect("1");
  Triangulation result;
  result.dimension = instance.dimension;
  const auto d = static_cast<std::size_t>(instance.dimension);

  std::string keyword(lexer.next());
  if (keyword == "subgroup") {
    result.subgroup = parse_generators(lexer, instance.dimension, 0);
    keyword = lexer.next();
  }
  if (keyword != "elements") {
    lexer.fail("expected 'elements' (sections: subgroup, elements, cells, in this order), found " +
               lexer.found());
  }
  const std::uint64_t element_count = lexer.count("the number of elements", 0, kMaxElements);
  NumberPool pool(result.numbers);
  for (std::uint64_t k = 0; k < element_count; ++k) {
    std::array<std::uint32_t, 12>& entries = result.elements.emplace_back();
    for (std::size_t i = 0; i < d * (d + 1); ++i) entries[i] = pool.read(lexer);
  }
  lexer.expect("cells");
  const std::uint64_t cell_count = lexer.count("the number of cells", 0, kMaxCells);
  for (std::uint64_t c = 0; c < cell_count; ++c) {
    reserve_ahead(result.cells, cell_count);
    FileCell& cell = result.cells.emplace_back();
    for (std::size_t i = 0; i <= d; ++i) {
      cell[i].point = parse_index(lexer, "a point index", instance.points.size());
      cell[i].element = parse_index(lexer, "an element index", result.elements.size());
    }
  }
  lexer.expect_end();
  return result;
}

}  // namespace flatdt::checker
