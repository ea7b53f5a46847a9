#include "ui/widgets/controls/scroll_keys.h"

#include <array>

namespace hallux::ui {

namespace {

constexpr float line = 48.0F, kept_in_sight = 48.0F, to_the_end = 1e9F;

}  // namespace

void scroll_by_keys(Ui& ui, std::string_view id, float seen) {
  const float page = std::max(line, seen - kept_in_sight);
  const std::array<std::pair<Key, float>, 6> ways{{{Key::Up, -line},
                                                   {Key::Down, line},
                                                   {Key::PageUp, -page},
                                                   {Key::PageDown, page},
                                                   {Key::Home, -to_the_end},
                                                   {Key::End, to_the_end}}};
  for (const auto& [key, distance] : ways) {
    const int repeats = ui.shortcut_repeats({key}, ui.text("scroll.by_keys"));
    if (repeats > 0) ui.scroll_by(id, distance * static_cast<float>(repeats));
  }
}

}  // namespace hallux::ui
