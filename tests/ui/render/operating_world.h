/// An Akin operation in the middle of its first cut, as data for pictures: the worlds of the
/// renderer's tests.
#pragma once

#include <cstdint>
#include <memory>

#include "scenarios/plan.h"
#include "simulator/cutting/field/region_outline.h"
#include "simulator/cutting/solid/solid_patch.h"
#include "ui/render/scene/camera.h"
#include "ui/render/scene/scene.h"

namespace hallux::tests {

/// A phalanx with a neighbour and a saw; what a scene borrows lives here.
class OperatingWorld {
 public:
  /// `edge_mm` is the edge length of the bones' surfaces: their density. 0.3 is the product's.
  explicit OperatingWorld(double edge_mm);
  ~OperatingWorld();

  /// Saws from medial until the teeth stand this far from the kerf's origin, and shows that as a
  /// patch.
  void saw_to(double reach_mm);
  /// Both cuts done, committed, the wedge taken out.
  void take_wedge_out();

  /// The operating view as it is now.
  ui::Scene scene() const;
  ui::Camera camera() const;
  /// The tool's pose where the teeth stand.
  RigidTransform world_from_tool() const;

  /// What still stands in the plane of the kerf that is being sawn.
  ui::HeldBone held() const;
  /// The scenario's danger zones, none near.
  std::vector<ui::ZoneInScene> zones() const;

  const simulator::Bone& phalanx() const noexcept;
  const scenarios::PlannedCut& cut() const;
  /// The planned face of that name as a plane: z its normal, y along the tooth line, x where the
  /// saw goes.
  RigidTransform world_from_face(std::string_view name) const;
  const simulator::SolidPatch& patch() const noexcept;
  const ui::BoneMesh& mesh() const noexcept;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hallux::tests
