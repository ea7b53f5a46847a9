#include "ui/screens/sign_in/sign_in_wait.h"

#include <cmath>

#include "ui/widgets/shapes.h"

namespace hallux::ui {

int SignInWait::left_s(Ui& ui) {
  if (const int told_s = std::exchange(told_s_, 0); told_s > 0) until_s_ = ui.time_s() + told_s;
  const double left_s = until_s_ - ui.time_s();
  if (until_s_ < 0.0 || left_s <= 0.0) return 0;
  const double whole_s = std::ceil(left_s);
  ui.want_frame_in_s(left_s - (whole_s - 1.0));
  return static_cast<int>(whole_s);
}

void SignInWait::draw_fault(Ui& ui, Rect& column, std::string& fault) {
  const int seconds = left_s(ui);
  if (seconds > 0) {
    fault = ui.texts().say_count("entry.wait", seconds);
  } else if (until_s_ >= 0.0) {
    until_s_ = -1.0;
    fault.clear();
  }
  if (fault.empty()) return;
  const float height = ui.paragraph_height(Type::Small, fault, column.w - 28.0F);
  const Rect line = take_top(column, height, entry_field_gap);
  draw_meaning(ui.canvas(), ui.theme(), Meaning::Bad, {line.x + 8.0F, line.y + 9.0F}, 8.0F);
  ui.canvas().paragraph({line.x + 28.0F, line.y, line.w - 28.0F, height},
                        {Type::Small, ui.theme().bad_text}, fault);
}

}  // namespace hallux::ui
