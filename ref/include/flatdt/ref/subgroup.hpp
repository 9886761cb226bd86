/// The subgroups H of G whose quotients E^d/H a complex can live on: G itself, a sublattice S of the
/// translation lattice (a torus cover), and the index-2 dicosm subgroup of the didicosm group. Vertices of
/// E^d/H are right cosets H g: every element is g = s r, with s in H and r a fixed representative.
#pragma once

#include <cstdint>
#include <vector>

#include "flatdt/ref/cover.hpp"
#include "flatdt/ref/group_table.hpp"

namespace flatdt::ref {

class Subgroup {
 public:
  /// H = G.
  static Subgroup whole(const GroupTable& table);
  /// H = a sublattice, given by its Hermite normal form.
  static Subgroup sublattice(const GroupTable& table, const Sublattice& lattice);
  /// The subgroup of all elements whose coset is listed. Requires: the listed cosets form a subgroup of the
  /// holonomy of index at most 2.
  static Subgroup of_cosets(const GroupTable& table, const std::vector<bool>& listed);

  struct Split {
    Element s;          // in H
    std::uint32_t rep;  // index of the representative r
  };
  /// g = s * representative(rep).
  [[nodiscard]] Split split(const Element& g) const;
  [[nodiscard]] const Element& representative(std::uint32_t rep) const { return representatives_[rep]; }
  /// [G:H].
  [[nodiscard]] std::uint32_t index() const { return static_cast<std::uint32_t>(representatives_.size()); }
  [[nodiscard]] bool is_whole() const { return kind_ == Kind::whole; }
  /// Whether the translations of G are in H; then the representatives are those of the frame's cosets.
  [[nodiscard]] bool has_all_translations() const { return kind_ != Kind::sublattice; }

 private:
  enum class Kind { whole, sublattice, cosets };
  Subgroup(Kind kind, const GroupTable& table) : kind_(kind), table_(&table) {}

  Kind kind_;
  const GroupTable* table_;
  std::array<std::array<int, 3>, 3> basis_{};  // columns of the lower-triangular Hermite normal form
  std::vector<bool> listed_;
  std::vector<Element> representatives_;
};

}  // namespace flatdt::ref
