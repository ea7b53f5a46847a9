/// The time of a replay: what its timeline shows, with curves as fine as the part that is in sight.
/// Inside this corner only.
#pragma once

#include <optional>
#include <vector>

#include "ui/screens/replay/remarks.h"
#include "ui/screens/replay/replay_material.h"
#include "ui/widgets/controls/timeline_view.h"

namespace hallux::ui {

class ReplayTimeline {
 public:
  /// Curves are there as the display's height has room for them.
  /// remarks null where nobody can remark on it: their line is left out, and leaves room
  /// needs   always the same material
  Timeline shown(const Texts& texts, const ReplayMaterial& material, const Remarks* remarks,
                 double now_s, float display_height);
  TimelineState& state() noexcept { return state_; }
  /// Open where the display is high, until somebody has chosen.
  bool shows_legend(float display_height) const noexcept;

 private:
  const Curves& curves(const ReplayMaterial& material);

  TimelineState state_;
  /// Of the range that was in sight last.
  std::optional<TimeRange> range_;
  Curves curves_;
};

}  // namespace hallux::ui
