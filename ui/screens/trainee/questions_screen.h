/// What one asked about moments of one's own attempts, and what was answered.
#pragma once

#include <vector>

#include "ui/screens/parts/loaded.h"
#include "ui/screens/parts/navigator.h"
#include "ui/screens/parts/signed_in_session.h"

namespace hallux::ui {

class QuestionsScreen : public Screen {
 public:
  /// `navigator` outlives the screen.
  QuestionsScreen(std::shared_ptr<SignedInSession> signed_in, Navigator& navigator)
      : signed_in_(std::move(signed_in)), navigator_(navigator) {}

  GuideSection guide_section() const override { return GuideSection::Questions; }
  std::string_view navigation_id() const override { return "nav.questions"; }
  /// What was answered in the meantime is read anew.
  void enter(Shell&) override { questions_.read_again(); }
  void draw(Ui& ui, const Rect& content, Shell& shell) override;

 private:
  void draw_list(Ui& ui, const Rect& content);
  void draw_chosen(Ui& ui, const Rect& content);

  std::shared_ptr<SignedInSession> signed_in_;
  Navigator& navigator_;
  Loaded<std::vector<database::HelpRequest>> questions_;
  database::HelpRequestId chosen_;
};

}  // namespace hallux::ui
