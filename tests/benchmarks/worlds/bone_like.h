/// The worlds of the kernel's benchmarks: closed bone-like surfaces of any density, made in code.
#pragma once

#include <cstddef>

#include "simulator/cutting/field/kerf.h"
#include "simulator/mesh/indexed_mesh.h"

namespace hallux::benchmarks {

struct BoneLike {
  /// Aimed at; met within 2 percent.
  std::size_t triangles = 50'000;
  /// With a marrow canal of its own shell, 35 percent of the triangles.
  bool is_hollow = true;
};

/// A wavy shaft with two thick ends, 62 mm along x and 14 to 16 mm across, with triangles of one
/// size.
/// ensures closed and oriented, every coordinate bit for bit the same in each run
simulator::IndexedMesh make_bone_like(const BoneLike& wanted);

/// Five hollow bones side by side along y, as the metatarsals of a foot lie; one mesh of ten
/// shells.
simulator::IndexedMesh make_foot_like(std::size_t triangles);

/// Of the box around it.
Vec3 middle_of(const simulator::IndexedMesh& mesh);

/// An oblique kerf through the shaft of make_bone_like; the section is about 14 x 12 mm.
simulator::KerfPlane oblique_kerf(double thickness_mm = 0.5);

}  // namespace hallux::benchmarks
