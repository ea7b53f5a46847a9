/// A card with a picture to choose an operation by.
#pragma once

#include <string_view>

#include "ui/widgets/ui.h"

namespace hallux::ui {

inline constexpr float picture_card_width = 275.0F, picture_card_height = 332.0F,
                       picture_height = 188.0F;

struct PictureCardSpec {
  std::string_view name = {}, what = {};
  Picture picture = {};  ///< nothing where none was drawn yet: a skeleton stands for it
  int difficulty = 1;    ///< 1-5; 0: not known
  std::string_view difficulty_word = {};
  Competence competence = Competence::NotStarted;
  float progress = 0.0F;                       ///< 0-1, of Learning
  std::string_view state = {};                 ///< "Learning, 6 of 12"
  std::string_view best_word = {}, best = {};  ///< "best" and "81.4"; empty where there is none
  std::string_view due = {};                   ///< "Due 7 Mar"; empty: not due
  std::string_view group = {};                 ///< arrows move between the cards of one group
  std::string_view mark = {};  ///< "Not surgeon-reviewed", over the picture; empty: none
};

/// True where it was pressed.
bool picture_card(Ui& ui, std::string_view id, const Rect& rect, const PictureCardSpec& spec);

}  // namespace hallux::ui
