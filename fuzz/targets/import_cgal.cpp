/// Texts as the streams that CGAL writes of periodic triangulations: the first byte chooses the dimension,
/// the rest is the stream. What the importer accepts is read a second time, and every corner of every cell is
/// where the stream says; as files, what was imported has the same verdict.
#include "../../checker/importers/cgal_stream.hpp"

#include "../engine/expect.hpp"
#include "../engine/laws.hpp"
#include "../engine/memory_stream.hpp"
#include "../engine/target.hpp"
#include "flatdt/checker/errors.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "judged.hpp"
#include "line_of.hpp"

namespace flatdt::fuzz {
namespace {

int dimension_of(std::span<const std::uint8_t> bytes) {
  return bytes.empty() ? 2 : 2 + bytes[0] % 2;
}

std::string text_of(std::span<const std::uint8_t> bytes) {
  return bytes.empty() ? std::string() : std::string(bytes.begin() + 1, bytes.end());
}

/// A stream as it stands, read without the importer.
class Stream {
 public:
  /// Requires: the importer has accepted the text.
  Stream(const std::string& text, int dimension) : d_(static_cast<std::size_t>(dimension)) {
    split(text);
    for (std::size_t k = 0; k < 2; ++k) read_place();
    for (std::size_t k = 0; k < d_; ++k) sheets_ = next();
    const std::size_t vertices = next();
    for (std::size_t v = 0; v < vertices; ++v) {
      read_place();
      std::array<std::size_t, 3> offset{};
      for (std::size_t k = 0; k < d_ && sheets_ != 1; ++k) offset[k] = next();
      offsets_.push_back(offset);
    }
    cells_ = next();
    corners_ = at_;
    bits_ = at_ + 2 * cells_ * (d_ + 1);  // behind the vertices and the neighbours
    read_numbers();
  }

  [[nodiscard]] std::size_t cells() const { return cells_; }
  [[nodiscard]] std::size_t sheets() const { return sheets_; }
  [[nodiscard]] std::size_t vertices() const { return offsets_.size(); }
  [[nodiscard]] ref::Rational period(std::size_t axis) const {
    const int i = static_cast<int>(axis);
    return places_[1][i] - places_[0][i];
  }
  [[nodiscard]] const ref::Vector& place(std::size_t vertex) const { return places_[vertex + 2]; }

  [[nodiscard]] ref::Vector corner(std::size_t cell, std::size_t k) const {
    const std::size_t at = cell * (d_ + 1) + k;
    const std::size_t vertex = std::stoul(tokens_[corners_ + at]), bits = std::stoul(tokens_[bits_ + at]);
    ref::Vector result = place(vertex);
    for (std::size_t axis = 0; axis < d_; ++axis) {
      const std::size_t periods = offsets_[vertex][axis] + sheets_ * (bits >> (d_ - 1 - axis) & 1U);
      result[static_cast<int>(axis)] += ref::Rational(static_cast<long>(periods)) * period(axis);
    }
    return result;
  }

 private:
  void split(const std::string& text) {
    std::string token;
    bool comment = false;
    for (const char c : text + '\n') {
      if (c == '\n') comment = false;
      if (c == '#') comment = true;
      const bool blank = comment || c == ' ' || ('\t' <= c && c <= '\r');
      if (!blank) token += c;
      if (blank && !token.empty()) tokens_.push_back(std::move(token));
      if (blank) token.clear();
    }
  }
  void read_place() {
    for (std::size_t k = 0; k < d_; ++k) numbers_ += tokens_[at_++] + (k + 1 == d_ ? "\n" : " ");
  }
  std::size_t next() { return std::stoul(tokens_[at_++]); }
  /// By ref's parser, as points of a torus.
  void read_numbers() {
    const std::string dimension = std::to_string(d_), count = std::to_string(offsets_.size() + 2);
    places_ =
        ref::parse_instance("flatdt-instance 1\ndimension " + dimension + "\nmanifold " +
                                (d_ == 2 ? "torus" : "torocosm") + "\npoints " + count + "\n" + numbers_,
                            "numbers")
            .points;
  }

