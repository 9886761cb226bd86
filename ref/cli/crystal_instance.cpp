/// From a crystal to an instance: which sites count, fractional positions, metric, coincidences.
#include <algorithm>
#include <map>

#include "crystal.hpp"
#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/group_analysis.hpp"

namespace flatdt::ref::cli {
namespace {

constexpr int kFractionalDigits = 6;  // 10^-6 of a cell; a numerator and differences fit 21 bits

std::string cell_text(const Crystal& crystal) {
  std::string text;
  for (const std::string& value : crystal.cell) text += (text.empty() ? "" : " ") + value;
  return text;
}

void choose_alternatives(Crystal& crystal, bool all) {
  std::map<std::string, std::string> chosen;  // of each group, the label listed first
  std::vector<CrystalSite> kept;
  std::size_t alternatives = 0;
  for (const CrystalSite& site : crystal.sites) {
    if (!site.alternative.empty()) {
      ++alternatives;
      const std::string& label = chosen.emplace(site.group, site.alternative).first->second;
      if (!all && label != site.alternative) continue;
    }
    kept.push_back(site);
  }
  if (alternatives > 0) {
    const std::size_t dropped = crystal.sites.size() - kept.size();
    crystal.notes.push_back("alternative locations: " + std::to_string(alternatives) + " sites, " +
                            (all ? "all kept" : std::to_string(dropped) + " of later labels left out"));
  }
  crystal.sites = std::move(kept);
}

/// The file's matrix must fit the cell: S^T G S = I up to the digits that such files have.
void check_matrix(const Isometry& map, const Matrix& gram, const Crystal& crystal) {
  const Matrix product = map.linear.transpose() * gram * map.linear - Matrix::identity(3);
  const Rational tolerance(Integer(1), Integer(100));
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (abs(product(i, j)) > tolerance)
        throw InvalidInput("the file's matrix from Cartesian to fractional coordinates (" +
                           map.linear.to_string() + ") does not fit the cell " + cell_text(crystal) +
                           ": correct or remove it");
}

void make_fractional(Crystal& crystal, const Matrix& gram) {
  if (!crystal.cartesian) return;
  const bool unit_cube = crystal.cell[0] == crystal.cell[1] && crystal.cell[1] == crystal.cell[2] &&
                         exact_decimal(crystal.cell[0], "cell") == Rational(1) && gram == Matrix::identity(3);
  if (unit_cube)
    throw InvalidInput(
        "the cell 1 1 1 90 90 90 is the placeholder of structures that are not crystals (NMR)");
  if (crystal.fractional_from_cartesian) check_matrix(*crystal.fractional_from_cartesian, gram, crystal);
  const Isometry map = crystal.fractional_from_cartesian ? *crystal.fractional_from_cartesian
                                                         : cell_fractionalisation(crystal.cell);
  crystal.notes.push_back(std::string("fractional coordinates: by the matrix of the ") +
                          (crystal.fractional_from_cartesian ? "file" : "cell") +
                          ", rounded to multiples of 10^-6");
  for (CrystalSite& site : crystal.sites) {
    site.position = map * site.position;
    for (int i = 0; i < 3; ++i) site.position[i] = rounded(site.position[i], kFractionalDigits);
  }
}

/// The mean of R^T G R over the group: G itself if it is invariant. Entries that were rounded may differ in
/// the last places (a primitive cell of a centred lattice); more is a contradiction.
Matrix invariant_metric(const Matrix& gram, const std::vector<Isometry>& operations, const Crystal& crystal) {
  Matrix sum(3);
  Rational largest;
  for (int i = 0; i < 3; ++i) largest = std::max(largest, gram(i, i));
  const Rational tolerance = largest * Rational(Integer(1), Integer(1'000'000));
  for (const Isometry& g : operations) {
    const Matrix image = g.linear.transpose() * gram * g.linear;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (abs(image(i, j) - gram(i, j)) > tolerance)
          throw InvalidInput("the cell " + cell_text(crystal) + " contradicts the group" +
                             (crystal.symbol.empty() ? "" : " " + crystal.symbol) + ": the operation " +
                             operation_text(g) + " does not preserve its lengths and angles");
    sum = sum + image;
  }
  return Rational(Integer(1), Integer(static_cast<long>(operations.size()))) * sum;
}

struct Coincidence {
  std::size_t first, second;
};

/// Pairs of sites in one orbit: each later site with the first of its orbit.
std::vector<Coincidence> coincidences(const std::vector<CrystalSite>& sites,
                                      const std::vector<Isometry>& operations) {
  std::map<Vector, std::size_t> seen;
  std::vector<Coincidence> list;
  for (std::size_t k = 0; k < sites.size(); ++k) {
    Vector least(3);
    for (std::size_t m = 0; m < operations.size(); ++m) {
      Vector image = operations[m] * sites[k].position;
      for (int i = 0; i < 3; ++i) image[i] -= Rational(floor(image[i]));
      least = m == 0 ? image : std::min(least, image);
    }
    const auto [where, is_new] = seen.emplace(least, k);
    if (!is_new) list.push_back({where->second, k});
  }
  return list;
}

void handle_coincidences(Crystal& crystal, const std::vector<Isometry>& operations, bool merge) {
  const std::vector<Coincidence> pairs = coincidences(crystal.sites, operations);
  if (pairs.empty()) return;
  std::string text;
  for (std::size_t k = 0; k < pairs.size() && k < 5; ++k)
    text += (k > 0 ? "; " : "") + crystal.sites[pairs[k].second].label + " with " +
            crystal.sites[pairs[k].first].label;
  if (pairs.size() > 5) text += "; ...";
  if (!merge)
    throw InvalidInput(std::to_string(pairs.size()) + " sites coincide with another one of their orbit (" +
                       text + "): --coincident merge keeps the first of each");
  std::vector<CrystalSite> kept;
  std::size_t next = 0;  // of pairs, which are in the order of their second sites
  for (std::size_t k = 0; k < crystal.sites.size(); ++k)
    if (next < pairs.size() && pairs[next].second == k)
      ++next;
    else
      kept.push_back(crystal.sites[k]);
  crystal.sites = std::move(kept);
  crystal.notes.push_back("coincident sites merged: " + text);
}

}  // namespace

ImportedInstance instance_of(Crystal crystal, const CrystalOptions& options) {
  if (crystal.sites.empty()) throw InvalidInput("the file has no atom sites with coordinates");
  const Matrix gram = cell_metric(crystal.cell);
  const std::vector<Isometry> operations = operations_of(crystal);
  ImportedInstance imported;
  Instance& instance = imported.instance;
  instance.dimension = 3;
  instance.generators_given = true;
  for (const Isometry& g : operations)
    if (!g.is_identity()) instance.generators.push_back(g);
  for (int i = 0; i < 3; ++i)
    instance.generators.push_back(Isometry::translate(Matrix::identity(3).column(i)));
  instance.gram = invariant_metric(gram, operations, crystal);

  choose_alternatives(crystal, options.all_alternatives);
  make_fractional(crystal, gram);
  // Before coincidences: a group with fixed points is the better reason for a refusal.
  instance.points = {crystal.sites.front().position};
  try {
    instance.name = analyse(instance).entry->name;
  } catch (const InvalidInput& error) {
    throw InvalidInput("the group" + (crystal.symbol.empty() ? "" : " " + crystal.symbol) +
                       " is not that of a flat manifold: " + error.what());
  }
  handle_coincidences(crystal, operations, options.merge_coincident);
  instance.points.clear();
  for (const CrystalSite& site : crystal.sites) {
    instance.points.push_back(site.position);
    imported.labels.push_back(site.label);
  }
  imported.notes = std::move(crystal.notes);
  return imported;
}

}  // namespace flatdt::ref::cli
