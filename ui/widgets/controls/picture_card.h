/// A card with a picture to choose an operation by.
#pragma once

#include <string_view>

#include "ui/widgets/ui.h"

namespace hallux::ui {

inline constexpr float picture_card_width = 275.0F, picture_card_height = 332.0F,
                       picture_height = 188.0F;

struct PictureCardSpec {
  std::string_view name = {}, what = {};
  /// Nothing where none was drawn yet.
  Picture picture = {};
  /// In its place while there is none; "": nothing.
  std::string_view picture_note = {};
  /// 1-5; 0: not known.
  int difficulty = 1;
  std::string_view difficulty_word = {};
  Competence competence = Competence::NotStarted;
  /// 0-1, of Learning.
  float progress = 0.0F;
  /// "Learning, 6 of 12".
  std::string_view state = {};
  /// "best" and "81.4"; empty where there is none.
  std::string_view best_word = {}, best = {};
  /// Arrows move between the cards of one group.
  std::string_view group = {};
  /// "Not surgeon-reviewed", over the picture; empty: none.
  std::string_view mark = {};
};

/// True where it was pressed.
bool picture_card(Ui& ui, std::string_view id, const Rect& rect, const PictureCardSpec& spec);

}  // namespace hallux::ui
