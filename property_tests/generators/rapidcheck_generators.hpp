/// RapidCheck generators of specimens and of triangulated specimens. They shrink as simplify.hpp says, and
/// print as files.
#pragma once

#include <iosfwd>

#include <rapidcheck.h>

#include "draw.hpp"
#include "flatdt/ref/triangulation_format.hpp"

namespace flatdt::testing {

rc::Gen<Specimen> specimens(const Domain& domain);

/// A specimen with the reference's triangulation of it.
struct TriangulatedSpecimen {
  Specimen specimen;
  ref::Triangulation triangulation;
};
/// Both files, the second after a line "# triangulation".
std::ostream& operator<<(std::ostream& out, const TriangulatedSpecimen& both);

/// Errors of the reference surface as failures of the property that draws.
rc::Gen<TriangulatedSpecimen> triangulated_specimens(const Domain& domain);

}  // namespace flatdt::testing
