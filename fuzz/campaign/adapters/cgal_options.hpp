/// How CGAL is asked: which of its ways to insert, and on how many sheets the result is wanted.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cubic_cover.hpp"

namespace flatdt::adapters {

enum class Insertion : std::uint8_t {
  one_by_one,
  range,  // insert(first, last)
  large,  // the same for large sets: begins with points of its own, which it removes in the end
  churn,  // one by one with further points in between, all of which are removed again
};

/// As the program leaves it; or brought to one sheet if it says that it can be, or to 3^d sheets.
enum class Sheets : std::uint8_t { as_left, one, all };

struct CgalOptions {
  Insertion insertion = Insertion::one_by_one;
  Sheets sheets = Sheets::as_left;
  bool stream = false;  // write CGAL's own text stream (flatdt-check --from); with files only
};

/// Points to insert and remove again: midpoints of successive places, and places moved by 2^-20; not among
/// the places, all different.
[[nodiscard]] std::vector<Place> passing_places(const std::vector<Place>& places, int dimension);

/// Reads [--insert one|range|large|churn] [--sheets left|one|all] [--stream] and runs the adapter around
/// `triangulate`.
int run_cgal_adapter(const std::string& name, int argc, char** argv, int dimension,
                     TorusCells (*triangulate)(const std::vector<Place>&, const CgalOptions&));

}  // namespace flatdt::adapters
