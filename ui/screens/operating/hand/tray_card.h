/// The tray over the picture: every tool that is laid out, by kind, to be taken by mouse or keys.
#pragma once

#include <optional>

#include "ui/screens/operating/hand/tools_in_hand.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

/// "Screwdriver" and "screw 2.7 × 24 mm"; "Drill" and "2 mm".
struct ToolWords {
  std::string title, size;
};
ToolWords tool_words(const Texts& texts, const scenarios::LaidOutTool& tool);
/// Both: "Screwdriver, screw 2.7 × 24 mm".
std::string tool_text(const Texts& texts, const scenarios::LaidOutTool& tool);

struct TrayAnswer {
  bool is_closed = false;
  /// That was taken.
  std::optional<std::int32_t> place = {};
};
/// Tools are named "operate.tray.0", "operate.tray.1" ... by their place; arrows lead among them,
/// Enter and Space take one, Esc closes.
TrayAnswer draw_tray_card(Ui& ui, const ToolsInHand& tools);

}  // namespace hallux::ui
