#include "ui/screens/replay/history_picture.h"

#include <utility>

#include "ui/screens/pictures/bone_viewport.h"

namespace hallux::ui {

std::shared_ptr<const HistoryPicture> picture_of(
    std::shared_ptr<const simulator::BoneHistory> history, BoneLook look, const std::string& name,
    const Progress& progress) {
  auto picture = std::make_shared<HistoryPicture>();
  picture->look = std::move(look);
  const auto mesh_named = [&](const std::string& part, const simulator::CutSolid& solid) {
    return lit_mesh_of(picture_id(name + " " + part), solid, picture->look);
  };
  const auto count = static_cast<double>(history->stretches.size());
  for (const simulator::BoneStretch& stretch : history->stretches) {
    report(progress, static_cast<double>(picture->stretches.size()) / count);
    picture->stretches.push_back(
        mesh_named("stretch " + std::to_string(stretch.from_tick), stretch.solid));
  }
  if (history->closed) {
    picture->halves = {mesh_named("fixed", history->closed->fixed),
                       mesh_named("moved", history->closed->moved)};
  }
  picture->history = std::move(history);
  return picture;
}

std::vector<BoneInScene> bones_of(const HistoryPicture& picture,
                                  const simulator::BoneMoment& moment,
                                  const RigidTransform& world_from_bone) {
  BoneInScene bone;
  bone.look = &picture.look;
  bone.world_from_bone = world_from_bone;
  if (moment.is_closed()) {
    BoneInScene moved = bone;
    bone.mesh = &picture.halves->fixed;
    moved.mesh = &picture.halves->moved;
    moved.world_from_bone = world_from_bone * picture.history->closed->bone_from_moved;
    return {bone, moved};
  }
  bone.mesh = &picture.stretches[moment.stretch()];
  bone.patch = moment.patch();
  if (bone.patch != nullptr) bone.patch_revision = moment.revision();
  return {bone};
}

}  // namespace hallux::ui
