#include "ui/widgets/look/theme.h"

namespace hallux::ui {
namespace {

Theme dark_theme() noexcept {
  Theme theme;
  theme.name = ThemeName::Dark;
  theme.page = rgb(0x10161B), theme.side = rgb(0x0C1115), theme.card = rgb(0x171F26);
  theme.raise = rgb(0x212B33), theme.chip = rgb(0x25303A);
  theme.line = rgb(0x29343D), theme.border = rgb(0x66757F);
  theme.text = rgb(0xE9EFF3), theme.text_secondary = rgb(0xB2BEC7),
  theme.text_caption = rgb(0x8E9CA6);
  theme.accent = rgb(0x5CB2F0), theme.on_accent = rgb(0x06131D), theme.accent_soft = rgb(0x1A3347);
  theme.good = rgb(0x2DB98F), theme.good_text = rgb(0x4CCBA4);
  theme.warn = rgb(0xE9A820), theme.warn_text = rgb(0xF0B949);
  theme.bad = rgb(0xEC6F33), theme.bad_text = rgb(0xFF9A66);
  theme.reference = rgb(0xE763AE), theme.reference_text = rgb(0xE29CC2);
  theme.focus = rgb(0x9AD1FA);
  theme.popup = rgb(0x25303A), theme.popup_border = rgb(0x3A4751),
  theme.popup_raise = rgb(0x313E49);
  theme.scrim = rgb(0x05080A, 150);
  theme.hud = rgb(0x0C1115, 199), theme.hud_border = rgb(0x3A464F, 170);
  theme.field = rgb(0x0E1419), theme.thumb = rgb(0x35424C), theme.toggle_off = rgb(0x66757F);
  theme.control_border = rgb(0x3A4751), theme.axis = rgb(0x4A5862), theme.meter_off = rgb(0x303C46);
  theme.muted_bar = rgb(0x44535E), theme.badge = rgb(0x25303A), theme.side_chosen = rgb(0x1B262E);
  theme.danger = rgb(0x3A2318), theme.danger_border = rgb(0x6B3A20);
  theme.on_shape = rgb(0x0C1115), theme.on_warn = rgb(0x0C1115), theme.ring_track = rgb(0x3B4A55);
  theme.avatars = {rgb(0x2F4A63), rgb(0x37554C), rgb(0x5A4A34),
                   rgb(0x57405A), rgb(0x3D4F5C), rgb(0x4E4440)};
  theme.on_avatar = rgb(0xEAF0F4);
  return theme;
}

Theme light_theme() noexcept {
  Theme theme;
  theme.name = ThemeName::Light;
  theme.page = rgb(0xF4F6F8), theme.side = rgb(0xEAEEF1), theme.card = rgb(0xFFFFFF);
  theme.raise = rgb(0xEDF1F4), theme.chip = rgb(0xE3E9EE);
  theme.line = rgb(0xDDE3E8), theme.border = rgb(0x7F8D98);
  theme.text = rgb(0x14202A), theme.text_secondary = rgb(0x43525D),
  theme.text_caption = rgb(0x5C6A75);
  theme.accent = rgb(0x0067A8), theme.on_accent = rgb(0xFFFFFF), theme.accent_soft = rgb(0xDFEEF9);
  theme.good = rgb(0x009E73), theme.good_text = rgb(0x00734F);
  theme.warn = rgb(0xC88400), theme.warn_text = rgb(0x855400);
  theme.bad = rgb(0xD55E00), theme.bad_text = rgb(0xAD4300);
  theme.reference = rgb(0xB03C86), theme.reference_text = rgb(0x97436F);
  theme.focus = rgb(0x0067A8);
  theme.popup = rgb(0xFFFFFF), theme.popup_border = rgb(0xDDE3E8),
  theme.popup_raise = rgb(0xEDF1F4);
  theme.scrim = rgb(0x14202A, 90);
  theme.hud = rgb(0xFFFFFF, 225), theme.hud_border = rgb(0xC9D2D9, 220);
  theme.field = rgb(0xFFFFFF), theme.thumb = rgb(0xFFFFFF), theme.toggle_off = rgb(0x7F8D98);
  theme.control_border = rgb(0xC9D2D9), theme.axis = rgb(0xAAB6BF), theme.meter_off = rgb(0xD5DDE3);
  theme.muted_bar = rgb(0xB9C5CD), theme.badge = rgb(0xD8E0E6), theme.side_chosen = rgb(0xFFFFFF);
  theme.danger = rgb(0xFDEEE4), theme.danger_border = rgb(0xE9B391);
  theme.on_shape = rgb(0xFFFFFF), theme.on_warn = rgb(0x14202A), theme.ring_track = rgb(0xC6D0D8);
  theme.avatars = {rgb(0xCFE2F3), rgb(0xCDE8DE), rgb(0xF3E3C3),
                   rgb(0xEAD5E3), rgb(0xD8E1E8), rgb(0xE8DED8)};
  theme.on_avatar = rgb(0x24323D);
  return theme;
}

}  // namespace

Theme make_theme(ThemeName name) noexcept {
  return name == ThemeName::Dark ? dark_theme() : light_theme();
}

// In the order of Meaning.
Color fill_of(const Theme& theme, Meaning meaning) noexcept {
  const Color fills[] = {theme.good, theme.warn, theme.bad, theme.accent, theme.text_caption};
  return fills[static_cast<std::size_t>(meaning)];
}

Color text_of(const Theme& theme, Meaning meaning) noexcept {
  const Color texts[] = {theme.good_text, theme.warn_text, theme.bad_text, theme.accent,
                         theme.text_secondary};
  return texts[static_cast<std::size_t>(meaning)];
}

Color tint_of(const Theme& theme, Meaning meaning) noexcept {
  if (meaning == Meaning::Neutral) return theme.chip;
  return faded(fill_of(theme, meaning), theme.is_dark() ? 0.16F : 0.13F);
}

}  // namespace hallux::ui
