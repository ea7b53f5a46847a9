/// A person's own attempts at an operation: their scores over time, what to take from them, and
/// each of them to open.
#pragma once

#include <memory>
#include <vector>

#include "ui/screens/parts/loaded.h"
#include "ui/screens/parts/navigator.h"
#include "ui/screens/parts/signed_in_session.h"
#include "ui/screens/trainee/operation_history.h"
#include "ui/widgets/controls/row_table.h"

namespace hallux::ui {

class HistoryScreen : public Screen {
 public:
  /// `navigator` outlives the screen.
  HistoryScreen(std::shared_ptr<SignedInSession> signed_in, Navigator& navigator)
      : signed_in_(std::move(signed_in)), navigator_(navigator) {}

  GuideSection guide_section() const override { return GuideSection::History; }
  std::string_view navigation_id() const override { return "nav.history"; }
  void enter(Shell&) override { histories_.read_again(); }
  void draw(Ui& ui, const Rect& content, Shell& shell) override;

 private:
  void draw_controls(Ui& ui, const Rect& controls, Shell& shell);
  void draw_history(Ui& ui, Rect page);
  void draw_chart(Ui& ui, const Rect& rect);
  void draw_facts(Ui& ui, const Rect& rect) const;
  void draw_attempts(Ui& ui, const Rect& rect);
  void copy(Ui& ui, Shell& shell) const;
  const OperationHistory& history() const;

  std::shared_ptr<SignedInSession> signed_in_;
  Navigator& navigator_;
  Loaded<std::vector<OperationHistory>> histories_;
  int chosen_ = 0;
  TableState table_;
};

}  // namespace hallux::ui
