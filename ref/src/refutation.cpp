#include "flatdt/ref/refutation.hpp"

#include <algorithm>

#include "flatdt/ref/errors.hpp"
#include "witness_text.hpp"

namespace flatdt::ref {
namespace {

/// What the conditions of docs/format.md, 7, say where they fail; "%" stands for the value of the key.
struct Wording {
  const char* condition;
  const char* sentence;
};
constexpr std::array<Wording, 15> kWordings = {{
    {"subgroup.member", "a map does not belong to the group, or H has infinite index (%reason)"},
    {"vertices.complete", "%vertices vertices instead of %expected"},
    {"cells.nondegenerate", "cell %cell has volume 0"},
    {"facets.paired", "a facet of cell %cell occurs %times instead of twice"},
    {"facets.opposite", "cells %cell and %other-cell lie on the same side of their common facet"},
    {"volume.exact", "the volumes of the cells sum to %volume-of-cells instead of %expected"},
    {"delaunay.empty", "the circumscribed %ball of cell %cell has a vertex of cell %other-cell inside"},
    {"simplices.injective", "corners %corners of cell %cell are one vertex of the quotient"},
    {"skeleton.no-loop", "the ends of an edge are one vertex of the quotient"},
    {"skeleton.no-2-cycle", "two different edges have the same two ends in the quotient"},
    {"complex.intersection", "two different faces have the same vertices in the quotient"},
    {"links.spheres", "the link of a vertex is no %sphere (%reason)"},
    {"topology.connected", "the cells form %components separate pieces"},
    {"topology.euler", "the Euler number is %euler-number instead of 0"},
    {"topology.orientable", "the cells form a space that is %complex, the manifold is %manifold"},
}};

class Reader {
 public:
  Reader(const FailedCondition& failed, const Instance& instance, const Triangulation& triangulation)
      : failed_(failed), instance_(instance), triangulation_(triangulation) {
    witness_.condition = failed.name;
    witness_.sentence = sentence();
  }

  Witness read() {
    read_cells();
    read_faces();
    read_indices_of_cells();
    if (const auto list = indices("point", instance_.points.size())) witness_.point = list->front();
    return std::move(witness_);
  }

 private:
  [[nodiscard]] const std::string* value(const std::string& key) const {
    for (const auto& [name, text] : failed_.witness)
      if (name == key) return &text;
    return nullptr;
  }
  [[nodiscard]] std::string word(const std::string& key) const {
    if (key == "ball") return instance_.dimension == 2 ? "disk" : "ball";
    if (key == "sphere") return instance_.dimension == 2 ? "circle" : "sphere";
    if (key == "times") return word("occurrences") == "1" ? "once" : word("occurrences") + " times";
    const std::string* const text = value(key);
    if (text == nullptr) return "?";
    std::string plain = text->size() > 40 ? text->substr(0, 37) + "..." : *text;
    if (key == "reason") std::replace(plain.begin(), plain.end(), '-', ' ');
    // Pictures are XML and HTML: no control characters, no part of a letter of several bytes.
    for (char& c : plain)
      if (c < ' ' || c > '~') c = '?';
    return plain;
  }
  [[nodiscard]] std::string sentence() const {
    const auto* const wording = std::find_if(kWordings.begin(), kWordings.end(),
                                             [&](const Wording& w) { return failed_.name == w.condition; });
    if (wording == kWordings.end()) return "the condition fails";
    std::string text, pattern = wording->sentence;
    for (std::size_t i = 0; i < pattern.size();) {
      if (pattern[i] != '%') {
        text += pattern[i++];
        continue;
      }
      const std::size_t end =
          std::min(pattern.find_first_not_of("abcdefghijklmnopqrstuvwxyz-", i + 1), pattern.size());
      text += word(pattern.substr(i + 1, end - i - 1));
      i = end;
    }
    return text;
  }
  void note(const std::string& key) {
    witness_.notes.push_back("The value of \"" + key + "\" in the witness of " + failed_.name +
                             " makes no sense for these files.");
  }
  /// The value of a key as `read` understands it; nothing, with a note, if it does not.
  template <typename Read>
  auto understood(const std::string& key, const Read& read) -> decltype(read(std::string())) {
    const std::string* const text = value(key);
    if (text == nullptr) return std::nullopt;
    auto result = read(*text);
    if (!result) note(key);
    return result;
  }
  std::optional<std::vector<std::uint32_t>> indices(const std::string& key, std::size_t bound) {
    return understood(key, [&](const std::string& text) { return read_indices(text, bound); });
  }
  std::optional<std::vector<Vector>> points(const std::string& key, std::size_t least, std::size_t most) {
    return understood(key, [&](const std::string& text) {
      auto list = read_points(text, instance_.dimension);
      if (list && (list->size() < least || list->size() > most)) list.reset();
      return list;
    });
  }
  void add(Mark::Kind kind, std::vector<Vector> corners) {
    witness_.marks.push_back({kind, std::move(corners)});
  }

