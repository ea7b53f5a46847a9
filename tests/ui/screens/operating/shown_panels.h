/// The panels of an operation over nothing, at a window and scale.
#pragma once

#include "tests/ui/widgets/driver.h"
#include "ui/screens/operating/hud/operating_hud.h"

namespace hallux::ui {

struct ShownPanels {
  explicit ShownPanels(float scale = 1.0F, Point size = {1440.0F, 900.0F})
      : driver(texts, [this](Ui& ui) { answer = draw_operating_hud(ui, hud); },
               {size.x, size.y, scale}) {
    hud.steps = {{.title = "Verify the case"}};
  }
  ShownPanels(const ShownPanels&) = delete;
  ShownPanels& operator=(const ShownPanels&) = delete;

  /// Of a read-out; "" where there is none.
  std::string told(std::string_view id) const {
    for (const ReadOut& read_out : driver.content().read_outs)
      if (read_out.id == id) return read_out.text;
    return {};
  }
  Rect place_told(std::string_view id) const {
    for (const ReadOut& read_out : driver.content().read_outs)
      if (read_out.id == id) return read_out.rect;
    return {};
  }

  OperatingHud hud;
  HudAnswer answer;
  Texts texts = english_texts();
  Driver driver;
};

}  // namespace hallux::ui
