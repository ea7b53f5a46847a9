/// Cards: the surfaces that a screen is made of, and what they show while there is nothing to show.
#pragma once

#include <string_view>

#include "ui/widgets/controls/button.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

/// Draws a card with a title (may be empty) and returns the place for its content, below the title.
Rect card(Ui& ui, const Rect& rect, std::string_view title, float padding = space::card);

/// The page's name and one sentence below it, at the head of a screen.
void page_title(Ui& ui, Point left_top, std::string_view title, std::string_view sentence);

/// What a list shows while it is empty: an icon, a title, one sentence, one button (none where
/// `action` is empty).
struct EmptyCard {
  Icon icon = Icon::Inbox;
  std::string_view title = {}, sentence = {}, action = {};
};
/// True where the button was pressed; it is named `id.action`.
bool empty_card(Ui& ui, std::string_view id, const Rect& content, const EmptyCard& empty);

/// What a card shows when its content could not be got: what, why, and one button.
struct FailedCard {
  std::string_view title = {}, reason = {}, action = {};
};
bool failed_card(Ui& ui, std::string_view id, const Rect& content, const FailedCard& failed);

/// One thing to take away: a shape, what happened in a line, why and what next below it, and at
/// the right what it cost with a way on (either may be empty).
struct MessageRow {
  Meaning meaning = Meaning::Good;
  std::string_view head = {}, body = {}, right = {}, action = {};
};
/// True where the way on was pressed, named `id.action`.
bool message_row(Ui& ui, std::string_view id, const Rect& rect, const MessageRow& row);
/// The height in which head and body have room at this width: 95 for one line and two.
float message_row_height(const Ui& ui, const MessageRow& row, float width);

/// Bars in the shape of rows that are still being read; nothing before 150 ms, so that what is
/// quick does not flicker. `since_s` is the frame time at which loading began.
void loading_rows(Ui& ui, const Rect& content, int rows, double since_s);

}  // namespace hallux::ui
