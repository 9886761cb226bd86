#include "cubic_cover.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "adapter.hpp"
#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/group_analysis.hpp"
#include "flatdt/ref/triangulation_format.hpp"

namespace flatdt::adapters {
namespace {

using ref::Isometry;
using ref::Rational;
using ref::Vector;

bool is_cubic(const ref::Matrix& gram) {
  return gram == gram(0, 0) * ref::Matrix::identity(gram.dimension());
}

/// Errors: Unsupported if the rational is no double.
double as_double(const Rational& x) {
  const double value = mpq_class(x.numerator().mpz(), x.denominator().mpz()).get_d();
  if (Rational(mpq_class(value)) != x)
    throw Unsupported("an image of a point has coordinates that are no doubles");
  return value;
}

}  // namespace

CubicCover::CubicCover(const ref::Instance& instance) : dimension_(instance.dimension) {
  const ref::GroupAnalysis analysis = ref::analyse(instance);
  if (!analysis.lattice.is_identity() || !is_cubic(instance.gram))
    throw Unsupported(
        "the translation lattice is not the square or cubic one in the coordinates of the file");
  is_torus_ = analysis.cosets.size() == 1;
  std::set<Place> seen;
  for (std::size_t i = 0; i < instance.points.size(); ++i)
    for (const Isometry& coset : analysis.cosets) {
      const Vector image = coset * instance.points[i];
      Vector back(dimension_);
      Place place{};
      for (int k = 0; k < dimension_; ++k) {
        back[k] = Rational(-floor(image[k]));
        place[static_cast<std::size_t>(k)] = as_double(image[k] + back[k]);
      }
      if (!seen.insert(place).second) continue;  // the point was given before
      places_.push_back(place);
      images_.push_back({i, Isometry::translate(back) * coset});
    }
}

std::string CubicCover::file_of(const TorusCells& torus) const {
  ref::Triangulation file;
  file.dimension = dimension_;
  file.has_subgroup = !is_torus_ || std::any_of(torus.sheets.begin(), torus.sheets.begin() + dimension_,
                                                [](int s) { return s != 1; });
  if (file.has_subgroup)
    for (int k = 0; k < dimension_; ++k) {
      Vector period(dimension_);
      period[k] = torus.sheets[static_cast<std::size_t>(k)];
      file.subgroup.push_back(Isometry::translate(period));
    }
  std::map<Isometry, std::uint32_t> numbers;
  const auto corners = static_cast<std::size_t>(dimension_) + 1;
  for (const auto& cell : torus.cells) {
    auto& written = file.cells.emplace_back();
    for (std::size_t k = 0; k < corners; ++k) {
      const Image& image = images_.at(cell[k].image);
      Vector offset(dimension_);
      for (int axis = 0; axis < dimension_; ++axis)
        offset[axis] = cell[k].offset[static_cast<std::size_t>(axis)];
      const Isometry element = Isometry::translate(offset) * image.element;
      const auto [at, fresh] = numbers.try_emplace(element, static_cast<std::uint32_t>(file.elements.size()));
      if (fresh) file.elements.push_back(element);
      written[k] = {static_cast<std::uint32_t>(image.point), at->second};
    }
  }
  return ref::write_triangulation(file, {});
}

}  // namespace flatdt::adapters
