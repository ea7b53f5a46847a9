// A full disk while somebody operates: the recorder waits for room and the loop pauses; the screen says where and how to mend it.
#include <algorithm>
#include <string>

#include "ui/screens/operating/operating_screen.h"
#include "ui/widgets/controls/button.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {

namespace {

/// How soon the screen notices that there is room again.
constexpr double look_again_s = 0.2;
constexpr float title_height = 28.0F;

}  // namespace

/// The operation goes on where the person says so: nobody knows where the hand is by the time that there is room.
void OperatingScreen::follow_storage(Ui& ui) {
  if (phase_ != Phase::Operating && phase_ != Phase::Sealing) return;
  const bool is_full = begun_->live->is_storage_full();
  if (is_full) ui.want_frame_in_s(look_again_s);
  if (is_full == is_storage_full_) return;
  is_storage_full_ = is_full;
  ui.want_frame_in_s(0.0);
  if (phase_ != Phase::Operating) return;
  if (is_full) {
    set_paused(true);
  } else if (is_paused_) {
    paused_by_ = "operate.paused.room";
  }
}

void OperatingScreen::draw_storage_full(Ui& ui) {
  const Rect display = ui.display();
  const float width = std::min(560.0F, display.w - 32.0F), inner = width - 48.0F;
  const std::string words =
      ui.texts().say("operate.full.sentence", {{"directory", begun_->live->directory().string()}});
  const float words_height = ui.paragraph_height(Type::Small, words, inner);
  const float height = 44.0F + words_height + 12.0F + button_height + 16.0F;
  const LayerScope layer(ui.canvas(), Layer::Page);
  const Rect rect = centred(display, width, height);
  draw_hud_panel(ui.canvas(), ui.theme(), rect);
  ui.canvas().text_in({rect.x + 24.0F, rect.y + 12.0F, inner, title_height},
                      {Type::CardTitle, ui.theme().text, Align::Centre}, ui.text("operate.full"));
  ui.canvas().paragraph({rect.x + 24.0F, rect.y + 44.0F, inner, words_height},
                        {Type::Small, ui.theme().text_secondary, Align::Centre}, words);
  const ButtonSpec stop{ui.text("operate.full.stop"), ButtonLook::Secondary};
  const float stop_width = button_width(ui, stop);
  if (button(ui, "operate.full.stop",
             {rect.mid_x() - 0.5F * stop_width, rect.bottom() - 16.0F - button_height, stop_width,
              button_height},
             stop)) {
    give_up_on_storage(ui);
  }
}

/// Ends as a failure of the disk does: what was committed is kept as interrupted.
void OperatingScreen::give_up_on_storage(Ui& ui) {
  phase_ = Phase::Sealing;
  sealing_since_s_ = ui.time_s();
  begun_->live->abandon();
}

}  // namespace hallux::ui
