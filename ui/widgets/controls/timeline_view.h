/// A timeline on the screen: zoomed by wheel, keys and buttons, moved by dragging, its marks walked
/// along with the arrows.
///
///     wheel                about the pointer      plus, minus     about the playhead
///     drag                 moves what is zoomed   Ctrl+arrows     moves by half of it
///     drag on steps, axis, the playhead, or where all is shown: leads the playhead
///     press on the strip   goes there             0, double click all of it
///
/// A mark is pressed to be looked at, a number of marks to be opened.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "ui/widgets/charts/timeline.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

/// What somebody has made of a timeline; the screen keeps it.
struct TimelineState {
  /// Nothing: all of it.
  std::optional<TimeRange> range = {};
  /// Nothing: as the screen has room.
  std::optional<bool> shows_legend = {};

  enum class Grip : std::uint8_t { None, Playhead, Range, Strip };
  /// While the left button is held.
  Grip grip = Grip::None;
  /// Of the last frame: where the playhead goes, the range follows.
  std::optional<double> last_now_s = {};
};

struct TimelineAnswer {
  /// The moment that somebody wants to see.
  std::optional<double> asked_s = {};
  /// It is a note's.
  std::optional<std::size_t> note = {};
  /// A mark was pressed, and not the time beside it.
  bool is_mark = false;
};

/// Shows the timeline as the area `id`, its marks as `id.event.N` and `id.note.N` (numbers of the
/// first of each, from 1 on). `shown.range` is the state's.
/// hears_wheel  false where the wheel is the page's
TimelineAnswer timeline(Ui& ui, std::string_view id, const Rect& rect, Timeline shown,
                        TimelineState& state, bool hears_wheel = true);

/// The keys of a screen whose timeline it is.
void hear_timeline_keys(Ui& ui, const Timeline& shown, TimelineState& state);

/// Which part is shown, in words; then buttons for nearer, farther, all, and the legend. Returns
/// the width it takes from the right of `line`.
inline constexpr float timeline_bar_height = 36.0F;
float timeline_bar_width(const Ui& ui, const Timeline& shown, const TimelineState& state);
void timeline_bar(Ui& ui, std::string_view id, const Rect& line, const Timeline& shown,
                  TimelineState& state, bool shows_legend);

/// "06:20 to 06:52 of 10:03"; "All of 10:03".
std::string range_text(const Texts& texts, const Timeline& shown);

/// The legend, in as many lines as the width needs.
float timeline_legend_height(const Ui& ui, const Timeline& shown, float width);
void draw_timeline_legend(Ui& ui, const Rect& rect, const Timeline& shown);

}  // namespace hallux::ui
