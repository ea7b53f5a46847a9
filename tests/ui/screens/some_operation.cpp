#include "tests/ui/screens/some_operation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "assessment/assess.h"
#include "assessment/rebuild/rebuild.h"
#include "database/content/assets.h"
#include "tests/assessment/akin_attempt.h"
#include "tests/scenarios/format_1/format_1.h"

namespace hallux::ui {

namespace {

using simulator::CutEvent;
using simulator::CutEventKind;
using simulator::Recording;
using simulator::TapeLine;
using simulator::ToolSample;
using simulator::ToolStatus;

/// A rubric of which some is measured, as older ones are: of safety the over-cut, and accuracy.
std::string partly_measured(const std::string& text) {
  nlohmann::json scenario = nlohmann::json::parse(text);
  nlohmann::json& rubric = scenario["rubric"];
  nlohmann::json items = nlohmann::json::array(), gates = nlohmann::json::array();
  for (const nlohmann::json& item : rubric["items"])
    if (item["group"] == "accuracy" || item["id"] == "H1") items.push_back(item);
  for (const nlohmann::json& gate : rubric["gates"])
    if (gate.contains("hinge") && gate["name"] != "wedge_reversed") gates.push_back(gate);
  for (nlohmann::json& group : rubric["groups"])
    if (group["name"] == "safety") group["not_measured"] = 14;
  scenario.erase("proof");
  rubric["items"] = items;
  rubric["gates"] = gates;
  return scenario.dump(2);
}

/// The operation of format 1 with a blade that takes the whole section in one stroke.
scenarios::Scenario wide_akin() {
  std::string text = partly_measured(scenarios_test::format_1("akin").text);
  const auto replace = [&](const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
  };
  replace("\"width_mm\": 12", "\"width_mm\": 20");
  replace("\"depth_mm\": 25", "\"depth_mm\": 40");
  return scenarios::parse_scenario(text, "akin");
}

CutEvent event_at(std::int64_t tick, CutEventKind kind, std::int32_t subject,
                  std::int64_t value = 0) {
  CutEvent event;
  event.tick = tick;
  event.kind = kind;
  event.subject = subject;
  event.value = value;
  return event;
}

/// Between the strokes the tool stands still with the saw off.
void fill_gaps(Recording& recording, std::int64_t last_tick) {
  std::vector<ToolSample> whole;
  std::size_t next = 0;
  ToolSample rest = recording.samples.front();
  rest.kerf = -1;
  rest.force_mn = {};
  rest.status = static_cast<std::uint32_t>(ToolStatus::Running);
  for (std::int64_t tick = 0; tick <= last_tick; ++tick) {
    const bool is_there = next < recording.samples.size() && recording.samples[next].tick == tick;
    ToolSample sample = is_there ? recording.samples[next++] : rest;
    sample.tick = tick;
    sample.status |= static_cast<std::uint32_t>(ToolStatus::Running);
    rest.world_from_tool = sample.world_from_tool;
    whole.push_back(sample);
    TapeLine line;
    line.tick = tick;
    line.device.world_from_handle = sample.world_from_tool;
    recording.tape.push_back(line);
  }
  recording.samples = std::move(whole);
}

/// The job of the pieces, asked for after that tick and applied at the next.
void apply_pieces(Recording& recording, std::int64_t asked_tick) {
  TapeLine& line = recording.tape[static_cast<std::size_t>(asked_tick) + 1];
  line.command_count = 1;
  line.commands[0] = {simulator::CommandKind::ApplyJob, 0, asked_tick};
}

}  // namespace

SomeOperation some_operation() {
  namespace testing = assessment::testing;
  SomeOperation operation;
  operation.scenario = wide_akin();
  operation.bone = testing::oval_bone();
  Recording& recording = operation.recording;
  recording = testing::akin_recording({.entry_x_mm = 6.6,
                                       .transverse_deg = 3.0,
                                       .sagittal1_deg = 2.0,
                                       .wedge_deg = 12.0,
                                       .sagittal2_deg = -1.0},
                                      operation.bone);
  const assessment::RebuiltBone rebuilt =
      assessment::rebuild(operation.bone, operation.scenario.saw.blade, recording);
  operation.wedge_mm3 = rebuilt.piece_volumes_mm3.back();
  operation.first_cut_done_tick = recording.events[1].tick - 50;
  const std::int64_t sawn_tick = recording.samples.back().tick;
  operation.wedge_out_tick = sawn_tick + 40;
  auto& events = recording.events;
  events.insert(events.begin(),
                {event_at(0, CutEventKind::Started, -1), event_at(5, CutEventKind::StepDone, 0)});
  events.insert(events.begin() + 3,
                event_at(operation.first_cut_done_tick, CutEventKind::StepDone, 1));
  events.push_back(event_at(sawn_tick + 10, CutEventKind::PieceFreed, 1,
                            std::llround(operation.wedge_mm3 * 1000.0)));
  events.push_back(event_at(sawn_tick + 20, CutEventKind::StepDone, 2));
  events.push_back(event_at(operation.wedge_out_tick, CutEventKind::PieceRemoved, 1));
  events.push_back(event_at(operation.wedge_out_tick + 60, CutEventKind::Finished, -1));
  fill_gaps(recording, operation.wedge_out_tick + 60);
  apply_pieces(recording, sawn_tick + 9);
  return operation;
}

database::AttemptId operated_by(database::SomeCourse& course, const std::string& login,
                                const SomeOperation& operation, bool is_scored,
                                std::span<const simulator::DisplayFact> facts) {
  database::Database& database = course.database();
  const scenarios::Scenario& scenario = operation.scenario;
  database::NewAttempt begun = course.attempt_of(login);
  begun.scenario = put_scenario_version(
      database, {scenario.name, scenario.version, scenario.text, scenario.claims_review});
  begun.bone = put_asset(database, "bone", encode_bone(operation.bone));
  database::AttemptId id = record(database, begun, operation.recording, facts);
  if (is_scored) {
    store_score(
        database, id,
        assessment::assess_fully(scenario, operation.bone, operation.recording, "scripted").card,
        course.id_of(login));
  }
  return id;
}

}  // namespace hallux::ui
