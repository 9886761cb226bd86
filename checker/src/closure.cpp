#include "closure.hpp"

#include <optional>
#include <string>
#include <utility>

#include "linear.hpp"

namespace flatdt::checker {
namespace {

class Closure {
 public:
  Closure(int dimension, const Mat<Rational>* metric) : dimension_(dimension), metric_(metric) {
    representatives_.push_back({identity<Rational>(dimension), {}});
  }

  /// Takes one generator; returns a witness if the group is not crystallographic.
  std::optional<Witness> add(const Seitz& g, std::size_t number) {
    require_sizes(g);
    if (const Seitz* known = find(g.linear)) {
      translations_.push_back(subtract(g.translation, known->translation));
      return std::nullopt;
    }
    if (metric_ != nullptr) {
      const Mat<Rational> image =
          multiply(dimension_, transpose(g.linear), multiply(dimension_, *metric_, g.linear));
      if (image != *metric_) {
        return Witness{{"reason", "metric-not-invariant"},
                       {"generator", std::to_string(number)},
                       {"element", to_string(dimension_, g)},
                       {"transformed-metric", to_string(dimension_, {image, {}})}};
      }
    }
    enlarging_.push_back(g);
    return close();
  }

  [[nodiscard]] Crystal finish() {
    Lattice lattice(dimension_);
    for (const Seitz& u : representatives_) {
      for (const Seitz& s : enlarging_) {
        const Seitz w = compose(dimension_, u, s);
        lattice.insert(subtract(w.translation, find(w.linear)->translation));
      }
    }
    for (const Vec<Rational>& v : translations_) {
      if (lattice.contains(v)) continue;
      for (const Seitz& u : representatives_) lattice.insert(multiply(dimension_, u.linear, v));
    }
    return {dimension_, std::move(representatives_), std::move(lattice)};
  }

 private:
  static void require_sizes(const Seitz& g) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        const Rational& x = j < 3 ? g.linear[i][j] : g.translation[i];
        require_size(x.get_num(), "a number of the group");
        require_size(x.get_den(), "a number of the group");
      }
    }
  }

  [[nodiscard]] const Seitz* find(const Mat<Rational>& linear) const {
    for (const Seitz& r : representatives_) {
      if (r.linear == linear) return &r;
    }
    return nullptr;
  }

  /// Multiplies every representative, old and new, by every enlarging generator.
  std::optional<Witness> close() {
    const std::size_t most = dimension_ == 2 ? 12 : 48;
    for (std::size_t i = 0; i < representatives_.size(); ++i) {
      for (const Seitz& s : enlarging_) {
        Seitz w = compose(dimension_, representatives_[i], s);
        if (find(w.linear) != nullptr) continue;
        require_sizes(w);
        // A linear part of finite order that keeps a lattice is integral in its basis: so is its trace.
        const Rational trace = w.linear[0][0] + w.linear[1][1] + w.linear[2][2];
        if (trace.get_den() != 1) {
          return Witness{{"reason", "infinite-order"},
                         {"element", to_string(dimension_, w)},
                         {"trace-of-linear-part", trace.get_str()}};
        }
        if (representatives_.size() == most) {
          return Witness{{"reason", "point-group-too-large"},
                         {"linear-parts", std::to_string(most + 1)},
                         {"element", to_string(dimension_, w)}};
        }
        representatives_.push_back(std::move(w));
      }
    }
    return std::nullopt;
  }

  int dimension_;
  const Mat<Rational>* metric_;
  std::vector<Seitz> representatives_;
  std::vector<Seitz> enlarging_;
  std::vector<Vec<Rational>> translations_;
};

}  // namespace

std::variant<Crystal, Witness> close_group(int dimension, const std::vector<Seitz>& generators,
                                           const Mat<Rational>* metric) {
  Closure closure(dimension, metric);
  for (std::size_t i = 0; i < generators.size(); ++i) {
    if (std::optional<Witness> witness = closure.add(generators[i], i)) return *std::move(witness);
  }
  return closure.finish();
}

}  // namespace flatdt::checker
