/// Who is in the course now, and which screen is behind each place. Inside this corner only.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string_view>

#include "ui/jobs/devices/own_station.h"
#include "ui/screens/instructor/inbox_screen.h"
#include "ui/screens/parts/navigator.h"
#include "ui/screens/parts/signed_in_session.h"
#include "ui/screens/pictures/patient_pictures.h"
#include "ui/screens/replay/made_replays.h"
#include "ui/window/shell/shell.h"

namespace hallux::ui {

class Course : public Navigator {
 public:
  /// Asks who is there. `texts` and `shell` outlive it.
  Course(const Texts& texts, std::filesystem::path data_directory, Shell& shell,
         database::PasswordCost cost = {});
  Course(const Course&) = delete;
  Course& operator=(const Course&) = delete;

  void brief(database::ScenarioVersionId scenario) override;
  void operate(database::ScenarioVersionId scenario, const WayToOperate& way) override;
  void fly() override;
  void show_result(const database::AttemptId& attempt) override;
  void show_replay(const database::AttemptId& attempt, double moment_s) override;
  void watch_expert(const scenarios::Scenario& scenario) override;
  void show_trainee(database::CohortId cohort, database::PersonId trainee) override;

 private:
  using Shown = std::unique_ptr<Screen>;
  /// A place of the navigation.
  struct Route {
    std::string_view id;
    /// The text that names it.
    std::string_view label;
    Icon icon;
    bool (*is_for)(const SignedInSession& signed_in);
    Shown (*screen)(Course& course);
  };

  static std::span<const Route> routes() noexcept;
  static Shown cohort_screen(Course& course);
  static Shown inbox_screen(Course& course);
  void ask_who();
  void welcome(std::shared_ptr<SignedInSession> signed_in);
  Visitor visitor_of(const SignedInSession& signed_in) const;
  std::vector<Visitor::Place> places_of(const SignedInSession& signed_in) const;
  /// Reads how many questions are open, for the inbox's badge.
  void count_questions();
  void show_badge(int open_questions);
  /// The screen of a place of the navigation.
  void show_place(std::string_view id);
  void show_account();
  /// What the person was told since they were here last.
  void tell_notices();
  void acknowledge(std::shared_ptr<SignedInSession> signed_in, const database::Notice& notice);
  /// Of the devices that are chosen now.
  LendHands lend_hands() const;
  /// Keeps at the person's desk how they hold the saw from now on: one choice after the other.
  void keep_hand(const HandPreferences& hand);
  void keep_next_hand();
  void lock();
  void sign_out();

  const Texts& texts_;
  std::filesystem::path data_directory_;
  Shell& shell_;
  std::shared_ptr<OwnStation> station_;
  database::PasswordCost cost_;
  std::shared_ptr<SignedInSession> signed_in_;
  /// Whose, and how; the newest that is not kept yet.
  struct HandToKeep {
    std::shared_ptr<SignedInSession> whose;
    database::HandSettings hand;
  };
  std::optional<HandToKeep> hand_to_keep_;
  bool is_keeping_hand_ = false;
  std::shared_ptr<InboxScreen::Drafts> answer_drafts_;
  std::shared_ptr<MadeReplays> made_replays_;
  PatientPictures pictures_;
};

}  // namespace hallux::ui
