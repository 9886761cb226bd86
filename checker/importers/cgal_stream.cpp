#include "cgal_stream.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "final_line_break.hpp"
#include "flatdt/checker/errors.hpp"
#include "lexer.hpp"

namespace flatdt::checker {
namespace {

constexpr std::uint64_t kMostVertices = 100'000'000;
constexpr std::uint64_t kMostCells = 1'000'000'000;
constexpr std::size_t kShortPrecision = 6;  // significant digits that C++ streams write unless told otherwise

using Offset = std::array<int, 3>;

struct StoredVertex {
  std::uint32_t point;
  Offset offset;
};

/// Significant digits of a decimal token.
std::size_t digits_of(std::string_view token) {
  token = token.substr(0, token.find_first_of("eE"));
  std::size_t digits = 0;
  for (const char c : token)
    if (c >= '0' && c <= '9' && (digits > 0 || c != '0')) ++digits;
  return digits;
}

class Reader {
 public:
  Reader(std::istream& in, const std::string& file, int dimension)
      : end_(*in.rdbuf()), stream_(&end_), lexer_(stream_, file), d_(static_cast<std::size_t>(dimension)) {
    stream_.exceptions(std::ios_base::badbit);
    result_.instance.dimension = dimension;
    result_.triangulation.dimension = dimension;
  }

  Imported read() {
    read_domain();
    read_sheets();
    read_vertices();
    read_cells();
    lexer_.expect_end();
    result_.note = std::to_string(result_.instance.points.size()) + " points, " +
                   std::to_string(result_.triangulation.cells.size()) + " cells, " +
                   (sheets_ == 1 ? "one sheet" : std::to_string(copies()) + " sheets") +
                   "; coordinates are taken as the decimals of the file, neighbours are not judged";
    if (most_digits_ == kShortPrecision)
      result_.note +=
          "; no coordinate has more than 6 digits: points written with the default precision are not those "
          "that were "
          "triangulated (set the stream's precision to 17)";
    return std::move(result_);
  }

 private:
  [[nodiscard]] std::uint64_t copies() const {
    std::uint64_t product = 1;
    for (std::size_t k = 0; k < d_; ++k) product *= static_cast<std::uint64_t>(sheets_);
    return product;
  }

  Vec<Rational> read_place(const char* what) {
    Vec<Rational> place;
    for (std::size_t k = 0; k < d_; ++k) {
      const std::string_view token = lexer_.next();
      if (token.empty()) lexer_.fail("the file ends where " + std::string(what) + " must stand");
      most_digits_ = std::max(most_digits_, digits_of(token));
      try {
        place[k] = parse_number(token);
      } catch (const std::invalid_argument& error) {
        lexer_.fail(std::string(what) + ": " + error.what() + ", found " + lexer_.found());
      }
    }
    return place;
  }

  void read_domain() {
    Instance& instance = result_.instance;
    const Vec<Rational> least = read_place("a corner of the domain");
    instance.group_location = lexer_.location();
    const Vec<Rational> greatest = read_place("a corner of the domain");
    most_digits_ = 0;
    for (std::size_t k = 0; k < d_; ++k) {
      periods_[k] = greatest[k] - least[k];
      if (sgn(periods_[k]) <= 0)
        lexer_.fail("the domain is empty: its greatest corner is not above its least");
      for (std::size_t i = 0; i < d_; ++i) instance.metric[k][i] = k == i ? 1 : 0;
      instance.generators.push_back(translation(k, periods_[k]));
    }
  }

  [[nodiscard]] Seitz translation(std::size_t axis, const Rational& by) const {
    Seitz g;
    for (std::size_t i = 0; i < d_; ++i) g.linear[i][i] = 1;
    g.translation[axis] = by;
    return g;
  }

  void read_sheets() {
    for (std::size_t k = 0; k < d_; ++k) {
      const auto sheets = static_cast<int>(lexer_.count("a number of sheets", 1, 3));
      if (sheets == 2 || (k > 0 && sheets != sheets_))
        lexer_.fail("the numbers of sheets must all be 1 or all be 3, found " + lexer_.found());
      sheets_ = sheets;
    }
    if (sheets_ == 1) return;
    auto& subgroup = result_.triangulation.subgroup.emplace();
    for (std::size_t k = 0; k < d_; ++k) subgroup.push_back(translation(k, Rational(sheets_) * periods_[k]));
  }

