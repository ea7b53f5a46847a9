#include "ui/window/shell/help.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "ui/widgets/controls/button.h"
#include "ui/widgets/controls/marks.h"
#include "ui/widgets/controls/scroll_keys.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {
namespace {

constexpr float panel_width = 460.0F, mouse_panel_width = 860.0F;
constexpr float row_height = 34.0F, head_height = 60.0F, foot_height = 78.0F;

constexpr std::pair<Key, std::string_view> signs[] = {
    {Key::Left, "\xE2\x86\x90"}, {Key::Up, "\xE2\x86\x91"}, {Key::Right, "\xE2\x86\x92"},
    {Key::Down, "\xE2\x86\x93"}, {Key::Plus, "+"},          {Key::Minus, "\xE2\x88\x92"},
    {Key::Comma, ","},           {Key::Period, "."},        {Key::LeftBracket, "["},
    {Key::RightBracket, "]"},    {Key::Slash, "/"},
};
constexpr std::pair<Key, std::string_view> named_keys[] = {
    {Key::Tab, "key.tab"},
    {Key::Enter, "key.enter"},
    {Key::Escape, "key.escape"},
    {Key::Space, "key.space"},
    {Key::Home, "key.home"},
    {Key::End, "key.end"},
    {Key::PageUp, "key.page_up"},
    {Key::PageDown, "key.page_down"},
    {Key::Backspace, "key.backspace"},
    {Key::Delete, "key.delete"},
};

// Letters, digits and signs are printed as they are; the catalogue names the others.
std::string key_text(const Texts& texts, Key key) {
  if (key >= Key::A && key <= Key::Z)
    return {static_cast<char>('A' + static_cast<int>(key) - static_cast<int>(Key::A))};
  if (key >= Key::Digit0 && key <= Key::Digit9)
    return {static_cast<char>('0' + static_cast<int>(key) - static_cast<int>(Key::Digit0))};
  if (key >= Key::F1 && key <= Key::F12)
    return "F" + std::to_string(static_cast<int>(key) - static_cast<int>(Key::F1) + 1);
  for (const auto& [sign, text] : signs)
    if (sign == key) return std::string(text);
  for (const auto& [named, id] : named_keys)
    if (named == key) return std::string(texts.text(id));
  return {};
}

}  // namespace

std::string chord_text(const Texts& texts, Chord chord) {
  std::string result;
  if (chord.modifiers.control) result += std::string(texts.text("key.control")) + "+";
  if (chord.modifiers.alt) result += std::string(texts.text("key.alt")) + "+";
  if (chord.modifiers.shift) result += std::string(texts.text("key.shift")) + "+";
  return result + key_text(texts, chord.key);
}

std::vector<HelpRow> help_rows(const Texts& texts, const std::vector<Shortcut>& shortcuts,
                               const std::vector<MouseGesture>& gestures) {
  std::vector<HelpRow> rows;
  const auto row_of = [&](const std::string& label) -> HelpRow& {
    const auto found = std::ranges::find(rows, label, &HelpRow::label);
    return found != rows.end() ? *found : rows.emplace_back(HelpRow{label, {}, {}});
  };
  // The hand first: an operation is its movements, and who asks while operating asks for them.
  for (const MouseGesture& gesture : gestures) row_of(gesture.label).mouse = gesture.input;
  for (const Shortcut& shortcut : shortcuts) {
    // With Shift the same thing, more finely: one rule, not a row of its own.
    const bool is_finer = shortcut.chord.modifiers.shift && [&] {
      Shortcut plain = shortcut;
      plain.chord.modifiers.shift = false;
      return std::ranges::find(shortcuts, plain) != shortcuts.end();
    }();
    if (!is_finer) row_of(shortcut.label).keys.push_back(chord_text(texts, shortcut.chord));
  }
  return rows;
}

