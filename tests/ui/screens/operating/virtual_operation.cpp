#include "tests/ui/screens/operating/virtual_operation.h"

#include <gtest/gtest.h>

#include <array>
#include <utility>

#include "scenarios/scenario.h"
#include "scenarios/simulation_setup.h"
#include "scenarios/tray/laid_out_tools.h"
#include "simulator/record/sample_force.h"
#include "ui/screens/operating/hand/start_place.h"
#include "ui/screens/operating/operation_work.h"

namespace hallux::ui {

namespace {

constexpr int ticks_per_frame = 20;

PreparedCase coarse_case(const std::string& scenario, double edge_mm) {
  scenarios::Scenario parsed = scenarios::load_shipped_scenario(scenario);
  parsed.patient.edge_mm = edge_mm;
  return prepare_case(parsed, [](const std::string&) { return Progress(); });
}

}  // namespace

StepProgress chain_of(const scenarios::Scenario& scenario) {
  std::vector<scenarios::StepKind> kinds;
  for (const scenarios::OperationStep& step : scenario.steps) kinds.push_back(step.kind);
  return StepProgress(std::move(kinds));
}

VirtualOperation::VirtualOperation(const std::string& scenario, double edge_mm)
    : VirtualOperation(coarse_case(scenario, edge_mm)) {}

VirtualOperation::VirtualOperation(PreparedCase prepared, database::AttemptKind kind)
    : VirtualOperation(std::move(prepared), std::nullopt, kind) {}

VirtualOperation::VirtualOperation(PreparedCase prepared, std::optional<StepProgress> steps,
                                   database::AttemptKind kind)
    : prepared_(std::move(prepared)),
      setup_(simulation_setup(prepared_.scenario, prepared_.bones, prepared_.plan,
                              simulator::Guidance::None)),
      tissues_(setup_.bones()),
      wholes_(setup_),
      simulation_(tissues_.all(), setup_),
      jobs_(wholes_.all(), setup_.tray, setup_.bridges),
      cut_(wholes_.all(), setup_.tray, setup_.bridges),
      survey_(prepared_),
      mouse_(start_pose(prepared_)),
      session_(kind) {
  passes_ = passes_of(prepared_);
  world_from_view = start_camera(prepared_).world_from_view;
  session_.make_ready(steps ? std::move(*steps) : StepProgress(prepared_.scenario),
                      LedSaw(start_pose(prepared_), start_camera(prepared_).target_mm),
                      ToolsInHand(laid_out_tools(prepared_.scenario)));
  session_.begin();
  session_.run(*this, mouse_);
  say({simulator::CommandKind::Start, 0, 0});
}

HudSources VirtualOperation::sources() const {
  return {.texts = texts_,
          .session = session_,
          .prepared_case = prepared_,
          .passes = passes_,
          .loop = loop,
          .site = site(),
          .cut = nullptr,
          .world_from_view = world_from_view};
}

void VirtualOperation::press_step() {
  const CoachView view = coach_view(sources());
  const scenarios::PlannedCut* const cut = cut_of_step(view);
  const bool is_through =
      cut != nullptr && site_ && site_->cuts[index_of_cut(prepared_.plan, cut->name)].is_through();
  session_.press_step(is_through, time_s());
}

void VirtualOperation::advance(int ticks, const simulator::PointerMotion& motion) {
  simulator::PointerMotion due = motion;
  for (int i = 0; i < ticks; ++i) {
    if (i % ticks_per_frame == 0) {
      if (session_.is_led()) session_.lead(std::array{due}, world_from_view, time_s());
      due = {};
      session_.see(site_ ? std::span<const scenarios::WantedPart>(site_->parts)
                         : std::span<const scenarios::WantedPart>());
      static_cast<void>(session_.apply(new_events_, time_s()));
      new_events_.clear();
      survey();
    }
    step_once();
  }
}

void VirtualOperation::step_once() {
  simulator::RawDeviceState raw;
  EXPECT_TRUE(mouse_.exchange(force_newton_, tick_, raw));
  simulator::TapeLine line;
  line.tick = tick_;
  line.ticks = 1;
  line.device.world_from_handle = simulator::quantise(raw.world_from_handle);
  line.device.switches = raw.switches;
  std::array<simulator::JobResult*, simulator::commands_per_tick> results{};
  while (line.command_count < simulator::commands_per_tick && !commands_.empty()) {
    line.commands[line.command_count++] = commands_.front();
    commands_.pop_front();
  }
  while (line.command_count < simulator::commands_per_tick) {
    simulator::JobResult* const result = jobs_.take_ready();
    if (result == nullptr) break;
    results[line.command_count] = result;
    line.commands[line.command_count++] = {simulator::CommandKind::ApplyJob, result->request.id,
                                           result->request.tick};
  }
  const simulator::StepOutput output = simulation_.step({line, results});
  recording_.tape.push_back(line);
  recording_.samples.push_back(output.sample);
  EXPECT_TRUE(jobs_.apply(output));
  for (const simulator::CutEvent& event : output.events) {
    cut_.apply(event);
    survey_.apply(event, cut_);
    recording_.events.push_back(event);
    new_events_.push_back(event);
  }
  cut_.apply(output.sample);
  survey_.apply(output.sample);
  for (const simulator::JobRequest& request : output.requests) {
    cut_.apply(request);
    survey_.apply(request);
  }
  force_newton_ = simulator::force_newton(output.sample);
  loop.sample = output.sample;
  loop.engaged = output.engaged;
  ++loop.lines;
  ++tick_;
}

/// On the operation's own clock.
void VirtualOperation::survey() {
  const SiteSurvey::Time now{std::chrono::milliseconds(tick_ + 1'000'000)};
  if (std::optional<SiteFacts> facts = survey_.renew(cut_, now)) site_ = std::move(facts);
}

}  // namespace hallux::ui
