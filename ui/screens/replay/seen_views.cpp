// A turn is kept ten times a second, and played at sixty: between two facts of one movement the
// view is turned on, else it stands until the next. A jump to a standard view is a movement of a
// tenth of a second at most.
#include "ui/screens/replay/seen_views.h"

#include <algorithm>
#include <cmath>

#include "simulator/base/units.h"

namespace hallux::ui {

namespace {

using simulator::DisplayFact;
using simulator::ShownLayout;
using simulator::ShownStereo;
using simulator::ShownView;

/// Facts of one movement are a hundred ticks apart, and a frame.
constexpr double one_movement_s = 0.15;

bool is_usable(const DisplayFact& fact) noexcept { return is_view(fact) && is_known(fact); }

ShownView between(const ShownView& from, const ShownView& to, double share) noexcept {
  ShownView view = from;
  view.target_in_world_mm = glm::mix(from.target_in_world_mm, to.target_in_world_mm, share);
  view.world_from_view =
      glm::normalize(glm::slerp(from.world_from_view, to.world_from_view, share));
  view.magnification = from.magnification * std::pow(to.magnification / from.magnification, share);
  view.target_depth_mm = std::lerp(from.target_depth_mm, to.target_depth_mm, share);
  view.width_over_height = std::lerp(from.width_over_height, to.width_over_height, share);
  return view;
}

}  // namespace

SeenView SeenViews::at(double time_s) const noexcept {
  if (facts_.empty()) return {};
  const auto next = std::upper_bound(facts_.begin(), facts_.end(), time_s,
                                     [](double wanted_s, const DisplayFact& fact) {
                                       return wanted_s < second_from_tick(fact.tick);
                                     });
  const DisplayFact& now = next == facts_.begin() ? *next : *std::prev(next);
  if (!is_usable(now)) return {Seen::Unusable, {}};
  SeenView seen{Seen::Recorded, shown_view_of(now)};
  if (next == facts_.begin() || next == facts_.end() || !is_usable(*next)) return seen;
  const double begin_s = second_from_tick(now.tick);
  const double lasted_s = second_from_tick(next->tick - now.tick);
  if (lasted_s > one_movement_s) return seen;
  seen.view = between(seen.view, shown_view_of(*next), (time_s - begin_s) / lasted_s);
  return seen;
}

std::string seen_text(const Texts& texts, const SeenView& seen) {
  if (seen.seen == Seen::NotRecorded) return std::string(texts.text("replay.seen.not_recorded"));
  if (seen.seen == Seen::Unusable) return std::string(texts.text("replay.seen.unusable"));
  const bool has_section = seen.view.layout == ShownLayout::WithSection;
  switch (seen.view.stereo) {
    case ShownStereo::SideBySide:
      return std::string(texts.text(has_section ? "replay.seen.side_by_side_section"
                                                : "replay.seen.side_by_side"));
    case ShownStereo::Anaglyph:
      return std::string(
          texts.text(has_section ? "replay.seen.anaglyph_section" : "replay.seen.anaglyph"));
    case ShownStereo::Mono:
      break;
  }
  return std::string(texts.text(has_section ? "replay.seen.section" : "replay.seen.screen"));
}

}  // namespace hallux::ui
