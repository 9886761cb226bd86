#include "small_sites.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <numeric>

#include "flatdt/ref/wide_integer.hpp"

namespace flatdt::ref {
namespace {

constexpr std::int64_t kLimit = std::int64_t{1} << 62U;  // of denominators and of scaled coordinates

using Coordinates = std::array<std::int64_t, 3>;

/// An affine map on integers over a common denominator: linear x + translation. Entries of linear are below
/// 2^31, so that a row applied to coordinates below 2^62 stays below 2^95.
struct IntegerMap {
  std::array<Coordinates, 3> linear{};
  Coordinates translation{};

  [[nodiscard]] Int128 row(std::size_t i, const Coordinates& x) const {
    Int128 sum = translation[i];
    for (std::size_t j = 0; j < 3; ++j) sum += static_cast<Int128>(linear[i][j]) * x[j];
    return sum;
  }
};

/// denominator * value. Requires: the denominator is a multiple of the value's. Nothing if the product is not
/// below `limit`.
std::optional<std::int64_t> scaled(const Rational& value, std::int64_t denominator, std::int64_t limit) {
  if (!value.is_small()) return std::nullopt;
  ensure(denominator % value.small_denominator() == 0, "the denominator clears the number");
  const Int128 product = Int128{value.small_numerator()} * (denominator / value.small_denominator());
  if (product >= limit || product <= -limit) return std::nullopt;
  return static_cast<std::int64_t>(product);
}

/// The map on coordinates over `to`, its linear part scaled by `by`: x over `from` becomes over to = by *
/// from.
std::optional<IntegerMap> integer_map(const Isometry& map, std::int64_t by, std::int64_t to) {
  IntegerMap result;
  for (int i = 0; i < map.dimension(); ++i) {
    const auto row = static_cast<std::size_t>(i);
    const auto t = scaled(map.translation[i], to, kLimit);
    if (!t) return std::nullopt;
    result.translation[row] = *t;
    for (int j = 0; j < map.dimension(); ++j) {
      const auto entry = scaled(map.linear(i, j), by, std::int64_t{1} << 31U);
      if (!entry) return std::nullopt;
      result.linear[row][static_cast<std::size_t>(j)] = *entry;
    }
  }
  return result;
}

/// The least common multiple, or nothing if it is not below the limit.
std::optional<std::int64_t> common_multiple(std::int64_t a, std::int64_t b) {
  const Int128 product = static_cast<Int128>(a / std::gcd(a, b)) * b;
  if (product >= kLimit) return std::nullopt;
  return static_cast<std::int64_t>(product);
}

/// The same with a rational's denominator.
std::optional<std::int64_t> common_multiple(std::int64_t a, const Rational& value) {
  if (!value.is_small()) return std::nullopt;
  return common_multiple(a, value.small_denominator());
}

/// The same with all denominators of a map.
std::optional<std::int64_t> common_multiple(std::int64_t a, const Isometry& map) {
  std::optional<std::int64_t> result = a;
  for (int i = 0; i < map.dimension() && result; ++i) {
    result = common_multiple(*result, map.translation[i]);
    for (int j = 0; j < map.dimension() && result; ++j) result = common_multiple(*result, map.linear(i, j));
  }
  return result;
}

std::int64_t floor_quotient(Int128 a, std::int64_t b) {
  const Int128 quotient = a / b;
  return static_cast<std::int64_t>(a % b < 0 ? quotient - 1 : quotient);
}

/// A point p of the instance with its orbit's canonical representative c, both over one denominator.
struct SmallCanonical {
  Coordinates c;      // catalogue
  Coordinates frame;  // of p, in the frame
  std::uint32_t point;
  std::uint16_t coset;  // c = (this coset's representative, then an integral translation) p
};

class SmallSites {
 public:
  SmallSites(const Frame& frame, const SiteMaps& maps, const std::vector<Vector>& points)
      : frame_(&frame), maps_(&maps), points_(&points) {}

  std::optional<std::vector<Site>> operator()() {
    if (!choose_denominators() || !find_canonical()) return std::nullopt;
    std::sort(all_.begin(), all_.end(), [](const SmallCanonical& a, const SmallCanonical& b) {
      return a.c != b.c ? a.c < b.c : a.point < b.point;
    });
    all_.erase(std::unique(all_.begin(), all_.end(),
                           [](const SmallCanonical& a, const SmallCanonical& b) { return a.c == b.c; }),
               all_.end());
    return sites();
  }

 private:
  [[nodiscard]] std::size_t dimension() const { return static_cast<std::size_t>(frame_->dimension); }

  /// given_: of the points as written; denominator_: of everything else, a multiple of it and of the frame's
  /// translation denominator.
  bool choose_denominators() {
    std::optional<std::int64_t> given = 1;
    for (const Vector& p : *points_)
      for (int i = 0; i < frame_->dimension; ++i) {
        if (!p[i].is_small()) return false;
        const std::int64_t value = p[i].small_denominator();
        if (*given % value == 0) continue;
        given = common_multiple(*given, value);
        if (!given) return false;
      }
    given_ = *given;
    const auto by = common_multiple(frame_->translation_denominator, maps_->to_catalogue);
    if (!by) return false;
    const auto all = common_multiple(*by, given_);
    if (!all || static_cast<Int128>(*by) * given_ >= kLimit) return false;
    denominator_ = *by * given_;
    const auto to_catalogue = integer_map(maps_->to_catalogue, *by, denominator_);
    const auto from_catalogue = integer_map(maps_->from_catalogue, 1, denominator_);
    if (!to_catalogue || !from_catalogue) return false;
    to_catalogue_ = *to_catalogue;
    from_catalogue_ = *from_catalogue;
    for (std::size_t k = 0; k < frame_->cosets.size(); ++k) {
      const auto catalogue = integer_map(maps_->catalogue_cosets[k], 1, denominator_);
      const auto in_frame = integer_map(frame_->cosets[k], 1, denominator_);
      if (!catalogue || !in_frame) return false;
      catalogue_cosets_.push_back(*catalogue);
      frame_cosets_.push_back(*in_frame);
    }
    return true;
  }

