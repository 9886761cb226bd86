#include "instance_elements.hpp"

#include <map>
#include <unordered_map>
#include <utility>

namespace flatdt::ref {
namespace {

/// Numbers the elements of a triangulation as they come. Few are distinct, so most are recognised by what
/// determines them: an element of the frame and a site's element, without any product of rational matrices.
class ElementNumbers {
 public:
  explicit ElementNumbers(const InstanceElements& elements) : elements_(&elements) {}

  std::uint32_t operator()(const OrbitPoint& p) {
    const Site& site = elements_->site(p.site);
    if (site.large) return number(elements_->at(p));
    const Key key{p.g, site.coset, site.translation};
    if (const auto known = known_.find(key); known != known_.end()) return known->second;
    return known_.emplace(key, number(elements_->at(p))).first->second;
  }
  [[nodiscard]] std::vector<Isometry> take() && {
    std::vector<Isometry> result(listed_.size(), Isometry{Matrix(0), Vector(0)});
    for (auto& [element, number] : listed_) result[number] = element;
    return result;
  }

 private:
  struct Key {
    Element g;
    std::uint16_t coset;
    std::array<std::int32_t, 3> translation;
    friend bool operator==(const Key&, const Key&) = default;
  };
  struct Hash {
    std::size_t operator()(const Key& key) const {
      std::uint64_t hash = key.g.packed() ^ key.coset;
      for (const std::int32_t t : key.translation)
        hash = (hash ^ static_cast<std::uint32_t>(t)) * 0x9e3779b97f4a7c15U;
      return hash ^ hash >> 29U;
    }
  };

  std::uint32_t number(Isometry element) {
    return listed_.try_emplace(std::move(element), static_cast<std::uint32_t>(listed_.size())).first->second;
  }

  const InstanceElements* elements_;
  std::unordered_map<Key, std::uint32_t, Hash> known_;
  std::map<Isometry, std::uint32_t> listed_;
};

}  // namespace

template <int D>
Triangulation to_triangulation(const std::vector<CellPoints<D>>& cells, const InstanceElements& elements) {
  Triangulation result;
  result.dimension = D;
  result.cells.reserve(cells.size());
  ElementNumbers numbers(elements);
  for (const CellPoints<D>& cell : cells) {
    std::array<Triangulation::CellVertex, 4> vertices{};
    for (std::size_t k = 0; k <= D; ++k) vertices[k] = {elements.site(cell[k].site).point, numbers(cell[k])};
    result.cells.push_back(vertices);
  }
  result.elements = std::move(numbers).take();
  return result;
}

template Triangulation to_triangulation<2>(const std::vector<CellPoints<2>>&, const InstanceElements&);
template Triangulation to_triangulation<3>(const std::vector<CellPoints<3>>&, const InstanceElements&);

}  // namespace flatdt::ref
