#include "ui/widgets/controls/pager.h"

#include <algorithm>
#include <string>

#include "ui/widgets/controls/button.h"

namespace hallux::ui {

int pager(Ui& ui, std::string_view id, const Rect& line, const PagerSpec& spec) {
  const std::string prefix(id);
  const int last = std::max(0, spec.count - spec.shown);
  // The glyph of the last arrow, not its button, stands at the end of the line.
  Rect rest{line.x, line.y, line.w + 10.0F, line.h};
  const Rect on_place = take_right(rest, pager_height, 4.0F);
  const float width = ui.width_of(Type::Small, spec.words) + 1.0F;
  const Rect words_place = take_right(rest, width, 4.0F);
  const Rect back_place = take_right(rest, pager_height);
  const std::string_view at_first = spec.first > 0 ? std::string_view() : ui.text("pager.at_first");
  const std::string_view at_last =
      spec.first < last ? std::string_view() : ui.text("pager.at_last");
  const bool goes_back = icon_button(ui, prefix + ".back", back_place,
                                     {.label = spec.back, .icon = Icon::Left, .why_off = at_first});
  ui.canvas().text_in(words_place, {Type::Small, ui.theme().text_secondary, Align::Right},
                      spec.words);
  const bool goes_on = icon_button(ui, prefix + ".on", on_place,
                                   {.label = spec.on, .icon = Icon::Right, .why_off = at_last});
  if (!goes_back && !goes_on) return std::clamp(spec.first, 0, last);
  ui.want_frame_in_s(0.0);
  return std::clamp(spec.first + (goes_on ? spec.shown : -spec.shown), 0, last);
}

}  // namespace hallux::ui
