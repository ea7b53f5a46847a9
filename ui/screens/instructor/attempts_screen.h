/// The attempts that the person who is signed in may see, newest first.
#pragma once

#include <string>
#include <vector>

#include "ui/screens/parts/loaded.h"
#include "ui/screens/parts/navigator.h"
#include "ui/screens/parts/signed_in_session.h"
#include "ui/widgets/controls/row_table.h"
#include "ui/window/shell/shell.h"

namespace hallux::ui {

class AttemptsScreen : public Screen {
 public:
  /// `navigator` outlives the screen.
  AttemptsScreen(std::shared_ptr<SignedInSession> signed_in, Navigator& navigator)
      : signed_in_(std::move(signed_in)), navigator_(navigator) {}

  GuideSection guide_section() const override { return GuideSection::Attempts; }
  std::string_view navigation_id() const override { return "nav.attempts"; }
  void draw(Ui& ui, const Rect& content, Shell& shell) override;

 private:
  void draw_list(Ui& ui, const Rect& content);
  void draw_table(Ui& ui, const Rect& content);

  std::shared_ptr<SignedInSession> signed_in_;
  Navigator& navigator_;
  Loaded<std::vector<database::AttemptHeader>> attempts_;
  TableState table_;
};

}  // namespace hallux::ui
