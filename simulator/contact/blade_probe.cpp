#include "simulator/contact/blade_probe.h"

#include <algorithm>

namespace hallux::simulator {

namespace {

/// Steps along a line of the blade are never shorter than this; half of it can pass unseen.
constexpr double probe_step_mm = 0.25;

Vec3 blade_point(const RigidTransform& bone_from_tool, double back_mm, double along_mm) noexcept {
  return transform_point(bone_from_tool, Vec3{-back_mm, along_mm, 0.0});
}

}  // namespace

std::array<Vec3, tooth_count> tooth_points(const RigidTransform& bone_from_tool, const Blade& blade,
                                           double ahead_mm, double aside_mm) noexcept {
  std::array<Vec3, tooth_count> points{};
  const double share_mm = blade.width_mm / static_cast<double>(tooth_count);
  for (std::size_t tooth = 0; tooth < tooth_count; ++tooth) {
    const double along_mm = (static_cast<double>(tooth) + 0.5) * share_mm - 0.5 * blade.width_mm;
    points[tooth] = transform_point(bone_from_tool, Vec3{ahead_mm, along_mm, aside_mm});
  }
  return points;
}

namespace {

bool edge_meets(const RigidTransform& fragment_from_tool, const RemainingTissue& bone,
                double side) noexcept {
  const Blade& blade = bone.kerfs.blade();
  for (double back_mm = 0.0; back_mm <= blade.depth_mm;) {
    const Vec3 point = blade_point(fragment_from_tool, back_mm, side * 0.5 * blade.width_mm);
    double step_mm = probe_step_mm;
    if (!bone.kerfs.is_open(point)) {
      const double clearance_mm = bone.clearance_mm(point);
      if (clearance_mm <= 0.0 && is_bone(bone.at(point))) return true;
      step_mm = std::max(step_mm, clearance_mm);
    }
    back_mm += step_mm;
  }
  return false;
}

bool blade_is_in(const RigidTransform& fragment_from_tool, const RemainingTissue& bone) noexcept {
  const Blade& blade = bone.kerfs.blade();
  for (const double side : {0.0, -0.5, 0.5}) {
    for (double back_mm = 0.0; back_mm <= blade.depth_mm;) {
      const double clearance_mm =
          bone.clearance_mm(blade_point(fragment_from_tool, back_mm, side * blade.width_mm));
      if (clearance_mm <= 0.0) return true;
      back_mm += std::max(probe_step_mm, clearance_mm);
    }
  }
  return false;
}

/// The hardest tissue of one fragment over each tooth's thickness, or what was there before.
void add_tissue(const RemainingTissue& bone, const RigidTransform& fragment_from_tool,
                double ahead_mm, TeethMemory& memory,
                std::array<Tissue, tooth_count>& hardest) noexcept {
  const Blade& blade = bone.kerfs.blade();
  for (std::size_t layer = 0; layer < tooth_layers; ++layer) {
    const double aside_mm = tooth_layer_share * blade.kerf_mm * (static_cast<double>(layer) - 1.0);
    const auto points = tooth_points(fragment_from_tool, blade, ahead_mm, aside_mm);
    for (std::size_t tooth = 0; tooth < tooth_count; ++tooth) {
      const Tissue tissue = bone.at(points[tooth], memory[layer * tooth_count + tooth]);
      hardest[tooth] = std::max(hardest[tooth], tissue);
    }
  }
}

/// Whether it holds of a fragment near the blade: is_so(fragment_from_tool, its tissue).
template <typename Claim>
bool holds_of_any(const RigidTransform& bone_from_tool, const Wound& bone, const Claim& is_so) {
  bool holds = false;
  bone.visit_near(bone_from_tool.translation_mm, reach_of_blade_mm(bone.blade()),
                  [&](std::int32_t, const WoundFragment& standing) {
                    holds = holds || is_so(standing.fragment_from(bone_from_tool), standing.tissue);
                  });
  return holds;
}

}  // namespace

std::array<Tissue, tooth_count> tissue_at_teeth(const RigidTransform& bone_from_tool,
                                                const Wound& bone, double ahead_mm,
                                                OfFragments<TeethMemory>& teeth) noexcept {
  std::array<Tissue, tooth_count> hardest{};
  bone.visit_near(bone_from_tool.translation_mm, reach_of_blade_mm(bone.blade()),
                  [&](std::int32_t number, const WoundFragment& standing) {
                    add_tissue(standing.tissue, standing.fragment_from(bone_from_tool), ahead_mm,
                               teeth[static_cast<std::size_t>(number)], hardest);
                  });
  return hardest;
}

Tissue tissue_at(const Vec3& point_in_wound_mm, const Wound& bone) noexcept {
  Tissue hardest = Tissue::None;
  bone.visit_near(point_in_wound_mm, 0.0, [&](std::int32_t, const WoundFragment& standing) {
    hardest = std::max(hardest, standing.tissue.at(standing.point_from(point_in_wound_mm)));
  });
  return hardest;
}

std::int32_t teeth_in_fragment(const WoundFragment& standing, const RigidTransform& bone_from_tool,
                               TeethMemory& teeth) noexcept {
  std::array<Tissue, tooth_count> hardest{};
  add_tissue(standing.tissue, standing.fragment_from(bone_from_tool), probe_ahead_mm, teeth,
             hardest);
  return static_cast<std::int32_t>(std::count_if(hardest.begin(), hardest.end(), is_bone));
}

Engagement engagement(const RigidTransform& bone_from_tool, const Wound& bone, double ahead_mm,
                      OfFragments<TeethMemory>& teeth) noexcept {
  const double share_mm = bone.blade().width_mm / static_cast<double>(tooth_count);
  Engagement engaged;
  for (const Tissue tissue : tissue_at_teeth(bone_from_tool, bone, ahead_mm, teeth)) {
    if (tissue == Tissue::Cortical) engaged.cortical_mm += share_mm;
    if (tissue == Tissue::Cancellous) engaged.cancellous_mm += share_mm;
  }
  return engaged;
}

bool edge_meets_bone(const RigidTransform& bone_from_tool, const Wound& bone,
                     double side) noexcept {
  return holds_of_any(bone_from_tool, bone,
                      [side](const RigidTransform& pose, const RemainingTissue& tissue) {
                        return edge_meets(pose, tissue, side);
                      });
}

bool blade_is_in_bone(const RigidTransform& bone_from_tool, const Wound& bone) noexcept {
  return holds_of_any(bone_from_tool, bone, blade_is_in);
}

}  // namespace hallux::simulator
