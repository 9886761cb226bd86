/// The first homology H1(E^d/G) = G/[G,G] of a torsion-free group.
#include <set>

#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/lattice.hpp"
#include "group_parts.hpp"

namespace flatdt::ref {
namespace {

/// Relations of the abelianised group in the generators e_1..e_d (translations) and c_R (cosets but L).
class Relations {
 public:
  explicit Relations(const WorkingGroup& group)
      : cosets_(group.cosets),
        dimension_(static_cast<std::size_t>(group.gram.dimension())),
        columns_(dimension_ + cosets_.size() - 1) {
    for (std::size_t r = 0; r < cosets_.size(); ++r) {
      add_conjugations(r);
      for (std::size_t s = 0; s < cosets_.size(); ++s) add_product(r, s);
    }
  }
  /// Each relation once: many coincide (c_R c_S and c_S c_R for commuting lifts).
  [[nodiscard]] IntegerMatrix rows() const { return {rows_.begin(), rows_.end()}; }
  [[nodiscard]] std::size_t columns() const { return columns_; }

 private:
  /// c_R e_j c_R^-1 = {I|R e_j}.
  void add_conjugations(std::size_t r) {
    const Matrix difference = cosets_[r].linear - Matrix::identity(static_cast<int>(dimension_));
    for (std::size_t j = 0; j < dimension_; ++j) {
      std::vector<Integer> row(columns_);
      for (std::size_t i = 0; i < dimension_; ++i)
        row[i] = difference(static_cast<int>(i), static_cast<int>(j)).numerator();
      rows_.insert(row);
    }
  }
  /// c_R c_S = {I|l} c_RS.
  void add_product(std::size_t r, std::size_t s) {
    const Isometry product = cosets_[r] * cosets_[s];
    std::size_t rs = 0;
    while (cosets_[rs].linear != product.linear) ++rs;
    const Vector l = product.translation - cosets_[rs].translation;
    ensure(l.is_integral(), "a product of coset representatives is one up to a lattice translation");
    std::vector<Integer> row(columns_);
    for (std::size_t i = 0; i < dimension_; ++i) row[i] = -l[static_cast<int>(i)].numerator();
    add_coset(row, r, 1);
    add_coset(row, s, 1);
    add_coset(row, rs, -1);
    rows_.insert(row);
  }
  void add_coset(std::vector<Integer>& row, std::size_t coset, int multiple) const {
    if (coset > 0) row[dimension_ + coset - 1] += Integer(multiple);
  }

  const std::vector<Isometry>& cosets_;
  std::size_t dimension_, columns_;
  std::set<std::vector<Integer>> rows_;
};

}  // namespace

/// Source: the presentation of an extension of a finite group by a free abelian one ([Johnson97]),
/// abelianised; the torsion coefficients are its invariant factors.
Homology first_homology(const WorkingGroup& group) {
  const Relations relations(group);
  const SmithForm smith = smith_normal_form(relations.rows());
  Homology h1;
  for (std::size_t j = 0; j < relations.columns(); ++j) {
    const Integer factor = j < smith.diagonal.size() ? smith.diagonal[j][j] : Integer(0);
    if (factor.is_zero()) {
      ++h1.betti;
    } else if (factor != Integer(1)) {
      ensure(factor.fits_long(), "the torsion of H1 is small");
      h1.torsion.push_back(factor.to_long());
    }
  }
  return h1;
}

}  // namespace flatdt::ref
