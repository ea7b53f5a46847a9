/// A panel over the page for a few fields: scrim, title, close. What is drawn while it is in scope lies on it.
///
///     const Sheet sheet(ui, "people.add", {ui.text("people.add"), 480.0F, 300.0F});
///     field(ui, "people.add.login", line_of(sheet.content()), login_, spec);
///     if (sheet.wants_close()) is_adding_ = false;
#pragma once

#include <string>
#include <string_view>

#include "ui/widgets/ui.h"

namespace hallux::ui {

struct SheetSpec {
  std::string_view title = {};
  float width = 480.0F;
  float content_height =
      240.0F;  ///< of what stands below the title; it scrolls where the window is lower
};

class Sheet {
 public:
  /// Draws the panel; its close is `id.close`, what scrolls `id.scroll`.
  Sheet(Ui& ui, std::string_view id, const SheetSpec& spec);
  Sheet(const Sheet&) = delete;
  Sheet& operator=(const Sheet&) = delete;
  ~Sheet();

  /// The place for what stands on it, as wide as the sheet less its padding.
  const Rect& content() const noexcept { return content_; }
  /// Esc, or its close was pressed.
  bool wants_close() const noexcept { return wants_close_; }

 private:
  Rect draw_panel(std::string_view id, const SheetSpec& spec);

  Ui& ui_;
  LayerScope layer_;
  Rect content_;
  bool wants_close_ = false, is_scrolled_ = false;
};

}  // namespace hallux::ui
