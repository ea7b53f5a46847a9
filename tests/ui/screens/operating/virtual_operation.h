/// An operation in virtual time, without window, loop or database: the step, its jobs at once, the
/// site as the picture's thread surveys it, and a session that leads a mouse.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "simulator/contact/tissue.h"
#include "simulator/device/mouse.h"
#include "simulator/jobs/live_cut.h"
#include "simulator/loop/jobs.h"
#include "simulator/step/simulation.h"
#include "ui/jobs/live_attempt.h"
#include "ui/screens/operating/hud_facts.h"
#include "ui/screens/operating/operating_session.h"
#include "ui/screens/operating/site/site_survey.h"

namespace hallux::ui {

/// Of all steps of a scenario, as a chain.
StepProgress chain_of(const scenarios::Scenario& scenario);

class VirtualOperation final : private CommandControls {
 public:
  /// A coarse patient of a shipped scenario; practice, with the clock running.
  explicit VirtualOperation(const std::string& scenario, double edge_mm = 1.0);
  explicit VirtualOperation(PreparedCase prepared,
                            database::AttemptKind kind = database::AttemptKind::Practice);
  /// steps  of the session; nothing: those of its scenario
  VirtualOperation(PreparedCase prepared, std::optional<StepProgress> steps,
                   database::AttemptKind kind);

  /// So much time, with these motions of the hand in the first frame of it.
  void advance(int ticks, const simulator::PointerMotion& motion = {});
  void press_step();

  OperatingSession& session() noexcept { return session_; }
  const PreparedCase& prepared_case() const noexcept { return prepared_; }
  double time_s() const noexcept { return static_cast<double>(tick_) * step_s; }
  const std::vector<simulator::CutEvent>& events() const noexcept { return recording_.events; }
  /// All that came in and out so far.
  const simulator::Recording& recording() const noexcept { return recording_; }
  const simulator::SimulationSetup& setup() const noexcept { return setup_; }
  const SiteFacts* site() const noexcept { return site_ ? &*site_ : nullptr; }
  /// As the screen tells from it; borrows this.
  HudSources sources() const;

  /// Of whoever looks.
  Quat world_from_view{1.0, 0.0, 0.0, 0.0};
  simulator::LoopView loop;

 private:
  void abandon() override {}
  bool is_storage_full() const noexcept override { return false; }
  const LiveEnd* end() const noexcept override { return nullptr; }

  void say(const simulator::Command& command) override { commands_.push_back(command); }
  void step_once();
  void survey();

  const Texts texts_ = english_texts();
  const PreparedCase prepared_;
  const simulator::SimulationSetup setup_;
  const simulator::TissueMaps tissues_;
  const simulator::WholeBones wholes_;
  simulator::Simulation simulation_;
  simulator::ImmediateJobs jobs_;
  simulator::LiveCut cut_;
  SiteSurvey survey_;
  simulator::MouseDevice mouse_;
  OperatingSession session_;
  std::vector<scenarios::PlannedPasses> passes_;
  std::deque<simulator::Command> commands_;
  std::vector<simulator::CutEvent> new_events_;
  simulator::Recording recording_;
  std::optional<SiteFacts> site_;
  Vec3 force_newton_{0.0, 0.0, 0.0};
  std::int64_t tick_ = 0;
};

}  // namespace hallux::ui
