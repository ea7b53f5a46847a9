#include "ui/window/shell/help.h"

#include <algorithm>
#include <utility>

#include "ui/widgets/controls/button.h"
#include "ui/widgets/controls/marks.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {
namespace {

constexpr float panel_width = 460.0F, row_height = 34.0F, head_height = 60.0F, foot_height = 78.0F;

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

bool draw_shortcut_list(Ui& ui) {
  Canvas& canvas = ui.canvas();
  const LayerScope layer(canvas, Layer::Modal);
  const Theme& theme = ui.theme();
  const std::vector<Shortcut> shortcuts = ui.shortcuts();
  const Rect display = ui.display();
  const float rows = row_height * static_cast<float>(shortcuts.size());
  const float height = std::min(head_height + rows + foot_height, display.h - 16.0F);
  const Rect panel = centred(display, std::min(panel_width, display.w - 16.0F), height);
  canvas.fill(display, theme.scrim);
  draw_popup(canvas, theme, panel, radius::picture);
  const float x = panel.x + space::card, width = panel.w - 2.0F * space::card;
  canvas.text({x, panel.y + 34.0F}, {Type::CardTitle, theme.text}, ui.text("help.title"));
  const Rect list{x, panel.y + head_height, width, height - head_height - foot_height};
  float y = list.y - ui.begin_scroll("help.list", ui.text("help.title"), list, rows);
  for (const Shortcut& shortcut : shortcuts) {
    const std::string keys = chord_text(ui.texts(), shortcut.chord);
    const float chip = key_chip_width(ui, keys);
    canvas.text_in({x, y, width - chip - 24.0F, row_height}, {Type::Body, theme.text_secondary},
                   shortcut.label, true);
    key_chip(ui, {list.right() - chip - 10.0F, y + row_height / 2.0F}, keys);
    y += row_height;
  }
  ui.end_scroll();
  const ButtonSpec close{ui.text("help.close"), ButtonLook::Primary};
  const float button_w = button_width(ui, close);
  const bool is_pressed =
      button(ui, "help.close",
             {panel.right() - space::card - button_w, panel.bottom() - space::card - button_height,
              button_w, button_height},
             close);
  ui.focus_first("help.close");
  return is_pressed || ui.shortcut({Key::Escape}, ui.text("help.close"));
}

}  // namespace hallux::ui
