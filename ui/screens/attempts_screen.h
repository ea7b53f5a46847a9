/// The attempts that the person who is signed in may see, newest first.
#pragma once

#include <string>
#include <vector>

#include "ui/screens/visit.h"
#include "ui/widgets/table.h"
#include "ui/window/shell/shell.h"

namespace hallux::ui {

class AttemptsScreen : public Screen {
 public:
  /// `visit` is borrowed and outlives the screen.
  explicit AttemptsScreen(Visit& visit) : visit_(visit) {}

  std::string_view navigation_id() const override { return "nav.attempts"; }
  std::string_view why_not_leave() const override;
  void draw(Ui& ui, const Rect& content, Shell& shell) override;

 private:
  enum class State { New, Reading, Shown, Failed };

  void read(Ui& ui, Shell& shell);
  void draw_table(Ui& ui, const Rect& content);
  void sort();

  Visit& visit_;
  State state_ = State::New;
  double reading_since_s_ = 0.0;
  std::string reading_, fault_;
  std::vector<database::AttemptHeader> attempts_, read_;  ///< as shown; as the work reads them
  TableState table_;
};

}  // namespace hallux::ui
