/// The two dimensions of the peer, each in its own source file: CGAL's headers take long to compile.
#pragma once

#include "peer.hpp"

namespace flatdt::bench {

Work cgal_batch_2(const PointSet& set);
Work cgal_hierarchy_2(const PointSet& set);
Work cgal_one_by_one_2(const PointSet& set);
Work cgal_validity_2(const PointSet& set);

Work cgal_batch_3(const PointSet& set);
Work cgal_one_by_one_3(const PointSet& set);
Work cgal_validity_3(const PointSet& set);

}  // namespace flatdt::bench