  /// The sum of three products of a 31-bit and a 62-bit number is far below the range of the wide type; what
  /// is kept must be below the limit.
  static bool keep(Int128 value, std::int64_t& kept) {
    if (value >= kLimit || value <= -kLimit) return false;
    kept = static_cast<std::int64_t>(value);
    return true;
  }

  bool find_canonical() {
    all_.reserve(points_->size());
    for (std::size_t n = 0; n < points_->size(); ++n) {
      Coordinates p{};
      for (std::size_t i = 0; i < dimension(); ++i) {
        const Rational& value = (*points_)[n][static_cast<int>(i)];
        const Int128 wide = Int128{value.small_numerator()} * (given_ / value.small_denominator());
        if (!keep(wide, p[i])) return false;
      }
      Coordinates x{};
      SmallCanonical best{};
      best.point = static_cast<std::uint32_t>(n);
      for (std::size_t i = 0; i < dimension(); ++i)
        if (!keep(to_catalogue_.row(i, p), x[i])) return false;
      for (std::size_t i = 0; i < dimension(); ++i)
        if (!keep(from_catalogue_.row(i, x), best.frame[i])) return false;
      for (std::size_t r = 0; r < catalogue_cosets_.size(); ++r) {
        Coordinates c{};
        for (std::size_t i = 0; i < dimension(); ++i) {
          const Int128 y = catalogue_cosets_[r].row(i, x);
          c[i] = static_cast<std::int64_t>(y % denominator_);
          if (c[i] < 0) c[i] += denominator_;
        }
        if (r > 0 && !(c < best.c)) continue;
        best.c = c;
        best.coset = static_cast<std::uint16_t>(r);
      }
      all_.push_back(best);
    }
    return true;
  }

  std::optional<std::vector<Site>> sites() {
    std::vector<Site> sites(all_.size());
    // The least denominator that clears all coordinates and the frame's translations.
    std::int64_t divisor = denominator_;
    for (std::size_t n = 0; n < all_.size(); ++n) {
      Site& site = sites[n];
      for (std::size_t i = 0; i < dimension(); ++i) {
        const Int128 y = from_catalogue_.row(i, all_[n].c);
        site.small[i] = static_cast<std::int64_t>(y - static_cast<Int128>(floor_quotient(y, denominator_)) *
                                                          denominator_);
        if (divisor > 1) divisor = std::gcd(divisor, site.small[i]);
      }
      site.point = all_[n].point;
      const std::uint16_t coset = maps_->inverse_coset[all_[n].coset];
      std::array<std::int32_t, 3> translation{};
      for (std::size_t i = 0; i < dimension(); ++i) {
        const Int128 rest = all_[n].frame[i] - frame_cosets_[coset].row(i, site.small);
        ensure(rest % denominator_ == 0, "a point and its site differ by an element of the group");
        const Int128 t = rest / denominator_;
        if (t > std::numeric_limits<std::int32_t>::max() || t < -std::numeric_limits<std::int32_t>::max())
          return std::nullopt;
        translation[i] = static_cast<std::int32_t>(t);
      }
      site.form = form(coset, translation);
    }
    const std::int64_t least =
        std::lcm(denominator_ / divisor, static_cast<std::int64_t>(frame_->translation_denominator));
    for (const auto& [element, form] : forms_) form->small_denominator = least;
    for (Site& site : sites)
      for (std::size_t i = 0; i < dimension(); ++i) site.small[i] /= denominator_ / least;
    return sites;
  }

  std::shared_ptr<const SiteForm> form(std::uint16_t coset, const std::array<std::int32_t, 3>& translation) {
    std::shared_ptr<SiteForm>& form = forms_[{coset, translation[0], translation[1], translation[2]}];
    if (!form) {
      form = std::make_shared<SiteForm>();
      form->coset = coset;
      form->translation = translation;
    }
    return form;
  }

  const Frame* frame_;
  const SiteMaps* maps_;
  const std::vector<Vector>* points_;
  std::int64_t given_ = 1;
  std::int64_t denominator_ = 1;
  IntegerMap to_catalogue_;
  IntegerMap from_catalogue_;
  std::vector<IntegerMap> catalogue_cosets_;
  std::vector<IntegerMap> frame_cosets_;
  std::vector<SmallCanonical> all_;
  std::map<std::array<std::int32_t, 4>, std::shared_ptr<SiteForm>> forms_;
};

}  // namespace

std::optional<std::vector<Site>> make_small_sites(const Frame& frame, const SiteMaps& maps,
                                                  const std::vector<Vector>& points) {
  return SmallSites(frame, maps, points)();
}

}  // namespace flatdt::ref
