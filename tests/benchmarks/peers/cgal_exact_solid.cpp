#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include "tests/benchmarks/peers/cgal_solid_of.h"

namespace hallux::benchmarks {

template <>
struct CgalKernelOf<CgalNumbers::Exact> {
  using Type = CGAL::Exact_predicates_exact_constructions_kernel;
};

template class CgalSolid<CgalNumbers::Exact>;

}  // namespace hallux::benchmarks
