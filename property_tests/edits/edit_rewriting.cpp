/// Edits that write the same triangulation otherwise: all of them keep it valid.
#include <algorithm>

#include "draft.hpp"
#include "flatdt/ref/catalogue.hpp"

namespace flatdt::edits {

using ref::Isometry;
using ref::Rational;
using ref::Vector;

namespace {

std::optional<Files> cells_permuted(const Base& base, Random& random) {
  Draft draft(base);
  random.shuffle(draft.cells());
  return draft.files();
}

std::optional<Files> corners_exchanged(const Base& base, Random& random) {
  Draft draft(base);
  FileCell& cell = draft.cells()[random.below(base.cell_count())];
  const std::vector<std::size_t> order = random.order(base.corners());
  std::swap(cell[order[0]], cell[order[1]]);
  return draft.files();
}

std::optional<Files> all_corners_permuted(const Base& base, Random& random) {
  Draft draft(base);
  for (FileCell& cell : draft.cells()) {
    const FileCell old = cell;
    const std::vector<std::size_t> order = random.order(base.corners());
    for (std::size_t i = 0; i < base.corners(); ++i) cell[i] = old[order[i]];
  }
  return draft.files();
}

std::optional<Files> other_lifts(const Base& base, Random& random) {
  Draft draft(base);
  for (FileCell& cell : draft.cells()) cell = draft.moved(base.subgroup().element(random, 3), cell);
  return draft.files();
}

std::optional<Files> lifts_far_away(const Base& base, Random& random) {
  Draft draft(base);
  for (FileCell& cell : draft.cells())
    if (random.below(4) == 0) cell = draft.moved(base.subgroup().element(random, 1'000'000'000), cell);
  return draft.files();
}

/// All cells moved by one element of G: a triangulation of E^d modulo g H g^-1.
std::optional<Files> moved_by_the_group(const Base& base, Random& random) {
  const Isometry g = base.group().element(random, 2);
  std::vector<Isometry> conjugated;
  for (const Isometry& h : base.subgroup().generators()) conjugated.push_back(g * h * g.inverse());
  const CrystalGroup other(base.instance().gram, conjugated);
  if (!other.same_as(base.subgroup())) return std::nullopt;
  Draft draft(base);
  for (FileCell& cell : draft.cells()) cell = draft.moved(g, cell);
  return draft.files();
}

std::optional<Files> points_renumbered(const Base& base, Random& random) {
  Draft draft(base);
  const std::vector<std::size_t> order = random.order(base.instance().points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    draft.instance().points[order[i]] = base.instance().points[i];
  for (FileCell& cell : draft.cells())
    for (std::size_t i = 0; i < base.corners(); ++i)
      cell[i].point = static_cast<std::uint32_t>(order[cell[i].point]);
  return draft.files();
}

std::optional<Files> points_moved_in_orbits(const Base& base, Random& random) {
  Draft draft(base);
  std::vector<Isometry> back;
  for (Vector& p : draft.instance().points) {
    const Isometry g = base.group().element(random, 3);
    p = g * p;
    back.push_back(g.inverse());
  }
  for (FileCell& cell : draft.cells())
    for (std::size_t i = 0; i < base.corners(); ++i)
      cell[i].element = draft.index_of(draft.element(cell[i]) * back[cell[i].point]);
  return draft.files();
}

/// A further point of the orbit of one that is listed; some vertices are then named by it.
std::optional<Files> point_listed_again(const Base& base, Random& random) {
  Draft draft(base);
  const std::size_t p = random.below(base.instance().points.size());
  const Isometry g = base.group().element(random, 2);
  const auto again = static_cast<std::uint32_t>(base.instance().points.size());
  draft.instance().points.push_back(g * base.instance().points[p]);
  for (FileCell& cell : draft.cells())
    for (std::size_t i = 0; i < base.corners(); ++i)
      if (cell[i].point == p && random.below(2) == 0)
        cell[i] = {again, draft.index_of(draft.element(cell[i]) * g.inverse())};
  return draft.files();
}

std::optional<Files> elements_permuted(const Base& base, Random& random) {
  Draft draft(base);
  const std::vector<std::size_t> order = random.order(base.triangulation().elements.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    draft.triangulation().elements[order[k]] = base.triangulation().elements[k];
  for (FileCell& cell : draft.cells())
    for (std::size_t i = 0; i < base.corners(); ++i)
      cell[i].element = static_cast<std::uint32_t>(order[cell[i].element]);
  return draft.files();
}

std::optional<Files> elements_repeated(const Base& base, Random& random) {
  Draft draft(base);
  const auto count = static_cast<std::uint32_t>(base.triangulation().elements.size());
  for (std::uint32_t k = 0; k < count; ++k)
    draft.triangulation().elements.push_back(base.triangulation().elements[k]);
  for (FileCell& cell : draft.cells())
    for (std::size_t i = 0; i < base.corners(); ++i)
      if (random.below(2) == 0) cell[i].element += count;
  return draft.files();
}

std::optional<Files> elements_unused(const Base& base, Random& random) {
  Draft draft(base);
  for (int k = 0; k < 5; ++k) draft.triangulation().elements.push_back(base.group().element(random, 9));
  return draft.files();
}

/// Generators of the same group: products of them, some twice, in another order.
std::vector<Isometry> respelled(const CrystalGroup& group, Random& random) {
  std::vector<Isometry> generators = group.generators();
  for (int k = 0; k < 6 && generators.size() > 1; ++k) {
    const std::vector<std::size_t> order = random.order(generators.size());
    const Isometry& by = generators[order[1]];
    Isometry& g = generators[order[0]];
    g = random.below(2) == 0 ? g * by : by.inverse() * g;
  }
  generators.push_back(group.element(random, 2));
  generators.push_back(Isometry::identity(group.lattice().dimension()));
  random.shuffle(generators);
  return generators;
}

std::optional<Files> other_generators(const Base& base, Random& random) {
  Draft draft(base);
  draft.set_generators(respelled(base.group(), random));
  return draft.files();
}

std::optional<Files> other_subgroup_generators(const Base& base, Random& random) {
  Draft draft(base);
  draft.triangulation().has_subgroup = true;
  draft.triangulation().subgroup = respelled(base.subgroup(), random);
  return draft.files();
}

std::optional<Files> name_dropped(const Base& base, Random& /*random*/) {
  if (!base.instance().name) return std::nullopt;
  Draft draft(base);
  draft.set_generators(base.instance().generators);
  draft.instance().name.reset();
  return draft.files();
}

std::optional<Files> alias_claimed(const Base& base, Random& random) {
  if (!base.instance().name) return std::nullopt;
  Draft draft(base);
  draft.set_generators(base.instance().generators);
  draft.instance().name = random.choice(ref::find_entry(*base.instance().name)->aliases);
  return draft.files();
}

/// Every number of the cells' elements and of the instance not reduced: p/q becomes kp/kq.
std::string unreduced(const std::string& text, std::size_t from, std::size_t to, Random& random) {
  std::string out = text.substr(0, from);
  std::string token;
  for (std::size_t i = from; i < to; ++i) {
    const char c = text[i];
    if (c != ' ' && c != '\n') {
      token += c;
      continue;
    }
    if (!token.empty()) {
      const std::size_t slash = token.find('/');
      const ref::Integer factor(random.between(1, 30));
      const ref::Integer p = factor * ref::Integer(token.substr(0, slash));
      const ref::Integer q =
          slash == std::string::npos ? factor : factor * ref::Integer(token.substr(slash + 1));
      out += (random.below(2) == 0 && p.sign() != ref::Sign::negative ? "+" : "") + p.to_string() + "/" +
             q.to_string();
    }
    token.clear();
    out += c;
  }
  return out + text.substr(to);
}

std::optional<Files> numbers_unreduced(const Base& base, Random& random) {
  Files files = Draft(base).files();
  const auto line_after = [](const std::string& text, const std::string& keyword) {
    return text.find('\n', text.find(keyword)) + 1;
  };
  std::string& t = files.triangulation;
  t = unreduced(t, line_after(t, "elements "), t.find("cells "), random);
  std::string& s = files.instance;
  s = unreduced(s, line_after(s, "points "), s.size(), random);
  return files;
}

}  // namespace

std::vector<Kind> rewriting_kinds() {
  const std::string_view same = "the same triangulation, written otherwise";
  const std::vector<std::pair<std::string_view, std::optional<Files> (*)(const Base&, Random&)>> all = {
      {"cells permuted", cells_permuted},
      {"two corners of a cell exchanged", corners_exchanged},
      {"corners of every cell permuted", all_corners_permuted},
      {"other lifts of the cells", other_lifts},
      {"lifts far away", lifts_far_away},
      {"all cells moved by an element of the group", moved_by_the_group},
      {"points renumbered in both files", points_renumbered},
      {"points moved in their orbits", points_moved_in_orbits},
      {"point listed again", point_listed_again},
      {"elements permuted", elements_permuted},
      {"elements repeated", elements_repeated},
      {"elements that no cell uses", elements_unused},
      {"other generators of the group", other_generators},
      {"other generators of the subgroup", other_subgroup_generators},
      {"name dropped", name_dropped},
      {"alias claimed", alias_claimed},
      {"numbers not reduced", numbers_unreduced},
  };
  std::vector<Kind> kinds;
  for (const auto& [name, apply] : all) kinds.push_back({name, same, keeps(), apply});
  return kinds;
}

}  // namespace flatdt::edits