namespace {

/// The keys of a row as chips from the right; a few at most, the last of many stand for a range.
void draw_keys(Ui& ui, const Rect& place, const std::vector<std::string>& keys) {
  float x = place.right();
  for (auto key = keys.rbegin(); key != keys.rend(); ++key) {
    const float chip = key_chip_width(ui, *key);
    if (x - chip < place.x) return;
    key_chip(ui, {x - chip, place.mid_y()}, *key);
    x -= chip + 6.0F;
  }
}

void draw_row(Ui& ui, const Rect& row, const HelpRow& shown, bool has_mouse) {
  Canvas& canvas = ui.canvas();
  const Theme& theme = ui.theme();
  const float label_share = has_mouse ? 0.36F : 0.5F, keys_share = has_mouse ? 0.36F : 0.5F;
  canvas.text_in({row.x, row.y, label_share * row.w - 12.0F, row.h},
                 {Type::Body, theme.text_secondary}, shown.label, true);
  draw_keys(ui, {row.x + label_share * row.w, row.y, keys_share * row.w - 10.0F, row.h},
            shown.keys);
  if (!has_mouse) return;
  const float x = row.x + (label_share + keys_share) * row.w + 10.0F;
  canvas.text_in({x, row.y, row.right() - x, row.h}, {Type::Body, theme.text}, shown.mouse, true);
}

/// Of the screen below: what lies on the list's own layer is the list's.
template <typename Bound>
std::vector<Bound> bound_below(const std::vector<Bound>& all) {
  Layer highest = Layer::Page;
  for (const Bound& each : all)
    if (each.layer < Layer::Modal) highest = std::max(highest, each.layer);
  std::vector<Bound> below;
  std::ranges::copy_if(all, std::back_inserter(below),
                       [&](const Bound& each) { return each.layer == highest; });
  return below;
}

/// The buttons at the panel's foot, and left of them the rule for finer movements.
HelpAnswer draw_foot(Ui& ui, Rect foot, bool has_mouse, bool has_guide) {
  HelpAnswer answer = HelpAnswer::Waiting;
  const ButtonSpec close{ui.text("help.close"), ButtonLook::Primary};
  const ButtonSpec guide{ui.text("help.guide"), ButtonLook::Secondary, Icon::Help};
  const Rect close_place = take_right(foot, button_width(ui, close), 12.0F);
  if (has_guide) {
    const std::string key = chord_text(ui.texts(), {Key::F1});
    const Rect place = take_right(foot, button_width(ui, guide), 10.0F);
    const float chip = key_chip_width(ui, key);
    key_chip(ui, {foot.right() - chip, foot.mid_y()}, key);
    take_right(foot, chip, 16.0F);
    if (button(ui, "help.guide", place, guide)) answer = HelpAnswer::Guide;
    if (ui.shortcut({Key::F1}, ui.text("help.guide"))) answer = HelpAnswer::Guide;
  }
  if (button(ui, "help.close", close_place, close)) answer = HelpAnswer::Close;
  if (ui.shortcut({Key::Escape}, ui.text("help.close"))) answer = HelpAnswer::Close;
  if (has_mouse)
    ui.canvas().text_in(foot, {Type::Small, ui.theme().text_caption}, ui.text("help.finer"), true);
  return answer;
}

}  // namespace

HelpAnswer draw_shortcut_list(Ui& ui, bool has_guide) {
  Canvas& canvas = ui.canvas();
  const LayerScope layer(canvas, Layer::Modal);
  const Theme& theme = ui.theme();
  const std::vector<MouseGesture> gestures = bound_below(ui.gestures());
  const std::vector<HelpRow> shown = help_rows(ui.texts(), bound_below(ui.shortcuts()), gestures);
  const bool has_mouse = !gestures.empty();
  const Rect display = ui.display();
  const float rows = row_height * static_cast<float>(shown.size());
  const float height = std::min(head_height + rows + foot_height, display.h - 16.0F);
  const float wished = has_mouse ? mouse_panel_width : panel_width;
  const Rect panel = centred(display, std::min(wished, display.w - 16.0F), height);
  canvas.fill(display, theme.scrim);
  draw_popup(canvas, theme, panel, radius::picture);
  const float x = panel.x + space::card, width = panel.w - 2.0F * space::card;
  canvas.text({x, panel.y + 34.0F}, {Type::CardTitle, theme.text},
              ui.text(has_mouse ? "help.title_mouse" : "help.title"));
  const Rect list{x, panel.y + head_height, width, height - head_height - foot_height};
  scroll_by_keys(ui, "help.list", list.h);
  float y = list.y - ui.begin_scroll("help.list", ui.text("help.title"), list, rows);
  for (const HelpRow& row : shown) {
    draw_row(ui, {x, y, width - 10.0F, row_height}, row, has_mouse);
    y += row_height;
  }
  ui.end_scroll();
  const HelpAnswer answer =
      draw_foot(ui, {x, panel.bottom() - space::card - button_height, width, button_height},
                has_mouse, has_guide);
  ui.focus_first("help.close");
  return answer;
}

}  // namespace hallux::ui
