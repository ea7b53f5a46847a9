/// How the pages of a course are laid out: a head with buttons at its right, cards beside or below each other, and the
/// whole of it scrolling where the window is too low.
#pragma once

#include <string>
#include <string_view>

#include "ui/widgets/card.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

/// The page inside the content, with its margin; it scrolls where it would be lower than `least_height`.
class Page {
 public:
  Page(Ui& ui, std::string_view id, std::string_view label, const Rect& content,
       float least_height);
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;
  ~Page();

  const Rect& rect() const noexcept { return rect_; }

 private:
  Ui& ui_;
  Rect rect_;
  bool is_scrolled_ = false;
};

/// The margin around a page: less where the window is small.
float page_margin(const Rect& content) noexcept;

struct PageHead {
  std::string_view title = {}, sentence = {};
  std::string_view mark = {};  ///< a pill beside the title ("Simulated course"); empty: none
  float buttons_width = 0.0F;  ///< of what stands at its right; 0: nothing
  bool has_back = false;       ///< a button `id.back` in front of the title
};

struct PageHeadResponse {
  Rect buttons = {};  ///< 36 high, at the right; below the words where the page is narrow
  bool is_back_pressed = false;
};

/// Draws the head and cuts its height off `page`.
PageHeadResponse page_head(Ui& ui, std::string_view id, Rect& page, const PageHead& head);

/// A wide card and a narrow one beside it, or below where there is no room.
struct Panes {
  Rect main = {}, side = {};
};
/// True where the two stand below each other.
bool are_panes_stacked(float page_width) noexcept;
Panes panes_of(const Rect& page, float side_width, float stacked_side_height);

/// A card without a title whose first line is the head of a table or tabs; returns the place for it.
Rect list_card(Ui& ui, const Rect& rect);

/// A name and its value on a line of a card, 28 high; the value may be shortened.
void fact_line(Ui& ui, Rect& rest, std::string_view name, std::string_view value,
               float name_width = 96.0F);

/// Words over the width of `rest`, whose height they take with `gap` below.
void words_line(Ui& ui, Rect& rest, Type type, Color color, std::string_view words,
                float gap = 8.0F);

}  // namespace hallux::ui
