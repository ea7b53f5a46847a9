/// Replays of simulated hands: made once for whoever is signed in, and kept until they operate or
/// leave.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "ui/screens/replay/replay_material.h"

namespace hallux::ui {

class MadeReplays {
 public:
  /// See make_replay.
  using Make = std::function<std::shared_ptr<const ReplayMaterial>(
      const scenarios::Scenario& scenario, const std::filesystem::path& directory,
      WorkReport& report)>;

  explicit MadeReplays(Make make = make_replay) : make_(std::move(make)) {}

  /// The expert hand at that operation. Who asks for one while another is being made waits for it.
  /// errors  DatabaseError Refused while the person is in an assessment; as make_replay
  /// thread  work's, any
  std::shared_ptr<const ReplayMaterial> find_or_make(const scenarios::Scenario& scenario,
                                                     SignedInSession& signed_in,
                                                     WorkReport& report);

 private:
  Make make_;
  std::timed_mutex turn_;
  /// By the scenario's text.
  std::map<std::string, std::shared_ptr<const ReplayMaterial>> made_;
};

}  // namespace hallux::ui
