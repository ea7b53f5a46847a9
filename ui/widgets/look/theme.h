/// The look in numbers: colours of the light and the dark theme, spaces, radii, and the meanings a
/// colour may have.
#pragma once

#include <array>

#include "ui/widgets/look/color.h"

namespace hallux::ui {

enum class ThemeName { Light, Dark };

/// What a colour says, always together with a shape (see shapes.h).
enum class Meaning { Good, Warn, Bad, Info, Neutral };

/// How far a person is with an operation.
enum class Competence { NotStarted, Learning, Competent, Slipped, Stale };

/// Every colour of the product except the bone's. `on_...` is what may be written on it; `..._text`
/// is for words, the plain one for fills and shapes.
struct Theme {
  ThemeName name = ThemeName::Dark;
  Color page, side, card, raise, chip, line, border;
  Color text, text_secondary, text_caption;
  Color accent, on_accent, accent_soft;
  Color good, good_text, warn, warn_text, bad, bad_text, reference = {}, reference_text = {};
  Color focus, popup, popup_border, popup_raise, scrim, hud, hud_border = {};
  Color field, thumb, toggle_off, control_border, axis, meter_off, muted_bar = {}, badge = {},
                                                                   side_chosen = {};
  Color danger, danger_border, on_shape, on_warn, ring_track;
  std::array<Color, 6> avatars;
  Color on_avatar;

  bool is_dark() const noexcept { return name == ThemeName::Dark; }
};

Theme make_theme(ThemeName name) noexcept;

/// The fill of a shape and the colour of words with this meaning.
Color fill_of(const Theme& theme, Meaning meaning) noexcept;
Color text_of(const Theme& theme, Meaning meaning) noexcept;
/// What lies under words with this meaning in a pill: the fill at 16 % (dark) or 13 % (light).
Color tint_of(const Theme& theme, Meaning meaning) noexcept;

/// Spaces and radii in logical pixels.
namespace space {
inline constexpr float page = 32.0F, between_cards = 20.0F, card = 24.0F, side_card = 20.0F;
inline constexpr float side_navigation = 216.0F, rail = 64.0F;
}  // namespace space
namespace radius {
inline constexpr float step = 4.0F, row = 6.0F, control = 8.0F, card = 10.0F, picture = 12.0F;
}  // namespace radius

}  // namespace hallux::ui
