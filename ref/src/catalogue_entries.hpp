/// The twelve entries of the catalogue as text, for catalogue.cpp alone.
#pragma once

#include <string>
#include <vector>

#include "flatdt/ref/catalogue.hpp"

namespace flatdt::ref {

/// A CatalogueEntry before parsing. Group elements are coordinate triplets as in International Tables, e.g.
/// "x+1/2,-y+1/2,-z"; the Gram matrix is its upper triangle, row by row.
struct CatalogueText {
  std::string name;
  std::vector<std::string> aliases;
  int dimension;
  std::vector<std::string> space_groups;
  std::vector<std::string> generators;
  std::vector<std::string> mirror_image_generators;
  std::vector<std::string> mirror_aliases;
  std::vector<std::string> coset_representatives;
  std::string canonical_gram;
  std::string metric_cone;
  std::string holonomy;
  bool orientable;
  Homology h1;
  std::string delta_squared_formula;
  std::string canonical_delta_squared;
  bool left_orderable;
  std::vector<int> left_order_coordinates;
};

const std::vector<CatalogueText>& catalogue_texts();

}  // namespace flatdt::ref
