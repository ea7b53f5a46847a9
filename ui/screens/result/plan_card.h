/// Plan against cut: the face that was cut in colours of its distance to the plan, to be turned and
/// looked at; and the place that a line of the ledger is about. Inside this corner only.
#pragma once

#include <memory>
#include <optional>

#include "ui/screens/pictures/bone_viewport.h"
#include "ui/screens/result/result_material.h"

namespace hallux::ui {

class PlanCard {
 public:
  /// Marks the place of a ledger line; `cut` is the planned cut it is of, nothing: the whole bone
  /// is shown.
  void show_place(const std::array<double, 3>& place_in_bone_mm, std::optional<std::size_t> cut);

  /// Draws the card's content.
  void draw(Ui& ui, Shell& shell, const Rect& rect, const ExaminedAttempt& examined);

 private:
  bool is_whole(const ExaminedAttempt& examined) const noexcept {
    return chosen_ >= static_cast<int>(examined.cuts.size());
  }
  void draw_choice(Ui& ui, const Rect& rect, const ExaminedAttempt& examined);
  void aim(const ExaminedAttempt& examined);
  Scene scene_of(const Theme& theme, const ExaminedAttempt& examined) const;
  void draw_labels(Ui& ui, const Rect& rect, const ExaminedAttempt& examined) const;
  void draw_legend(Ui& ui, const Rect& rect) const;
  void draw_views(Ui& ui, const Rect& rect);

  BoneViewport stage_;
  /// A cut; the number of cuts: the whole bone.
  int chosen_ = 0;
  std::optional<int> aimed_;
  std::optional<Vec3> place_in_bone_mm_;
  std::uint64_t revision_ = 1;
  /// The menu of standard views.
  bool shows_views_ = false;
};

}  // namespace hallux::ui
