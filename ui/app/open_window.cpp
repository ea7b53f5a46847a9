#include "ui/app/open_window.h"

#include <memory>
#include <utility>

#include "ui/app/verb_error.h"
#include "ui/screens/attempts_screen.h"
#include "ui/screens/entry_screen.h"
#include "ui/screens/words.h"
#include "ui/window/window.h"

namespace hallux::ui {

namespace {

/// Who is in the course now, and which screens that opens.
class Course {
 public:
  Course(const Texts& texts, std::filesystem::path data_directory, Shell& shell)
      : texts_(texts), data_directory_(std::move(data_directory)), shell_(shell) {
    shell_.on_navigate([this](const std::string&) { show_attempts(); });
    shell_.on_sign_out([this] { sign_out(); });
    ask_who();
  }

 private:
  void ask_who() {
    shell_.set_visitor(std::nullopt);
    shell_.replace_all(std::make_unique<EntryScreen>(
        data_directory_,
        [this](Shell&, std::unique_ptr<Visit> visit) { welcome(std::move(visit)); }));
  }

  void welcome(std::unique_ptr<Visit> visit) {
    visit_ = std::move(visit);
    const database::Person& person = visit_->session->person();
    Visitor visitor;
    visitor.name = person.display_name.empty() ? person.login : person.display_name;
    visitor.role =
        person.is_administrator ? texts_.text("role.administrator") : texts_.text("role.person");
    visitor.initials = initials_of(visitor.name);
    visitor.hue = static_cast<int>(person.id.number % 6);
    visitor.places = {{"nav.attempts", std::string(texts_.text("place.attempts")), Icon::History}};
    shell_.set_visitor(std::move(visitor));
    show_attempts();
  }

  void show_attempts() { shell_.replace_all(std::make_unique<AttemptsScreen>(*visit_)); }

  /// The visit stays until the next one: the screen that borrows it goes after the frame.
  void sign_out() {
    visit_->session->sign_out();
    ask_who();
  }

  const Texts& texts_;
  std::filesystem::path data_directory_;
  Shell& shell_;
  std::unique_ptr<Visit> visit_;
};

}  // namespace

ExitCode open_window(const VerbContext& context,
                     const std::optional<std::filesystem::path>& ui_map) {
  const Texts texts = english_texts();
  WindowSetting setting;
  setting.ui_map = ui_map;
  try {
    Window window(texts, setting);
    Shell shell(Window::wake);
    const Course course(texts, context.data_directory, shell);
    window.run(shell);
  } catch (const WindowError& error) {
    throw VerbError(ExitCode::NoDisplay, error.what());
  }
  return ExitCode::Done;
}

}  // namespace hallux::ui
