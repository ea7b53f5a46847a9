/// The section in the blade's plane at a moment of a replay, in a corner of its view.
/// Inside this corner only.
#pragma once

#include <map>
#include <memory>

#include "ui/screens/pictures/blade_section.h"
#include "ui/screens/replay/replay_material.h"
#include "ui/window/shell/shell.h"

namespace hallux::ui {

class BladeInset {
 public:
  /// Draws the section of the moment that the bone stands at, once its solid's tree is built beside
  /// the window; nothing after a hinge was closed.
  /// shows_plan  the plan's limits and zones, too
  void draw(Ui& ui, Shell& shell, const Rect& rect,
            const std::shared_ptr<const ReplayMaterial>& material, simulator::BoneMoment& bone,
            const HandAtMoment& hand, bool shows_plan);

 private:
  using Trees = std::map<std::size_t, std::shared_ptr<const simulator::Bvh>>;

  const simulator::Bvh* tree_of(Shell& shell, const std::shared_ptr<const ReplayMaterial>& material,
                                std::size_t stretch);
  void renew(const ReplayMaterial& material, simulator::BoneMoment& bone,
             const RigidTransform& bone_from_tool, const simulator::Bvh& tree);

  /// By stretch; null while one is being built.
  std::shared_ptr<Trees> trees_ = std::make_shared<Trees>();
  KerfSection section_;
  /// Of which moment, and in which plane.
  std::uint64_t revision_ = 0;
  bool is_in_kerf_ = false, is_made_ = false;
};

}  // namespace hallux::ui
