/// The zero surface of a field sampled on a grid, by marching tetrahedra: closed whatever the
/// samples are. Inside this corner only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "scenarios/foot/dual.h"
#include "simulator/mesh/indexed_mesh.h"

namespace hallux::scenarios {

/// A field in space, below zero inside, with its gradient.
using Field = std::function<Dual(const Vec3&)>;

struct SampleBox {
  Vec3 low_mm{0.0, 0.0, 0.0};
  Vec3 high_mm{1.0, 1.0, 1.0};
  double spacing_mm = 1.0;
  /// Greatest slope of the field [mm per mm], by which far blocks are skipped.
  double steepest = 1.6;
};

/// Node (i, j, k) lies at low + spacing (i, j, k); x runs fastest.
struct SampledField {
  Vec3 low_mm{0.0, 0.0, 0.0};
  double spacing_mm = 1.0;
  std::int32_t x_count = 0, y_count = 0, z_count = 0;
  std::vector<double> values;

  std::size_t index(std::int32_t i, std::int32_t j, std::int32_t k) const noexcept;
  Vec3 point_mm(std::int32_t i, std::int32_t j, std::int32_t k) const noexcept;
};

/// Samples in blocks; a block whose centre is far from the surface takes the centre's value
/// everywhere.
/// ensures every node on the outside of the box is above zero, so that the surface closes within it
SampledField sample_field(const Field& field, const SampleBox& box);

/// ensures closed and oriented outward; points are welded by the grid edge they lie on
/// source  six tetrahedra a cube around one diagonal (Doi and Koide 1991)
simulator::IndexedMesh march_tetrahedra(const SampledField& field);

}  // namespace hallux::scenarios
