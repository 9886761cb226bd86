#include "base.hpp"

#include <algorithm>
#include <stdexcept>

#include "geometry.hpp"

namespace flatdt::edits {

using ref::Isometry;
using ref::Rational;
using ref::Vector;

namespace {

std::vector<Vector> without(const std::vector<Vector>& cell, std::size_t corner) {
  std::vector<Vector> facet = cell;
  facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(corner));
  return facet;
}

const std::vector<Isometry>& generators_of_h(const Case& c) {
  return c.triangulation.has_subgroup ? c.triangulation.subgroup : c.instance.generators;
}

}  // namespace

Vector position(const Case& c, FileVertex v) {
  return c.triangulation.elements[v.element] * c.instance.points[v.point];
}

std::vector<Vector> positions(const Case& c, const FileCell& cell) {
  std::vector<Vector> all;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(c.instance.dimension); ++i)
    all.push_back(position(c, cell[i]));
  return all;
}

FaceKey face_key(const CrystalGroup& h, const std::vector<Vector>& vertices, Isometry* mover) {
  Vector sum(vertices[0].dimension());
  for (const Vector& v : vertices) sum = sum + v;
  const Vector barycentre = (Rational(1) / Rational(static_cast<long>(vertices.size()))) * sum;
  const CrystalGroup::Canonical canonical = h.canonical(barycentre);
  FaceKey key;
  for (const Vector& v : vertices) key.push_back(canonical.mover * v);
  std::sort(key.begin(), key.end());
  if (mover != nullptr) *mover = canonical.mover;
  return key;
}

Base::Base(Case valid, std::string label)
    : case_(std::move(valid)),
      label_(std::move(label)),
      group_(case_.instance.gram, case_.instance.generators),
      subgroup_(case_.instance.gram, generators_of_h(case_)) {
  struct Occurrence {
    std::size_t cell, corner;
    Isometry mover;
  };
  std::map<FaceKey, std::vector<Occurrence>> facets;
  for (std::size_t c = 0; c < case_.triangulation.cells.size(); ++c) {
    cells_.push_back(positions(case_, case_.triangulation.cells[c]));
    for (std::size_t i = 0; i < corners(); ++i) {
      Isometry mover = Isometry::identity(dimension());
      const FaceKey key = face_key(subgroup_, without(cells_[c], i), &mover);
      facets[key].push_back({c, i, mover});
    }
  }
  const Neighbour none{0, 0, Isometry::identity(dimension())};
  neighbours_.assign(cells_.size(), std::vector<Neighbour>(corners(), none));
  for (const auto& [key, two] : facets) {
    if (two.size() != 2) throw std::runtime_error(label_ + ": a facet of the base is not paired");
    for (std::size_t k = 0; k < 2; ++k)
      neighbours_[two[k].cell][two[k].corner] = {two[1 - k].cell, two[1 - k].corner,
                                                 two[k].mover.inverse() * two[1 - k].mover};
  }
  std::set<Vector> orbits;
  for (const Vector& p : case_.instance.points) orbits.insert(group_.canonical(p).point);
  points_are_distinct_ = orbits.size() == case_.instance.points.size();
}

Vector Base::apex_across(std::size_t cell, std::size_t corner) const {
  const Neighbour& n = neighbours_[cell][corner];
  return n.to * cells_[n.cell][n.corner];
}

const std::vector<std::pair<std::size_t, std::size_t>>& Base::ties() const {
  if (!ties_) {
    ties_.emplace();
    for (std::size_t c = 0; c < cells_.size(); ++c)
      for (std::size_t i = 0; i < corners(); ++i)
        if (in_ball(case_.instance.gram, cells_[c], apex_across(c, i)) == 0) ties_->emplace_back(c, i);
  }
  return *ties_;
}

bool Base::closes_short_cycle(const Vector& u, const Vector& v) const {
  const auto ends = [this](const Vector& a, const Vector& b) {
    std::pair<Vector, Vector> pair{subgroup_.canonical(a).point, subgroup_.canonical(b).point};
    if (pair.second < pair.first) std::swap(pair.first, pair.second);
    return pair;
  };
  if (!joined_) {
    joined_.emplace();
    for (const std::vector<Vector>& cell : cells_)
      for (std::size_t i = 0; i < cell.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) joined_->insert(ends(cell[i], cell[j]));
  }
  const std::pair<Vector, Vector> wanted = ends(u, v);
  return wanted.first == wanted.second || joined_->count(wanted) > 0;
}

bool facets_are_paired(const Case& c, const CrystalGroup& h) {
  std::map<FaceKey, int> count;
  for (const FileCell& cell : c.triangulation.cells) {
    const std::vector<Vector> points = positions(c, cell);
    const std::set<Vector> different(points.begin(), points.end());
    if (different.size() != points.size()) return false;
    for (std::size_t i = 0; i < points.size(); ++i) ++count[face_key(h, without(points, i))];
  }
  return std::all_of(count.begin(), count.end(), [](const auto& item) { return item.second == 2; });
}

}  // namespace flatdt::edits
