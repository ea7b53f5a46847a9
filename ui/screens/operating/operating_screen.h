/// The screen of an operation: an attempt from preparing to its score, with its cards.
#pragma once

#include <memory>

#include "ui/screens/operating/operating_field.h"
#include "ui/screens/operating/operation_work.h"
#include "ui/screens/parts/loaded.h"
#include "ui/screens/parts/navigator.h"
#include "ui/screens/parts/signed_in_session.h"
#include "ui/window/shell/shell.h"

namespace hallux::ui {

/// What somebody chose to operate.
struct OperationChoice {
  database::ScenarioVersionId scenario;
  WayToOperate way = {};
};

class OperatingScreen : public Screen {
 public:
  OperatingScreen(std::shared_ptr<SignedInSession> signed_in, Navigator& navigator,
                  const OperationChoice& choice, LendHands lend_hands);

  WindowChrome surround() const override { return WindowChrome::Badge; }
  std::string_view why_not_leave() const override;
  /// Stops the saw and asks: finish, abandon, or go on.
  bool ask_before_leaving(Ui& ui) override;
  /// Covered by another screen, or by the lock: nobody holds the saw.
  void leave(Shell&) override { field_.session().pause(PausedBy::Locked); }
  GuideSection guide_section() const override { return GuideSection::Operate; }
  void be_covered() override { field_.session().pause(PausedBy::Covered); }
  void draw(Ui& ui, const Rect& content, Shell& shell) override;

 private:
  /// What the work that begins hands over.
  struct Begun {
    std::unique_ptr<LiveAttempt> live;
    /// Of live.
    simulator::SteeredDevice* device = nullptr;
    std::unique_ptr<simulator::SecondHand> second = nullptr;
    /// Why the device cannot be had; empty where it is.
    std::string refused = {};
  };
  using Phase = OperatingSession::Phase;

  OperatingSession& session() noexcept { return field_.session(); }
  const OperatingSession& session() const noexcept { return field_.session(); }

  void prepare(Ui& ui, Shell& shell);
  void begin(Ui& ui, Shell& shell);
  LiveBegin what_to_begin() const;

  void draw_operation(Ui& ui, Shell& shell);
  /// What is on the screen, as it is kept beside the recording.
  simulator::ShownView shown_view(const Ui& ui) const;
  void draw_cards(Ui& ui, Shell& shell);
  void draw_ready(Ui& ui, Shell& shell);
  void draw_device_lost(Ui& ui);
  void draw_hud(Ui& ui, Shell& shell);
  void ask(Ui& ui);
  void draw_stopped(Ui& ui, Shell& shell);

  void lead_on(Ui& ui, Shell& shell);
  void score(const Ui& ui, Shell& shell);
  void show_result(Shell& shell);

  std::shared_ptr<SignedInSession> signed_in_;
  Navigator& navigator_;
  OperationChoice choice_;
  LendHands lend_hands_;
  /// Of the last frame.
  const Texts* texts_ = nullptr;
  Loaded<PreparedOperation> prepared_;
  ScreenWork work_;
  /// The attempt that runs.
  std::unique_ptr<LiveAttempt> live_;
  /// After live_, which it follows.
  OperatingField field_;
};

}  // namespace hallux::ui
