/// CGAL's surface meshes behind one small face: as a peer in the benchmarks, as an oracle for
/// volumes in tests/oracles.
///
/// CGAL is GPL-3: only programs under tests/ link it, and only with HALLUX_ORACLES.
#pragma once

#include <cstddef>
#include <memory>

#include "simulator/mesh/indexed_mesh.h"
#include "tests/benchmarks/peers/half_space.h"

namespace hallux::benchmarks {

/// Inexact: doubles with exact predicates (EPICK), fast; a result cut again may fail. Exact: lazy
/// exact numbers (EPECK).
enum class CgalNumbers { Inexact, Exact };

/// errors  std::runtime_error where CGAL says that it could not, of every function that changes the
///         solid
template <CgalNumbers numbers>
class CgalSolid {
 public:
  explicit CgalSolid(const simulator::IndexedMesh& mesh);
  ~CgalSolid();
  CgalSolid(const CgalSolid& other);
  CgalSolid(CgalSolid&& other) noexcept;

  /// Keeps what lies in the half space, closed by a cap (PMP::clip with clip_volume).
  void clip(const HalfSpace& kept);
  /// Cuts along the plane and leaves both sides open (PMP::split).
  void split(const HalfSpace& plane);
  /// Takes the tool away (PMP::corefine_and_compute_difference); the tool is refined along the cut.
  void subtract(CgalSolid& tool);

  std::size_t triangle_count() const;
  bool is_closed() const;
  double volume_mm3() const;

 private:
  struct Mesh;
  std::unique_ptr<Mesh> mesh_;
};

using CgalInexactSolid = CgalSolid<CgalNumbers::Inexact>;
using CgalExactSolid = CgalSolid<CgalNumbers::Exact>;

/// A box in the kerf's frame, from `low` to `high`, as a closed mesh in the bone frame.
simulator::IndexedMesh box_in_kerf(const simulator::KerfPlane& plane, const Vec3& low_in_kerf_mm,
                                   const Vec3& high_in_kerf_mm);
/// The whole slab of a kerf, wide enough for every world of these benchmarks.
simulator::IndexedMesh slab_box(const simulator::KerfPlane& plane);

}  // namespace hallux::benchmarks
