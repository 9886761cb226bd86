/// Shrinking a failing case: fewer points, a simpler manifold and metric, shorter rationals, as long as the
/// failure has the same signature.
#pragma once

#include <functional>

#include "cases.hpp"
#include "judge.hpp"

namespace flatdt::campaign {

struct Budget {
  std::size_t runs = 600;
  double seconds = 60;
};

struct Shrunk {
  testing::Specimen specimen;
  std::size_t runs = 0;
  bool finished =
      false;  // nothing simpler fails in the same way; false: the budget ran out before that was known
};

/// `fails` runs a specimen and says whether it fails with the signature of the case.
/// Laws: the result fails; it is accepted by the capabilities; its weight is at most the case's.
[[nodiscard]] Shrunk minimise(const testing::Specimen& failing, const Plan& plan, const Budget& budget,
                              const std::function<bool(const testing::Specimen&)>& fails);

}  // namespace flatdt::campaign