  /// Copies repeat the coordinates of their original, so that equal coordinates are one point, in whatever
  /// order.
  void read_vertices() {
    const std::uint64_t count = lexer_.count("the number of vertices", 1, kMostVertices);
    if (count % copies() != 0)
      lexer_.fail("the number of vertices must be a multiple of the " + std::to_string(copies()) +
                  " sheets, found " + lexer_.found());
    std::map<std::vector<std::string>, std::uint32_t> known;
    for (std::uint64_t v = 0; v < count; ++v) {
      Vec<Rational> place = read_place("a coordinate");
      std::vector<std::string> key;
      for (std::size_t k = 0; k < d_; ++k) key.push_back(place[k].get_str(62));
      const auto next = static_cast<std::uint32_t>(result_.instance.points.size());
      const auto [at, fresh] = known.try_emplace(std::move(key), next);
      if (fresh) result_.instance.points.push_back(std::move(place));
      Offset offset{};
      if (sheets_ != 1)
        for (std::size_t k = 0; k < d_; ++k)
          offset[k] = static_cast<int>(lexer_.count("the offset of a vertex", 0, 2));
      vertices_.push_back({at->second, offset});
    }
  }

  void read_cells() {
    auto& cells = result_.triangulation.cells;
    const std::uint64_t count = lexer_.count("the number of cells", 0, kMostCells);
    std::vector<std::array<std::uint32_t, 4>> corners;
    for (std::uint64_t c = 0; c < count; ++c) {
      auto& corner = corners.emplace_back();
      for (std::size_t k = 0; k <= d_; ++k)
        corner[k] =
            static_cast<std::uint32_t>(lexer_.count("the index of a vertex", 0, vertices_.size() - 1));
    }
    for (std::uint64_t i = 0; i < count * (d_ + 1); ++i)
      lexer_.count("the index of a neighbour", 0, count - 1);
    for (const auto& corner : corners) {
      FileCell& cell = cells.emplace_back();
      for (std::size_t k = 0; k <= d_; ++k) {
        const std::uint64_t bits = lexer_.count("the offset of a corner", 0, (1U << d_) - 1);
        const StoredVertex& vertex = vertices_[corner[k]];
        Offset offset = vertex.offset;
        for (std::size_t axis = 0; axis < d_; ++axis)
          offset[axis] += sheets_ * static_cast<int>(bits >> (d_ - 1 - axis) & 1U);
        cell[k] = {vertex.point, element(offset)};
      }
    }
  }

  /// The number of the translation by whole periods: there are at most 6 for each axis.
  std::uint32_t element(const Offset& offset) {
    Triangulation& triangulation = result_.triangulation;
    const auto next = static_cast<std::uint32_t>(triangulation.elements.size());
    const auto [at, fresh] = elements_.try_emplace(offset, next);
    if (!fresh) return at->second;
    auto& entries = triangulation.elements.emplace_back();
    for (std::size_t row = 0; row < d_; ++row) {
      for (std::size_t i = 0; i < d_; ++i) entries[row * (d_ + 1) + i] = number(row == i ? 1 : 0);
      entries[row * (d_ + 1) + d_] = number(Rational(offset[row]) * periods_[row]);
    }
    return next;
  }

  std::uint32_t number(const Rational& value) {
    auto& numbers = result_.triangulation.numbers;
    const auto at = std::find(numbers.begin(), numbers.end(), value);
    if (at != numbers.end()) return static_cast<std::uint32_t>(at - numbers.begin());
    numbers.push_back(value);
    return static_cast<std::uint32_t>(numbers.size() - 1);
  }

  FinalLineBreak end_;
  std::istream stream_;
  Lexer lexer_;
  std::size_t d_;
  int sheets_ = 1;
  std::size_t most_digits_ = 0;
  Vec<Rational> periods_;
  std::vector<StoredVertex> vertices_;
  std::map<Offset, std::uint32_t> elements_;
  Imported result_;
};

}  // namespace

Imported import_cgal(std::istream& in, const std::string& file, int dimension) {
  return Reader(in, file, dimension).read();
}

}  // namespace flatdt::checker
