/// A bone's history as the renderer takes it: a mesh for each solid that stands still for a while.
/// Inside this corner only.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "simulator/base/progress.h"
#include "simulator/history/bone_moment.h"
#include "ui/render/scene/scene.h"

namespace hallux::ui {

/// Never changes once it was made.
struct HistoryPicture {
  std::shared_ptr<const simulator::BoneHistory> history;
  BoneLook look;
  /// One for each stretch of the history.
  std::vector<BoneMesh> stretches;
  struct Halves {
    BoneMesh fixed, moved;
  };
  /// Where the history has a closed hinge.
  std::optional<Halves> halves;
};

/// look    of the bone
/// name    another attempt, or another length of it, has another
/// errors  Cancelled
/// thread  work's
std::shared_ptr<const HistoryPicture> picture_of(
    std::shared_ptr<const simulator::BoneHistory> history, BoneLook look, const std::string& name,
    const Progress& progress = {});

/// The pieces at a moment of that history as bones of a scene; they borrow both.
/// world_from_bone  the bone's place
std::vector<BoneInScene> bones_of(const HistoryPicture& picture,
                                  const simulator::BoneMoment& moment,
                                  const RigidTransform& world_from_bone);

}  // namespace hallux::ui
