/// A scenario's patient as it is shown before it is operated on: the bone with its neighbour, the
/// planned faces, the saw.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/plan.h"
#include "simulator/base/progress.h"
#include "ui/render/scene/camera.h"
#include "ui/render/scene/scene.h"
#include "ui/screens/pictures/planned_passes_picture.h"

namespace hallux::ui {

/// A bone ready to be drawn.
struct BoneInView {
  BoneLook look;
  BoneMesh mesh;
  RigidTransform world_from_bone;
};

/// A planned face as far as it lies in the bone. Its frame: x where the blade goes, z the face's
/// normal.
struct FaceInView {
  RigidTransform world_from_plane;
  Vec2 half_mm{15.0, 12.0};
  /// The middle of its rim on the side that the blade comes from.
  Vec2 entry_mm{0.0, 0.0};
};

struct PatientView {
  std::string scenario_name;
  /// That is operated on first.
  BoneInView bone;
  /// Further bones that are operated on.
  std::vector<BoneInView> further;
  /// Nothing where it is one of them.
  std::optional<BoneInView> neighbour;
  /// By cut, as the scenario lists them.
  std::vector<FaceInView> faces;
  simulator::Blade blade;
  /// How each cut is sawn, in the same order.
  std::vector<PassesInView> passes;
};

/// What such a picture leaves out: bones of pictures are coarser than those that are cut.
inline constexpr double picture_edge_mm = 0.45;

/// Builds it: a job's work (about two seconds). The edges are at least `edge_mm` long.
/// errors  ScenarioError, as make_patient_bones and plan_on; Cancelled where progress said so
/// thread  any; no graphics
PatientView make_patient_view(const scenarios::Scenario& scenario, const Progress& progress = {},
                              double edge_mm = picture_edge_mm);

/// How present a neighbour is beside the bone that is operated on.
inline constexpr double neighbour_presence = 0.45;

enum class PatientPicture : std::uint8_t {
  /// Near the planned faces, with the saw.
  Card,
  /// All of the bone, without the saw.
  Whole,
  /// Both bones alike, without the saw.
  Pair
};

/// What the picture shows; borrows from the view.
Scene scene_of(const PatientView& view, PatientPicture picture, Ground ground);
/// From medial and above, as the operator stands, into a picture of this shape.
Camera camera_of(const PatientView& view, PatientPicture picture, double width_over_height);
/// Of the ball around the camera's target that the picture shows.
double radius_of(const PatientView& view, PatientPicture picture);

}  // namespace hallux::ui