  std::size_t d_;
  std::vector<std::string> tokens_;
  std::size_t at_ = 0;
  std::string numbers_;
  std::size_t sheets_ = 1, cells_ = 0, corners_ = 0, bits_ = 0;  // the last two: where they begin
  std::vector<std::array<std::size_t, 3>> offsets_;
  std::vector<ref::Vector> places_;
};

bool same(const ref::Vector& a, const checker::Vec<checker::Rational>& b) {
  for (int k = 0; k < a.dimension(); ++k)
    if (a[k].mpq() != b[static_cast<std::size_t>(k)]) return false;
  return true;
}

/// The translations by so many periods, one for each axis.
void expect_periods(const std::vector<checker::Seitz>& elements, const Stream& stream, long times) {
  for (std::size_t k = 0; k < elements.size(); ++k)
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const ref::Rational length = i == k ? ref::Rational(times) * stream.period(k) : ref::Rational(0);
      expect(elements[k].translation[i] == length.mpq(), "generators are the periods of the torus");
      for (std::size_t j = 0; j < elements.size(); ++j)
        expect(elements[k].linear[i][j] == (i == j ? 1 : 0), "generators are translations");
    }
}

void expect_what_stands_there(const checker::Imported& imported, const std::string& text, int dimension) {
  const Stream stream(text, dimension);
  const checker::Triangulation& t = imported.triangulation;
  const auto d = static_cast<std::size_t>(dimension);
  expect(t.cells.size() == stream.cells(), "no cell is lost or made");
  expect(t.subgroup.has_value() == (stream.sheets() != 1), "a cover has a subgroup");
  expect(imported.instance.generators.size() == d && (!t.subgroup || t.subgroup->size() == d),
         "there is a generator for each axis");
  expect_periods(imported.instance.generators, stream, 1);
  if (t.subgroup) expect_periods(*t.subgroup, stream, static_cast<long>(stream.sheets()));
  std::vector<checker::Seitz> elements;
  for (std::size_t k = 0; k < t.elements.size(); ++k) elements.push_back(t.element(k));
  for (std::size_t c = 0; c < t.cells.size(); ++c)
    for (std::size_t k = 0; k <= d; ++k) {
      const checker::FileVertex vertex = t.cells[c][k];
      const checker::Seitz& element = elements[vertex.element];
      checker::Vec<checker::Rational> place = imported.instance.points[vertex.point];
      for (std::size_t i = 0; i < d; ++i) {
        place[i] += element.translation[i];
        for (std::size_t j = 0; j < d; ++j)
          expect(element.linear[i][j] == (i == j ? 1 : 0), "elements are translations");
      }
      expect(same(stream.corner(c, k), place), "every corner is where the stream says");
    }
  for (std::size_t v = 0; v < stream.vertices(); ++v) {
    bool known = false;
    for (const auto& point : imported.instance.points) known = known || same(stream.place(v), point);
    expect(known, "every vertex is a point, used or not");
  }
}

void write(std::string& text, const checker::Seitz& element, std::size_t d) {
  for (std::size_t i = 0; i < d; ++i) {
    for (std::size_t j = 0; j < d; ++j) text += element.linear[i][j].get_str() + " ";
    text += element.translation[i].get_str() + (i + 1 == d ? "\n" : "  ");
  }
}

std::string instance_file(const checker::Instance& instance) {
  const auto d = static_cast<std::size_t>(instance.dimension);
  std::string text = "flatdt-instance 1\ndimension " + std::to_string(d) + "\ngenerators " +
                     std::to_string(instance.generators.size()) + "\n";
  for (const checker::Seitz& g : instance.generators) write(text, g, d);
  text += "points " + std::to_string(instance.points.size()) + "\n";
  for (const auto& point : instance.points)
    for (std::size_t k = 0; k < d; ++k) text += point[k].get_str() + (k + 1 == d ? "\n" : " ");
  return text;
}

std::string triangulation_file(const checker::Triangulation& t) {
  const auto d = static_cast<std::size_t>(t.dimension);
  std::string text = "flatdt-triangulation 1\n";
  if (t.subgroup) text += "subgroup " + std::to_string(t.subgroup->size()) + "\n";
  if (t.subgroup)
    for (const checker::Seitz& g : *t.subgroup) write(text, g, d);
  text += "elements " + std::to_string(t.elements.size()) + "\n";
  for (std::size_t k = 0; k < t.elements.size(); ++k) write(text, t.element(k), d);
  text += "cells " + std::to_string(t.cells.size()) + "\n";
  for (const checker::FileCell& cell : t.cells)
    for (std::size_t k = 0; k <= d; ++k)
      text += std::to_string(cell[k].point) + " " + std::to_string(cell[k].element) + (k == d ? "\n" : " ");
  return text;
}

void expect_same_verdict_as_files(const checker::Imported& imported) {
  const auto instance = read_instance(instance_file(imported.instance));
  expect(instance.has_value(), "what is imported can be written as an instance");
  const auto triangulation = read_triangulation(triangulation_file(imported.triangulation), *instance);
  expect(triangulation.has_value(), "what is imported can be written as a triangulation");
  const auto verdict = judge(imported.instance, imported.triangulation);
  const auto again = judge(*instance, *triangulation);
  expect(verdict.has_value() == again.has_value(), "as files it meets the same limits");
  if (!verdict) return;
  expect(verdict->outcome == again->outcome, "as files it has the same verdict");
  for (std::size_t i = 0; i < checker::kConditionCount; ++i)
    expect(verdict->conditions[i].status == again->conditions[i].status &&
               verdict->conditions[i].witness == again->conditions[i].witness,
           "as files it has the same witnesses");
}

}  // namespace

std::vector<File> print(std::span<const std::uint8_t> bytes) {
  return {{dimension_of(bytes) == 2 ? "p2t2" : "p3t3", text_of(bytes)}};
}

/// A stream; of dimension 3 where it can be read as one.
std::optional<Bytes> encode(const std::vector<std::string>& texts) {
  if (texts.size() != 1) return std::nullopt;
  Bytes bytes = {1};
  try {
    MemoryStream in(texts[0]);
    static_cast<void>(checker::import_cgal(in, "f", 3));
  } catch (const checker::MalformedInput&) {
    bytes = {0};
  }
  bytes.insert(bytes.end(), texts[0].begin(), texts[0].end());
  return bytes;
}

}  // namespace flatdt::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace flatdt;
  const int dimension = fuzz::dimension_of({data, size});
  const std::string text = fuzz::text_of({data, size});
  checker::Imported imported;
  try {
    fuzz::MemoryStream in(text);
    imported = checker::import_cgal(in, "f", dimension);
  } catch (const checker::MalformedInput& error) {
    fuzz::expect(fuzz::line_of(error.what()) > 0, "the importer names a line");
    return 0;
  }
  fuzz::expect_what_stands_there(imported, text, dimension);
  if (fuzz::is_asked({data, size}, 0, 2)) fuzz::expect_same_verdict_as_files(imported);
  return 0;
}
