#include "instance_elements.hpp"

#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

namespace flatdt::ref {
namespace {

/// An element of the frame's group in machine integers, if it moves by at most 2^48: then sums of three
/// products of such numbers and entries of linear parts, which are below 1,000, are far below 2^63.
std::optional<InstanceElements::FrameElement> small_element(const Frame& frame, const Isometry& g) {
  InstanceElements::FrameElement result;
  while (frame.cosets[result.coset].linear != g.linear) ++result.coset;
  for (int i = 0; i < frame.dimension; ++i) {
    const Integer t = (g.translation[i] - frame.cosets[result.coset].translation[i]).numerator();
    if (t.bits() > 48) return std::nullopt;
    result.translation[static_cast<std::size_t>(i)] = t.to_long();
  }
  return result;
}

}  // namespace

/// Either all sites are large or none is.
InstanceElements::InstanceElements(const PreparedGroup& group, const std::vector<Site>& sites)
    : group_(&group), sites_(&sites) {
  for (const Site& site : sites) {
    if (!site.is_large()) return;
    const auto element = small_element(group.frame(), site.form->large->from_site);
    if (!element) {
      large_.clear();
      return;
    }
    large_.push_back(*element);
  }
}

Isometry InstanceElements::at(const OrbitPoint& p) const {
  return conjugate(group_->table().isometry(p.g) * site(p.site).from_site(group_->frame()).inverse());
}

Isometry InstanceElements::between(SiteId a, const OrbitPoint& b) const {
  return conjugate(site(a).from_site(group_->frame()) * group_->table().isometry(b.g) *
                   site(b.site).from_site(group_->frame()).inverse());
}

/// With s = {t} r the site's element: g s^-1 = g r^-1 {-t}, and g r^-1 moves -t by its linear part.
std::optional<InstanceElements::FrameElement> InstanceElements::in_frame(const OrbitPoint& p) const {
  const SiteForm& form = *site(p.site).form;
  if (form.large && large_.empty()) return std::nullopt;
  const FrameElement s =
      form.large ? large_[index_of(p.site)]
                 : FrameElement{{form.translation[0], form.translation[1], form.translation[2]}, form.coset};
  const GroupTable& table = group_->table();
  const Element g = s.coset == 0 ? p.g : table.multiply(p.g, table.inverse(Element{{}, s.coset}));
  FrameElement result{{g.t[0], g.t[1], g.t[2]}, g.coset};
  const GroupTable::Linear& linear = table.linear(g.coset);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result.translation[i] -= linear[3 * i + j] * s.translation[j];
  return result;
}

namespace {

/// Numbers the elements of a triangulation as they come. Few are distinct.
class ElementNumbers {
 public:
  explicit ElementNumbers(const InstanceElements& elements) : elements_(&elements) {}

  /// in_frame() speaks of all or of none, so that one of the two tables has all elements.
  std::uint32_t operator()(const OrbitPoint& p) {
    const SiteForm* const form = elements_->site(p.site).form.get();
    // Most are the same as the last one.
    if (form == last_form_ && p.g == last_element_) return last_number_;
    last_form_ = form;
    last_element_ = p.g;
    return last_number_ = number(p);
  }
  std::uint32_t number(const OrbitPoint& p) {
    if (const auto key = elements_->in_frame(p)) {
      const auto [entry, is_new] = small_.try_emplace(*key, static_cast<std::uint32_t>(keys_.size()));
      if (is_new) keys_.push_back(*key);
      return entry->second;
    }
    return large_.try_emplace(elements_->at(p), static_cast<std::uint32_t>(large_.size())).first->second;
  }
  [[nodiscard]] std::vector<Isometry> listed() const {
    std::vector<Isometry> result;
    result.reserve(keys_.size());
    for (const auto& key : keys_)
      result.push_back(elements_->group().in_instance(key.coset, key.translation));
    if (large_.empty()) return result;
    result.assign(large_.size(), Isometry{Matrix(0), Vector(0)});
    for (const auto& [element, number] : large_) result[number] = element;
    return result;
  }

 private:
  struct Hash {
    std::size_t operator()(const InstanceElements::FrameElement& key) const {
      std::uint64_t hash = key.coset;
      for (const std::int64_t t : key.translation)
        hash = (hash ^ static_cast<std::uint64_t>(t)) * 0x9e3779b97f4a7c15U;
      return hash ^ hash >> 29U;
    }
  };

  const InstanceElements* elements_;
  std::vector<InstanceElements::FrameElement> keys_;
  std::unordered_map<InstanceElements::FrameElement, std::uint32_t, Hash> small_;
  std::map<Isometry, std::uint32_t> large_;
  const SiteForm* last_form_ = nullptr;
  Element last_element_;
  std::uint32_t last_number_ = 0;
};

}  // namespace

template <int D>
Triangulation to_triangulation(CellList<D> cells, const InstanceElements& elements) {
  Triangulation result;
  result.dimension = D;
  ElementNumbers numbers(elements);
  // First in place, in the order of the cells: points for sites, and numbers for codes.
  auto& records = cells.cells();
  for (auto& cell : records)
    for (auto& corner : cell) {
      const OrbitPoint p{SiteId{corner.site}, cells.codes()[corner.code]};
      corner = {elements.site(p.site).point, numbers(p)};
    }
  result.elements = numbers.listed();
  // Then from the end of the reversed list, which gives its memory back step by step.
  constexpr std::size_t kStep = 1 << 16;
  std::reverse(records.begin(), records.end());
  result.cells.reserve(records.size());
  while (!records.empty()) {
    const std::size_t left = records.size() - std::min(records.size(), kStep);
    for (std::size_t i = records.size(); i-- > left;) {
      std::array<Triangulation::CellVertex, 4> vertices{};
      for (std::size_t k = 0; k <= D; ++k) vertices[k] = {records[i][k].site, records[i][k].code};
      result.cells.push_back(vertices);
    }
    records.truncate(left);
    records.shrink_to_fit();
  }
  return result;
}

template Triangulation to_triangulation<2>(CellList<2>, const InstanceElements&);
template Triangulation to_triangulation<3>(CellList<3>, const InstanceElements&);

}  // namespace flatdt::ref
