/// The screen of the first flight: a minute of lessons on a block, each done by doing. Nothing of
/// it is recorded or scored.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "ui/jobs/unrecorded_attempt.h"
#include "ui/screens/operating/flight/flight_lessons.h"
#include "ui/screens/operating/flight/lesson_deeds.h"
#include "ui/screens/operating/operating_field.h"
#include "ui/screens/parts/loaded.h"
#include "ui/screens/parts/signed_in_session.h"
#include "ui/window/shell/shell.h"

namespace hallux::ui {

class FlightScreen : public Screen {
 public:
  FlightScreen(std::shared_ptr<SignedInSession> signed_in, LendHands lend_hands);

  WindowChrome surround() const override { return WindowChrome::Badge; }
  /// Covered by another screen, or by the lock: nobody holds the saw.
  void leave(Shell&) override;
  void be_covered() override;
  GuideSection guide_section() const override { return GuideSection::Flight; }
  void draw(Ui& ui, const Rect& content, Shell& shell) override;

 private:
  /// A block under the saw, from the uncut one to the end of its loop.
  struct Block {
    std::unique_ptr<UnrecordedAttempt> loop = {};
    /// After loop, which it follows.
    OperatingField field{database::AttemptKind::Practice, simulator::Guidance::None};
  };

  void prepare(Ui& ui, Shell& shell);
  /// Puts an uncut block under the saw.
  void lay_block(Ui& ui, Shell& shell);
  void begin_again(Ui& ui, Shell& shell);
  void fly(Ui& ui, Shell& shell);
  void hear_keys(Ui& ui, Shell& shell);
  /// Ends the lessons whose deed is done.
  void look(Ui& ui);
  void skip(Ui& ui);
  void draw_hud(Ui& ui, Shell& shell);
  OperatingHud hud(const Ui& ui, Shell& shell);
  void draw_cards(Ui& ui, Shell& shell);
  void draw_stopped(Ui& ui, Shell& shell);
  LessonView view(const Texts& texts) const;
  std::vector<Mark> goals(const Texts& texts) const;

  std::shared_ptr<SignedInSession> signed_in_;
  LendHands lend_hands_;
  Loaded<PreparedOperation> prepared_;
  ScreenWork work_;
  std::unique_ptr<Block> block_;
  FlightLessons lessons_;
  /// Of which the one at hand saws: what the coach leads by.
  StepProgress sawing_{{scenarios::StepKind::Cut}};
  Quat world_from_first_view_{1.0, 0.0, 0.0, 0.0};
};

}  // namespace hallux::ui
