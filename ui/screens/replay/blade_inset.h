/// The section in the blade's plane at a moment of a replay, in a corner of its view.
/// Inside this corner only.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>

#include "ui/screens/pictures/blade_section.h"
#include "ui/screens/replay/replay_material.h"
#include "ui/window/shell/shell.h"

namespace hallux::ui {

class BladeInset {
 public:
  /// Draws the section of the moment that the bone stands at, in the fragment that was sawn last,
  /// before the first kerf in the bone that is to be sawn nearest to the blade, once its solid's
  /// tree is built beside the window.
  /// shows_plan  the plan's limits and zones, too; of a fragment that is parted there are none
  /// needs       a saw is in the hand
  void draw(Ui& ui, Shell& shell, const Rect& rect,
            const std::shared_ptr<const ReplayMaterial>& material, simulator::BoneMoment& bone,
            const HandAtMoment& hand, bool shows_plan);

 private:
  /// A stretch of a fragment.
  struct Solid {
    std::int32_t fragment = 0;
    std::size_t stretch = 0;
    friend bool operator<(const Solid& a, const Solid& b) noexcept {
      return a.fragment != b.fragment ? a.fragment < b.fragment : a.stretch < b.stretch;
    }
  };
  using Trees = std::map<Solid, std::shared_ptr<const simulator::Bvh>>;

  const simulator::Bvh* tree_of(Shell& shell, const std::shared_ptr<const ReplayMaterial>& material,
                                const Solid& solid);
  void renew(const simulator::BoneMoment& bone, std::int32_t fragment,
             const std::optional<simulator::KerfAtHand>& kerf, const simulator::KerfPlane& own,
             const simulator::Bvh& tree);

  /// Null while one is being built.
  std::shared_ptr<Trees> trees_ = std::make_shared<Trees>();
  /// Where its fragment lies now, in the frame of the first bone.
  KerfSection section_;
  RigidTransform fragment_from_plane_;
  /// Of which fragment and moment, and in which plane.
  std::int32_t fragment_ = 0;
  std::uint64_t revision_ = 0;
  bool is_in_kerf_ = false, is_made_ = false;
};

}  // namespace hallux::ui
