/// A block of bone, 40 x 20 x 16 mm about the origin, sawn from above (+y) across its length.
#pragma once

#include "simulator/cutting/field/kerf_set.h"
#include "simulator/cutting/slice/section.h"
#include "simulator/mesh/bvh.h"

namespace hallux::tests {

inline constexpr Vec3 block_size_mm{40.0, 20.0, 16.0};

/// Where a blade of 10 mm width stands: its teeth at y, their middle at z, the blade across x.
struct BladePlace {
  double x_mm = 0.0, y_mm = 10.0, z_mm = 0.0;
};

/// Teeth down, tooth line along z, blade normal along x.
RigidTransform blade_at(const BladePlace& place);

class SawnBlock {
 public:
  SawnBlock();

  /// Freezes a plane at x and returns its number.
  std::int32_t freeze(double x_mm);
  /// Saws from above down to there.
  void saw(std::int32_t kerf, const BladePlace& to);

  const simulator::Blade& blade() const noexcept { return kerfs_.blade(); }
  const simulator::KerfSet& kerfs() const noexcept { return kerfs_; }
  const simulator::Bvh& bvh() const noexcept { return bvh_; }
  simulator::Section section(std::int32_t kerf) const;

 private:
  simulator::CutSolid solid_;
  simulator::Bvh bvh_;
  simulator::KerfSet kerfs_;
  std::int64_t tick_ = 0;
};

}  // namespace hallux::tests
