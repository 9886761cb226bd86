#include "witness_text.hpp"

#include <charconv>

#include "flatdt/ref/errors.hpp"
#include "lexer.hpp"

namespace flatdt::ref {
namespace {

constexpr std::size_t kMaxNumberBytes = 65536;

class Cursor {
 public:
  explicit Cursor(std::string_view text) : rest_(text) {}
  [[nodiscard]] bool at_end() const { return rest_.empty(); }
  bool accept(char c) {
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }
  /// Up to the next of the characters that may follow a number.
  std::optional<Rational> number() {
    const std::string_view token = rest_.substr(0, rest_.find_first_of(",;|)]*"));
    rest_.remove_prefix(token.size());
    if (token.size() > kMaxNumberBytes) return std::nullopt;
    try {
      return parse_number(token);
    } catch (const InvalidInput&) {
      return std::nullopt;
    }
  }
  std::optional<std::uint32_t> index(std::size_t bound) {
    std::uint32_t value = 0;
    const char* const end = rest_.data() + rest_.size();
    const auto [stop, error] = std::from_chars(rest_.data(), end, value);
    if (error != std::errc{} || value >= bound) return std::nullopt;
    rest_.remove_prefix(static_cast<std::size_t>(stop - rest_.data()));
    return value;
  }

 private:
  std::string_view rest_;
};

std::optional<Vector> read_point(Cursor& cursor, int dimension) {
  if (!cursor.accept('(')) return std::nullopt;
  Vector point(dimension);
  for (int i = 0; i < dimension; ++i) {
    const auto x = cursor.number();
    if (!x || !cursor.accept(i + 1 < dimension ? ',' : ')')) return std::nullopt;
    point[i] = *x;
  }
  return point;
}

std::optional<Isometry> read_element(Cursor& cursor, int dimension) {
  if (!cursor.accept('[')) return std::nullopt;
  Isometry element{Matrix(dimension), Vector(dimension)};
  for (int i = 0; i < dimension; ++i) {
    for (int j = 0; j < dimension; ++j) {
      const auto x = cursor.number();
      if (!x || !cursor.accept(j + 1 < dimension ? ',' : '|')) return std::nullopt;
      element.linear(i, j) = *x;
    }
    const auto x = cursor.number();
    if (!x || !cursor.accept(i + 1 < dimension ? ';' : ']')) return std::nullopt;
    element.translation[i] = *x;
  }
  return element;
}

/// Items with separators between them, up to the end of the text.
template <typename Item, typename Read>
std::optional<std::vector<Item>> read_list(std::string_view text, char separator, const Read& read) {
  Cursor cursor(text);
  std::vector<Item> items;
  do {
    std::optional<Item> item = read(cursor);
    if (!item) return std::nullopt;
    items.push_back(std::move(*item));
  } while (cursor.accept(separator));
  if (!cursor.at_end()) return std::nullopt;
  return items;
}

}  // namespace

std::optional<std::vector<Vector>> read_points(std::string_view text, int dimension) {
  return read_list<Vector>(text, ';', [&](Cursor& cursor) { return read_point(cursor, dimension); });
}

std::optional<std::vector<Vector>> read_lifts(std::string_view text, const Instance& instance) {
  return read_list<Vector>(text, ';', [&](Cursor& cursor) -> std::optional<Vector> {
    const auto element = read_element(cursor, instance.dimension);
    if (!element || !cursor.accept('*')) return std::nullopt;
    const auto point = cursor.index(instance.points.size());
    if (!point) return std::nullopt;
    return *element * instance.points[*point];
  });
}

std::optional<std::vector<std::uint32_t>> read_indices(std::string_view text, std::size_t bound) {
  return read_list<std::uint32_t>(text, ',', [&](Cursor& cursor) { return cursor.index(bound); });
}

}  // namespace flatdt::ref
