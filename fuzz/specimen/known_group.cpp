#include "known_group.hpp"

#include <algorithm>
#include <vector>

namespace flatdt::fuzz {
namespace {

constexpr std::size_t kKept = 256;

/// All that it depends on, and the group.
struct KnownGroup {
  std::optional<std::string> name;
  std::vector<ref::Isometry> generators;
  ref::Matrix gram;
  std::shared_ptr<const ref::PreparedGroup> group;

  [[nodiscard]] bool is_of(const ref::Instance& instance) const {
    return gram == instance.gram && name == instance.name && generators == instance.generators;
  }
};

}  // namespace

std::shared_ptr<const ref::PreparedGroup> prepared(const ref::Instance& instance) {
  static std::vector<KnownGroup> known;
  static std::size_t oldest = 0;
  const auto found =
      std::find_if(known.begin(), known.end(), [&](const KnownGroup& g) { return g.is_of(instance); });
  if (found != known.end()) return found->group;
  KnownGroup fresh{instance.name, instance.generators, instance.gram,
                   std::make_shared<const ref::PreparedGroup>(ref::analyse(instance))};
  auto group = fresh.group;
  if (known.size() < kKept) {
    known.push_back(std::move(fresh));
  } else {
    known[oldest++ % kKept] = std::move(fresh);
  }
  return group;
}

}  // namespace flatdt::fuzz
