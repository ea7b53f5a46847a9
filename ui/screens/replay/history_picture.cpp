#include "ui/screens/replay/history_picture.h"

#include <utility>

#include "ui/screens/pictures/bone_viewport.h"

namespace hallux::ui {

namespace {

const BoneLook& look_of_fragment(const HistoryPicture& picture,
                                 const simulator::BoneHistory& history, std::size_t fragment) {
  return picture.looks[static_cast<std::size_t>(history.fragments[fragment].origin.bone)];
}

}  // namespace

std::shared_ptr<const HistoryPicture> picture_of(
    std::shared_ptr<const simulator::BoneHistory> history, std::vector<BoneLook> looks,
    const std::string& name, const Progress& progress) {
  auto picture = std::make_shared<HistoryPicture>();
  picture->looks = std::move(looks);
  double count = 0.0, made = 0.0;
  for (const simulator::FragmentHistory& fragment : history->fragments)
    count += static_cast<double>(fragment.stretches.size());
  for (std::size_t i = 0; i < history->fragments.size(); ++i) {
    std::vector<BoneMesh>& meshes = picture->stretches.emplace_back();
    const BoneLook& look = look_of_fragment(*picture, *history, i);
    for (const simulator::BoneStretch& stretch : history->fragments[i].stretches) {
      report(progress, made++ / count);
      const std::string part =
          " fragment " + std::to_string(i) + " from " + std::to_string(stretch.from_tick);
      meshes.push_back(lit_mesh_of(picture_id(name + part), stretch.solid, look));
    }
  }
  picture->history = std::move(history);
  return picture;
}

std::vector<BoneInScene> bones_of(const HistoryPicture& picture,
                                  const simulator::BoneMoment& moment) {
  std::vector<BoneInScene> bones;
  for (std::int32_t number = 0; number < moment.fragment_count(); ++number) {
    const simulator::FragmentMoment& fragment = moment.fragment(number);
    if (!fragment.is_there()) continue;
    BoneInScene& bone = bones.emplace_back();
    bone.mesh = &picture.stretches[static_cast<std::size_t>(number)][fragment.stretch()];
    bone.look = &look_of_fragment(picture, *picture.history, static_cast<std::size_t>(number));
    bone.world_from_bone = moment.world_from_fragment(number);
    bone.patch = fragment.patch();
    if (bone.patch != nullptr) bone.patch_revision = moment.revision_of(number);
  }
  return bones;
}

void add_metal(Scene& scene, const simulator::BoneMoment& moment, const simulator::Tray& tray) {
  for (const simulator::ImplantStay* const stay : moment.implants()) {
    const simulator::Implant& implant = stay->implant;
    if (!tray.has(implant.tool)) continue;
    scene.implants.push_back(
        {moment.world_from_fragment(implant.fragment) * implant.fragment_from_tool,
         tray[implant.tool]});
  }
  for (const simulator::RimInMoment& rim : moment.rims()) {
    const RigidTransform world_from_fragment = moment.world_from_fragment(rim.fragment);
    HoleInScene& hole = scene.holes.emplace_back();
    for (const Vec3& point_mm : rim.rim->points_mm)
      hole.rim_mm.push_back(transform_point(world_from_fragment, point_mm));
    hole.outward = transform_direction(world_from_fragment, rim.outward);
  }
}

}  // namespace hallux::ui
