/// Smith normal form with both transformations.
/// Source: [Cohen93, Algorithm 2.4.14]; differs: any shape and rank, least pivot first, keeps left and right.
#include <algorithm>
#include <optional>
#include <utility>

#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/lattice.hpp"

namespace flatdt::ref {
namespace {

IntegerMatrix identity_matrix(std::size_t n) {
  IntegerMatrix m(n, std::vector<Integer>(n));
  for (std::size_t i = 0; i < n; ++i) m[i][i] = 1;
  return m;
}

/// The quotient with the remainder of least absolute value, so that remainders at least halve.
Integer nearest_quotient(const Integer& a, const Integer& b) {
  return round_half_up(Rational(a, b));
}

/// Row and column operations on `form`, mirrored in its transformations: left * a * right = diagonal is the
/// invariant of every step.
class SmithReduction {
 public:
  explicit SmithReduction(const IntegerMatrix& a) : rows_(a.size()), columns_(a.empty() ? 0 : a[0].size()) {
    for (const auto& row : a) ensure(row.size() == columns_, "the rows of a matrix have one length");
    form_ = {identity_matrix(rows_), a, identity_matrix(columns_)};
  }

  SmithForm run() {
    for (std::size_t k = 0; k < std::min(rows_, columns_) && move_least_entry_to(k); ++k) {
      // Each round that does not finish leaves an entry of at most half the pivot, which becomes the pivot:
      // log2(entry) rounds at most.
      while (!clear_cross(k) || !divides_rest(k)) move_least_entry_to(k);
      if (form_.diagonal[k][k].sign() == Sign::negative) negate_row(k);
    }
    return std::move(form_);
  }

 private:
  /// Brings a nonzero entry of least absolute value of the block from (k,k) on to (k,k); false if all are 0.
  bool move_least_entry_to(std::size_t k) {
    std::optional<std::pair<std::size_t, std::size_t>> least;
    for (std::size_t i = k; i < rows_; ++i) {
      for (std::size_t j = k; j < columns_; ++j) {
        const Integer& entry = form_.diagonal[i][j];
        if (!entry.is_zero() && (!least || abs(entry) < abs(form_.diagonal[least->first][least->second])))
          least = {i, j};
      }
    }
    if (!least) return false;
    std::swap(form_.diagonal[k], form_.diagonal[least->first]);
    std::swap(form_.left[k], form_.left[least->first]);
    for (auto& row : form_.diagonal) std::swap(row[k], row[least->second]);
    for (auto& row : form_.right) std::swap(row[k], row[least->second]);
    return true;
  }

  /// Subtracts multiples of the pivot's row and column; true if the rest of both is then 0.
  bool clear_cross(std::size_t k) {
    bool clear = true;
    for (std::size_t i = k + 1; i < rows_; ++i) {
      add_row(i, k, -nearest_quotient(form_.diagonal[i][k], form_.diagonal[k][k]));
      clear = clear && form_.diagonal[i][k].is_zero();
    }
    for (std::size_t j = k + 1; j < columns_; ++j) {
      add_column(j, k, -nearest_quotient(form_.diagonal[k][j], form_.diagonal[k][k]));
      clear = clear && form_.diagonal[k][j].is_zero();
    }
    return clear;
  }

  /// Whether the pivot divides the block after it; if not, brings a remainder, at most half the pivot, into
  /// the block. Requires: clear_cross(k) was true.
  bool divides_rest(std::size_t k) {
    for (std::size_t i = k + 1; i < rows_; ++i) {
      for (std::size_t j = k + 1; j < columns_; ++j) {
        const Integer& pivot = form_.diagonal[k][k];
        if (floor_mod(form_.diagonal[i][j], pivot).is_zero()) continue;
        add_row(i, k, 1);
        add_column(j, k, -nearest_quotient(form_.diagonal[i][j], pivot));
        return false;
      }
    }
    return true;
  }

  void add_row(std::size_t target, std::size_t source, const Integer& multiple) {
    for (std::size_t j = 0; j < columns_; ++j)
      form_.diagonal[target][j] += multiple * form_.diagonal[source][j];
    for (std::size_t j = 0; j < rows_; ++j) form_.left[target][j] += multiple * form_.left[source][j];
  }
  void add_column(std::size_t target, std::size_t source, const Integer& multiple) {
    for (auto& row : form_.diagonal) row[target] += multiple * row[source];
    for (auto& row : form_.right) row[target] += multiple * row[source];
  }
  void negate_row(std::size_t k) {
    for (Integer& entry : form_.diagonal[k]) entry = -entry;
    for (Integer& entry : form_.left[k]) entry = -entry;
  }

  std::size_t rows_, columns_;
  SmithForm form_;
};

}  // namespace

SmithForm smith_normal_form(const IntegerMatrix& a) {
  return SmithReduction(a).run();
}

}  // namespace flatdt::ref