  /// The cell, its facet, the cell on the other side, the edge between two corners.
  void read_cells() {
    const auto corners_of_cell = static_cast<std::size_t>(instance_.dimension) + 1;
    const auto cell = points("cell-points", corners_of_cell, corners_of_cell);
    if (!cell) return;
    add(Mark::Kind::cell, *cell);
    const auto facet = indices("facet", corners_of_cell);
    auto apex = points("apex", 1, 1);
    if (!apex) apex = points("other-apex", 1, 1);
    if (facet) {
      std::vector<Vector> other = *cell;
      if (apex) {
        other[facet->front()] = apex->front();
        add(Mark::Kind::other_cell, other);
      }
      other.erase(other.begin() + facet->front());
      if (failed_.name != "delaunay.empty") add(Mark::Kind::face, std::move(other));
    }
    if (apex) add(Mark::Kind::point, std::move(*apex));
    if (const auto ends = indices("corners", corners_of_cell); ends && ends->size() == 2)
      add(Mark::Kind::face, {(*cell)[ends->front()], (*cell)[ends->back()]});
    if (failed_.name == "delaunay.empty") witness_.ball = circumscribed_ball(instance_.gram, *cell);
  }
  /// Faces by their vertices, where no cell gives them.
  void read_faces() {
    const bool has_facet = std::any_of(witness_.marks.begin(), witness_.marks.end(),
                                       [](const Mark& m) { return m.kind == Mark::Kind::face; });
    for (const auto& [key, kind] :
         std::initializer_list<std::pair<const char*, Mark::Kind>>{{"facet-vertices", Mark::Kind::face},
                                                                   {"edge", Mark::Kind::face},
                                                                   {"other-edge", Mark::Kind::other_face},
                                                                   {"face", Mark::Kind::face},
                                                                   {"other-face", Mark::Kind::other_face},
                                                                   {"vertex", Mark::Kind::point}}) {
      if (has_facet && std::string(key) == "facet-vertices") continue;
      auto lifts = understood(key, [&](const std::string& text) {
        auto list = read_lifts(text, instance_);
        if (list && list->size() > static_cast<std::size_t>(instance_.dimension) + 1) list.reset();
        return list;
      });
      if (lifts) add(kind, std::move(*lifts));
    }
  }
  void read_indices_of_cells() {
    for (const char* key : {"cell", "other-cell", "cells"})
      if (const auto list = indices(key, triangulation_.cells.size()))
        witness_.cells.insert(witness_.cells.end(), list->begin(), list->end());
    if (failed_.name != "subgroup.member") return;
    const auto number = indices("number", triangulation_.elements.size());
    if (!number) return;
    // The first cell that uses the element at fault.
    const auto corners = static_cast<std::size_t>(instance_.dimension) + 1;
    for (std::size_t c = 0; c < triangulation_.cells.size(); ++c)
      for (std::size_t k = 0; k < corners; ++k) {
        if (triangulation_.cells[c][k].element != number->front()) continue;
        witness_.cells.push_back(static_cast<std::uint32_t>(c));
        return;
      }
  }

  const FailedCondition& failed_;
  const Instance& instance_;
  const Triangulation& triangulation_;
  Witness witness_;
};

}  // namespace

Witness witness_of(const FailedCondition& failed, const Instance& instance,
                   const Triangulation& triangulation) {
  return Reader(failed, instance, triangulation).read();
}

std::optional<Witness> chosen_witness(const Verdict& verdict, const std::string& name,
                                      const Instance& instance, const Triangulation& triangulation) {
  std::optional<Witness> best;
  const auto rank = [](const Witness& w) { return w.marks.empty() ? w.has_figure() ? 1 : 0 : 2; };
  for (const FailedCondition& failed : verdict.failed) {
    if (!name.empty() && failed.name != name) continue;
    Witness witness = witness_of(failed, instance, triangulation);
    if (!name.empty()) return witness;
    if (!best || rank(witness) > rank(*best)) best = std::move(witness);
  }
  if (!name.empty()) throw InvalidInput("the verdict does not say that \"" + name + "\" fails");
  return best;
}

std::optional<Ball> circumscribed_ball(const Matrix& gram, const std::vector<Vector>& corners) {
  // The centre c solves <p_k - p_0, 2c - 2 p_0> = |p_k - p_0|^2 for k = 1..d.
  const int d = gram.dimension();
  Matrix rows(d);
  Vector right(d);
  for (int i = 0; i < d; ++i) {
    const Vector edge = corners[static_cast<std::size_t>(i) + 1] - corners[0];
    const Vector dual = gram * edge;
    for (int j = 0; j < d; ++j) rows(i, j) = dual[j];
    right[i] = squared_length(gram, edge);
  }
  if (rows.determinant().is_zero()) return std::nullopt;
  const Vector radius = Rational(Integer(1), Integer(2)) * (rows.inverse() * right);
  return Ball{corners[0] + radius, squared_length(gram, radius)};
}

}  // namespace flatdt::ref
