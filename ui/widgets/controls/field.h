/// A field for text: one line, several lines, or a secret.
#pragma once

#include <string>
#include <string_view>

#include "ui/widgets/controls/button.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

struct FieldSpec {
  /// Above the field, and its name for accessibility tools.
  std::string_view label = {};
  /// Inside while it is empty.
  std::string_view placeholder = {};
  /// A sentence below it, with an example; empty: nothing is wrong.
  std::string_view error = {};
  /// A sentence below it where there is no error.
  std::string_view hint = {};
  Icon icon = Icon::None;
  /// Off: a search field whose placeholder says what it is.
  bool is_label_shown = true;
  /// Dots stand for letters; an eye shows them while it is on.
  bool is_secret = false;
  /// Tab completes what is typed, by whoever reads `Ui::field_events`; else it goes on.
  bool takes_tab = false;
  /// Why it is off, as of a button.
  std::string_view why_off = {};
  /// More: Enter makes a new line, Ctrl+Enter is the primary action.
  int lines = 1;
  std::size_t max_bytes = 200;
};

/// Heights: 42, 44 at sign-in; the label takes 26 above and a message 26 below.
inline constexpr float field_height = 42.0F, field_label_height = 26.0F,
                       field_message_height = 26.0F;

/// Edits `text` in the box `rect` (without label and message). True where `text` changed in this
/// frame.
bool field(Ui& ui, std::string_view id, const Rect& rect, std::string& text, const FieldSpec& spec);

/// The same below its label, both cut off `rest`, with `below` left free under the box.
bool labelled_field(Ui& ui, std::string_view id, Rect& rest, std::string& text,
                    const FieldSpec& spec, float below = 0.0F);

/// A field to search in, whose placeholder says so.
bool search_field(Ui& ui, std::string_view id, const Rect& rect, std::string& text,
                  std::string_view label);

/// How it looks in a given state, with text and caret; for the gallery.
void draw_field(Ui& ui, const Rect& rect, std::string_view text, const FieldSpec& spec,
                const ControlState& state, bool has_focus);

}  // namespace hallux::ui
