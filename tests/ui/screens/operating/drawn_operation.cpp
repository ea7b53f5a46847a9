#include "tests/ui/screens/operating/drawn_operation.h"

#include <epoxy/gl.h>

namespace hallux::ui {

DrawnOperation::DrawnOperation(const std::string& scenario, double edge_mm, PixelSize size,
                               const std::string& vfs_name, LendHands lend)
    : target_(size),
      course_(scenario, edge_mm, vfs_name),
      person_((scenes_.begin_frame(target_.target()), course_), database::AttemptKind::Practice,
              1.0F, {static_cast<float>(size.width), static_cast<float>(size.height)}, &scenes_,
              std::move(lend)) {}

double DrawnOperation::frame() {
  const auto start = std::chrono::steady_clock::now();
  scenes_.begin_frame(target_.target());
  const std::chrono::duration<double> since_s = start - last_;
  last_ = start;
  person_.driver().frame(since_s.count());
  const Color page = person_.driver().ui().theme().page;
  scenes_.finish_frame({page.red, page.green, page.blue}, [&](float columns) {
    painter_.draw(person_.driver().ui().draw_data(), person_.driver().ui().fonts_version(),
                  columns);
  });
  glFinish();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

bool DrawnOperation::until(const std::function<bool()>& holds, double seconds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (!holds()) {
    if (std::chrono::steady_clock::now() > end) return false;
    frame();
  }
  return true;
}

void DrawnOperation::press(Key key, int times, Modifiers modifiers) {
  for (int i = 0; i < times; ++i) {
    person_.driver().send(key_events(key, modifiers));
    frame();
    frame();
  }
}

void DrawnOperation::click(std::string_view id) {
  person_.driver().send(click_events(person_.driver().widget(id).visible.centre()));
  for (int i = 0; i < 4; ++i) frame();
}

void DrawnOperation::move_to(Point place) {
  person_.driver().send({person_.driver().moved_to(place)});
  frame();
  frame();
}

void DrawnOperation::take(const std::filesystem::path& folder, const std::string& name) {
  if (folder.empty()) return;
  frame();
  write_png(folder / (name + ".png"), picture());
}

}  // namespace hallux::ui
