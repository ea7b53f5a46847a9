/// Things to read: pills, avatars, key chips, bars, the score ring.
#pragma once

#include <string_view>

#include "ui/widgets/ui.h"

namespace hallux::ui {

/// 22 high, from its left end; a shape in front of the words unless Neutral without one. Returns
/// the width drawn.
float pill(Ui& ui, Point left_middle, std::string_view label, Meaning meaning,
           bool has_shape = true);
float pill_width(const Ui& ui, std::string_view label, bool has_shape = true);

/// Initials on one of six muted hues, chosen by `hue` (any number).
void avatar(Ui& ui, Point centre, float radius, std::string_view initials, int hue);

/// A key as it is printed on the keyboard, 20 high, from its left end. Returns the width drawn.
float key_chip(Ui& ui, Point left_middle, std::string_view key);
float key_chip_width(const Ui& ui, std::string_view key);

/// `share` (0-1) of a track, 8 high (6 in rows).
void bar(Ui& ui, const Rect& rect, float share);
void bar(Ui& ui, const Rect& rect, float share, Color color);

/// A name, its bar, its value at the right and "/ max" behind: one line of a score by group.
struct NamedBar {
  std::string_view name = {}, value = {}, maximum = {};
  float share = 0.0F;
};
/// The bars of lines that stand below each other begin and end together: `name_width` is that of
/// the longest name.
void named_bar(Ui& ui, const Rect& line, const NamedBar& bar, float name_width);

/// A score of 100 as a ring with its pass mark as a tick; the number and "of 100" inside. It fills
/// once, in half a second, on first sight.
struct ScoreRing {
  /// What is filled once.
  std::string_view id = {};
  /// "76.8".
  std::string_view number = {};
  /// "of 100".
  std::string_view below = {};
  /// 0-1.
  float share = 0.0F;
  /// 0-1; negative: no pass mark.
  float pass_share = -1.0F;
};
void score_ring(Ui& ui, Point centre, float radius, const ScoreRing& ring);

/// Five small blocks, `filled` of them full: how hard an operation is.
void meter(Ui& ui, Point left_middle, int filled);

}  // namespace hallux::ui
