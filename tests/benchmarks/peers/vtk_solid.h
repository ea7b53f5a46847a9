/// VTK's polygon data behind one small face: the strongest peer for a plane split. Only programs
/// under tests/ link it.
#pragma once

#include <cstddef>
#include <memory>

#include "simulator/mesh/indexed_mesh.h"
#include "tests/benchmarks/peers/half_space.h"

namespace hallux::benchmarks {

class VtkSolid {
 public:
  explicit VtkSolid(const simulator::IndexedMesh& mesh);
  ~VtkSolid();
  VtkSolid(VtkSolid&& other) noexcept;

  /// What lies in the half space, closed by a cap (vtkClipClosedSurface), in buffers of its own.
  VtkSolid clipped(const HalfSpace& kept) const;

  std::size_t triangle_count() const;
  double volume_mm3() const;

 private:
  struct Data;
  explicit VtkSolid(std::unique_ptr<Data> data);
  std::unique_ptr<Data> data_;
};

}  // namespace hallux::benchmarks
