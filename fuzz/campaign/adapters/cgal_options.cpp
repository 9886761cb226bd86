#include "cgal_options.hpp"

#include <map>
#include <set>

#include "adapter.hpp"

namespace flatdt::adapters {

std::vector<Place> passing_places(const std::vector<Place>& places, int dimension) {
  std::set<Place> seen(places.begin(), places.end());
  std::vector<Place> passing;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Place& a = places[i];
    const Place& b = places[(i + 1) % places.size()];
    Place middle{}, beside{};
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
      middle[k] = (a[k] + b[k]) / 2;
      beside[k] = a[k] < 0.5 ? a[k] + 0x1p-20 : a[k] - 0x1p-20;
    }
    for (const Place& p : {middle, beside})
      if (seen.insert(p).second) passing.push_back(p);
  }
  return passing;
}

int run_cgal_adapter(const std::string& name, int argc, char** argv, int dimension,
                     TorusCells (*triangulate)(const std::vector<Place>&, const CgalOptions&)) {
  const std::map<std::string, Insertion> insertions{{"one", Insertion::one_by_one},
                                                    {"range", Insertion::range},
                                                    {"large", Insertion::large},
                                                    {"churn", Insertion::churn}};
  const std::map<std::string, Sheets> sheets{
      {"left", Sheets::as_left}, {"one", Sheets::one}, {"all", Sheets::all}};
  CgalOptions options;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const std::string value = i + 1 < argc ? argv[i + 1] : "";
    if (word == "--insert" && insertions.contains(value)) {
      options.insertion = insertions.at(value);
      ++i;
    } else if (word == "--sheets" && sheets.contains(value)) {
      options.sheets = sheets.at(value);
      ++i;
    } else if (word == "--stream") {
      options.stream = true;
    } else {
      files.push_back(word);
    }
  }
  return run_adapter(name, files, [&](const ref::Instance& instance) {
    if (instance.dimension != dimension) throw Unsupported("wrong dimension");
    const CubicCover cover(instance);
    const TorusCells cells = triangulate(cover.places(), options);
    return options.stream ? cells.stream : cover.file_of(cells);
  });
}

}  // namespace flatdt::adapters
