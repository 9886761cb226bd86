#include "minimise.hpp"

#include <algorithm>
#include <chrono>

#include "simplify.hpp"

namespace flatdt::campaign {
namespace {

using testing::Specimen;

class Search {
 public:
  Search(Specimen failing, const Plan& plan, const Budget& budget,
         const std::function<bool(const Specimen&)>& fails)
      : best_(std::move(failing)),
        plan_(plan),
        domain_(shrinking_domain(plan)),
        budget_(budget),
        fails_(fails) {
    // Shrinking orders manifolds by their place in the domain.
    if (std::find(domain_.manifolds.begin(), domain_.manifolds.end(), testing::name_of(best_)) ==
        domain_.manifolds.end())
      domain_.manifolds.push_back(testing::name_of(best_));
  }

  Shrunk run() {
    Specimen plain = best_;
    plain.alias.clear();
    if (!best_.alias.empty()) improves(plain);
    take_points_out();
    while (!exhausted() && step()) {
    }
    return {best_, runs_, !exhausted()};
  }

 private:
  [[nodiscard]] bool exhausted() const {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
    return runs_ >= budget_.runs || spent.count() > budget_.seconds;
  }

  /// Makes it the best if it fails.
  bool improves(const Specimen& candidate) {
    if (exhausted() || candidate.points.empty() || !accepts(plan_.capabilities, candidate)) return false;
    ++runs_;
    if (!fails_(candidate)) return false;
    best_ = candidate;
    return true;
  }

  /// Delta debugging on the points: pieces of half of them, a quarter, ... single ones. Unlike step() it goes
  /// on where it is after a success. Source: Zeller & Hildebrandt 2002, complements only.
  void take_points_out() {
    for (std::size_t size = best_.points.size() / 2; size > 0; size /= 2)
      for (std::size_t first = 0; first < best_.points.size() && !exhausted();) {
        Specimen candidate = best_;
        const std::size_t last = std::min(first + size, candidate.points.size());
        candidate.points.erase(candidate.points.begin() + static_cast<std::ptrdiff_t>(first),
                               candidate.points.begin() + static_cast<std::ptrdiff_t>(last));
        if (!improves(candidate)) first += size;
      }
  }

  /// The first simpler specimen that fails too becomes the best. The search goes on behind the place of the
  /// last success: what was of no use before it is not tried again first. Weights decrease, so steps end.
  bool step() {
    const std::vector<Specimen> candidates = testing::simpler(best_, domain_);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const std::size_t place = (next_ + i) % candidates.size();
      if (!improves(candidates[place])) continue;
      next_ = place;
      return true;
    }
    return false;
  }

  Specimen best_;
  const Plan& plan_;
  testing::Domain domain_;
  Budget budget_;
  const std::function<bool(const Specimen&)>& fails_;
  std::size_t runs_ = 0;
  std::size_t next_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

Shrunk minimise(const Specimen& failing, const Plan& plan, const Budget& budget,
                const std::function<bool(const Specimen&)>& fails) {
  return Search(failing, plan, budget, fails).run();
}

}  // namespace flatdt::campaign
