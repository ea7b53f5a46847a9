/// How the pages of a course are laid out: a head with buttons at its right, cards beside or below
/// each other, and the whole of it scrolling where the window is too low.
#pragma once

#include <string>
#include <string_view>

#include "ui/screens/parts/signed_in_session.h"
#include "ui/widgets/controls/card.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

/// The page inside the content, with its margin; it scrolls where it would be lower than
/// `least_height`.
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
  /// A pill beside the title ("Simulated course"); empty: none.
  std::string_view mark = {};
  /// Of what stands at its right; 0: nothing.
  float buttons_width = 0.0F;
  /// A button `id.back` in front of the title.
  bool has_back = false;
};

/// The head of a page of the course: a simulated one is marked as that.
PageHead course_head(const Ui& ui, const SignedInSession& signed_in, std::string_view title,
                     std::string_view sentence);

struct PageHeadResponse {
  /// 36 high, at the right; below the words where the page is narrow.
  Rect buttons = {};
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

/// Heights and widths of a page with a list.
struct ListPageSpec {
  /// Of the card beside the list.
  float side_width = 0.0F;
  /// Of the page that the card takes at most.
  float side_share = 1.0F;
  /// Of the card where it stands below the list.
  float side_height = 0.0F;
  /// Of all above that card.
  float list_height = 420.0F;
  /// Of the page where they stand beside each other.
  float least_height = 480.0F;
  /// The list's card begins with the head of a table or tabs; else with its margin.
  bool has_head = true;
};

/// A page with a list and, beside or below it, what was chosen in it. What is drawn while it is in
/// scope lies on it.
///
///     const ListPage page(ui, "cohorts", head, content, spec);
///     if (button(ui, "cohorts.add", page.buttons(), add)) ...
///     if (!cohorts_.draw_until_ready(ui, "cohorts.failed", page.list(), 6)) return;
class ListPage {
 public:
  /// Draws the head and the cards.
  ListPage(Ui& ui, std::string_view id, const PageHead& head, const Rect& content,
           const ListPageSpec& spec);

  /// At the right of the head, as wide as it asked for.
  const Rect& buttons() const noexcept { return buttons_; }
  /// Inside the list's card.
  const Rect& list() const noexcept { return list_; }
  /// All of the place for what was chosen; its card is drawn by whoever knows its padding.
  const Rect& side() const noexcept { return side_; }

 private:
  Page page_;
  Rect buttons_, list_, side_;
};

/// A card without a title whose first line is the head of a table or tabs; returns the place for
/// it.
Rect list_card(Ui& ui, const Rect& rect);

/// A name and its value on a line of a card, 28 high; the value may be shortened.
void fact_line(Ui& ui, Rect& rest, std::string_view name, std::string_view value,
               float name_width = 96.0F);

/// The same with a moment, in local time; its offset is told while the pointer rests on it.
void fact_moment(Ui& ui, Rect& rest, std::string_view name, std::string_view utc);
/// A moment in a cell of a table, alike.
void draw_moment_cell(Ui& ui, const Rect& cell, std::string_view utc, const TextStyle& style);

/// Words over the width of `rest`, whose height they take with `gap` below.
void text_line(Ui& ui, Rect& rest, Type type, Color color, std::string_view words,
               float gap = 8.0F);

}  // namespace hallux::ui
