#include "ui/screens/replay/made_replays.h"

#include <chrono>

#include "simulator/base/progress.h"

namespace hallux::ui {

namespace {

constexpr std::chrono::milliseconds asked_again_after{50};

std::filesystem::path directory_for(SignedInSession& signed_in) {
  return signed_in.in_turn([](database::Session& session, database::Database& database) {
    refuse_in_assessment(session);
    return database.directory();
  });
}

}  // namespace

std::shared_ptr<const ReplayMaterial> MadeReplays::find_or_make(const scenarios::Scenario& scenario,
                                                                SignedInSession& signed_in,
                                                                WorkReport& report) {
  const std::filesystem::path directory = directory_for(signed_in);
  std::unique_lock turn(turn_, std::defer_lock);
  while (!turn.try_lock_for(asked_again_after)) {
    if (!report.reached(0.0)) throw Cancelled("stopped before the hand began; nothing was kept");
  }
  std::shared_ptr<const ReplayMaterial>& made = made_[scenario.text];
  if (!made) made = make_(scenario, directory, report);
  return made;
}

}  // namespace hallux::ui
