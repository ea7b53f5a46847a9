#include "tests/screenshots/window/photographer.h"

#include <chrono>
#include <stdexcept>
#include <thread>

#include "ui/render/picture.h"

namespace hallux::tests {

namespace {

constexpr ui::PixelSize picture_size{1440, 900};
// Whatever fades in has done so by then.
constexpr double settled_s = 1.0;
constexpr std::chrono::minutes patience{2};

}  // namespace

Photographer::Photographer(const std::filesystem::path& data_directory,
                           std::filesystem::path folder, ui::ThemeName theme)
    : target_(picture_size), folder_(std::move(folder)) {
  ui::DriverSetting setting;
  setting.width = static_cast<float>(picture_size.width);
  setting.height = static_cast<float>(picture_size.height);
  window_ = std::make_unique<ui::CourseWindow>(
      data_directory, database::PasswordCost{},
      [this](ui::Shell& shell, ui::Ui& ui) { draw(shell, ui); }, setting);
  window_->shell().preferences().theme = theme;
  painter_ = std::make_unique<ui::ImguiPainter>();
  window_->finish_work();
}

void Photographer::draw(ui::Shell& shell, ui::Ui& ui) {
  scenes_.begin_frame(target_.target());
  shell.draw(ui, scenes_);
}

void Photographer::sign_in(const std::string& login, const std::string& password) {
  if (!driver().has("entry.sign_in")) {
    press("nav.person");
    press("person.3");
  }
  window_->sign_in(login, password);
}

void Photographer::press(std::string_view id) {
  driver().click(id);
  window_->finish_work();
}

void Photographer::key(ui::Key key, ui::Modifiers modifiers) {
  driver().send(ui::key_events(key, modifiers));
  driver().frame();
}

void Photographer::wait_until(const std::string& what, const std::function<bool()>& is_so) {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (!is_so()) {
    if (std::chrono::steady_clock::now() > end) throw std::runtime_error("never came: " + what);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    driver().frame();
  }
}

void Photographer::work_for(double seconds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  wait_until("time", [&] { return std::chrono::steady_clock::now() > end; });
}

std::string Photographer::first(std::string_view beginning) {
  for (const ui::Widget& widget : driver().content().widgets)
    if (widget.id.starts_with(beginning) && widget.role != ui::Role::Scroll) return widget.id;
  throw std::runtime_error("no control begins with " + std::string(beginning));
}

void Photographer::take(const std::string& name) {
  driver().move_to({-9.0F, -9.0F});
  driver().wait(settled_s);
  take_now(name);
}

void Photographer::take_now(const std::string& name) {
  scenes_.set_quality(ui::still_quality);
  driver().frame();
  scenes_.set_quality(ui::live_quality());
  const ui::Color page = driver().ui().theme().page;
  scenes_.finish_frame({page.red, page.green, page.blue}, [&](float columns) {
    painter_->draw(driver().ui().draw_data(), driver().ui().fonts_version(), columns);
  });
  ui::write_png(folder_ / (name + ".png"), target_.read());
}

}  // namespace hallux::tests
