/// A bone's history as the renderer takes it: a mesh for each solid that stands still for a while.
/// Inside this corner only.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "simulator/base/progress.h"
#include "simulator/history/bone_moment.h"
#include "ui/render/scene/scene.h"

namespace hallux::ui {

/// Never changes once it was made.
struct HistoryPicture {
  std::shared_ptr<const simulator::BoneHistory> history;
  /// By bone.
  std::vector<BoneLook> looks;
  /// By fragment, one for each of its stretches.
  std::vector<std::vector<BoneMesh>> stretches;
};

/// looks   of the bones
/// name    another attempt, or another length of it, has another
/// errors  Cancelled
/// thread  work's
std::shared_ptr<const HistoryPicture> picture_of(
    std::shared_ptr<const simulator::BoneHistory> history, std::vector<BoneLook> looks,
    const std::string& name, const Progress& progress = {});

/// The fragments at a moment of that history as bones of a scene; they borrow both.
std::vector<BoneInScene> bones_of(const HistoryPicture& picture,
                                  const simulator::BoneMoment& moment);

/// Adds the wires and screws that stand at that moment, and the rims of the holes.
/// tray  with the tools that left them
void add_metal(Scene& scene, const simulator::BoneMoment& moment, const simulator::Tray& tray);

}  // namespace hallux::ui
