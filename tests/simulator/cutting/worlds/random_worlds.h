/// Bones, planes and regions drawn by chance; the same seed gives the same world everywhere.
#pragma once

#include <cstdint>
#include <vector>

#include "simulator/base/random.h"
#include "simulator/cutting/field/kerf.h"
#include "simulator/cutting/field/region_outline.h"
#include "simulator/mesh/indexed_mesh.h"

namespace hallux::tests {

/// Of length 1.
Vec3 random_direction(Random& random);
/// A wavy tube with a canal, a wavy sphere, full or hollow, a U or a block; none reaches 34 mm from
/// the origin.
simulator::IndexedMesh random_bone(Random& random);
/// A plane through the middle of such a bone, near enough to meet it.
simulator::KerfPlane random_plane(Random& random);

/// A multiple of `step` from -reach to +reach steps.
double random_multiple(Random& random, int reach, double step);
/// A solid whose corners lie on quarters of a millimetre, within 3 mm of the origin: a box, a U, or
/// a box with a void.
simulator::IndexedMesh lattice_bone(Random& random);
/// A kerf of half a millimetre through quarters, with axes along the world's or a plane through a
/// diagonal.
simulator::KerfPlane lattice_plane(Random& random);

/// A region that only grows, frame by frame.
class GrowingRegion {
 public:
  virtual ~GrowingRegion() = default;
  virtual simulator::RegionOutline next() = 0;
};

/// A blade that is pushed through the plane's origin, trembling and turning; the outline of its
/// field.
class StrokedRegion final : public GrowingRegion {
 public:
  /// `reach_mm`: from the plane's origin to where bone may begin.
  StrokedRegion(Random& random, double reach_mm, std::int32_t frame_count);
  simulator::RegionOutline next() override;
  const simulator::KerfField& field() const noexcept { return field_; }

 private:
  simulator::PlanarPose pose_at(std::int32_t frame);

  Random& random_;
  simulator::KerfField field_;
  simulator::Blade blade_;
  Vec2 feed_, start_mm_;
  double way_mm_ = 0.0;
  std::int32_t frame_ = 0, frame_count_;
  simulator::PlanarPose last_;
};

/// Rectangles, diamonds, rings and pairs with all corners on quarters of a millimetre: borders run
/// along edges and through corners of a lattice bone.
class LatticeRegion final : public GrowingRegion {
 public:
  explicit LatticeRegion(Random& random);
  simulator::RegionOutline next() override;

 private:
  std::uint64_t shape_;
  Vec2 middle_mm_, half_mm_;
  double grown_mm_ = 0.0;
};

}  // namespace hallux::tests
