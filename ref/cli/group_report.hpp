/// What `flatdt manifolds` and `flatdt info` print alike: exact numbers as text, homology, sheets.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "flatdt/ref/group_analysis.hpp"

namespace flatdt::ref::cli {

using Json = nlohmann::ordered_json;

/// analyse(), with the file and the line of the section at fault before the reason of an InvalidInput.
GroupAnalysis analysed(const Instance& instance, const std::string& file_name);

/// The texts with a separator between them.
std::string joined(const std::vector<std::string>& parts, const std::string& separator);
/// For example "Z^2 + Z2", "Z4 + Z4" or "0".
std::string homology_text(const Homology& h1);
/// "2/3" and so on: JSON numbers would be rounded by most readers.
Json json_of(const Vector& v);
/// Rows of entries.
Json json_of(const Matrix& m);
/// Rows of the augmented matrix [R|t].
Json json_of(const Isometry& g);
Json json_of(const std::vector<Isometry>& elements);
Json json_of(const Homology& h1);
/// The names and invariants of an entry that both commands report.
Json json_of_names(const CatalogueEntry& entry);

/// The numbers of sheets of the three covering spaces, or the limit that was reached instead.
struct Sheets {
  std::string theorem10, one_at_a_time, complete_orbits;
};
Sheets sheets_of(const Frame& frame);
Json json_of(const Sheets& sheets);

}  // namespace flatdt::ref::cli
