/// A target whose inputs are specimens: it says which parts its bytes hold, and gets the two files as text.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "specimen.hpp"

namespace flatdt::fuzz {

/// Defined by each structured target.
extern const Shape kShape;

/// The files of a specimen, as the programs read them.
struct Texts {
  std::string instance;
  std::string triangulation;  // empty unless kShape.triangulation
};
[[nodiscard]] Texts texts_of(const Specimen& specimen);

}  // namespace flatdt::fuzz
