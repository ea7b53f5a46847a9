#include "tests/database/some_database.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include <cmath>
#include <span>
#include <thread>

#include "database/content/assets.h"
#include "database/course/begin_attempt.h"
#include "database/recording/recordings.h"
#include "database/store/sql.h"
#include "simulator/base/random.h"

namespace hallux::database {

SecretText secret(std::string text) { return SecretText::take(text); }

NewAttempt some_attempt(Database& database) {
  const std::string bone = "a bone of no shape, but with bytes of its own";
  NewAttempt attempt;
  attempt.scenario = put_scenario_version(database, {"silver", 1, "{\"name\": \"silver\"}", false});
  attempt.bone = put_asset(database, "bone", std::as_bytes(std::span{bone.data(), bone.size()}));
  attempt.hand = "expert";
  attempt.seed = 7;
  return attempt;
}

simulator::Recording some_recording(std::int64_t ticks) {
  simulator::Recording recording;
  Random random{42};
  Vec3 tip_mm{80.0, 20.0, -3.0};
  for (std::int64_t tick = 0; tick < ticks; ++tick) {
    tip_mm += Vec3{0.02 * random.normal(), 0.003 + 0.02 * random.normal(), 0.02 * random.normal()};
    const Quat rotation = normalised(Quat{1.0, 0.001 * random.normal(), 0.2, 0.1});
    simulator::TapeLine line;
    line.tick = tick;
    line.device.world_from_handle = simulator::quantise({rotation, tip_mm});
    line.device.switches = tick % 2000 < 1500 ? 1 : 0;
    if (tick == 0) {
      line.command_count = 1;
      line.commands[0] = {simulator::CommandKind::Start, 0, 0};
    }
    recording.tape.push_back(line);
    simulator::ToolSample sample;
    sample.tick = tick;
    sample.world_from_tool = line.device.world_from_handle;
    sample.force_mn = {static_cast<std::int32_t>(random.uniform(-40.0, 40.0)), 2500, 0};
    sample.status = line.device.switches * 3;
    sample.kerf = tick > 1000 ? 0 : -1;
    recording.samples.push_back(sample);
    if (tick % 250 == 100) {
      recording.events.push_back(
          {tick, simulator::CutEventKind::Contact, 1, tick * 3, sample.world_from_tool});
    }
  }
  return recording;
}

std::vector<simulator::DisplayFact> some_display_facts(std::int64_t ticks) {
  std::vector<simulator::DisplayFact> facts;
  for (std::int64_t tick = 0; tick < ticks; tick += 100) {
    simulator::DisplayFact fact;
    fact.tick = tick;
    fact.target_in_world_um = {80'000 + tick, 20'000, -3'000};
    const double half_rad = 0.001 * static_cast<double>(tick);
    const Quat turn = normalised(Quat{1.0, 0.0, half_rad, 0.0});
    fact.world_from_view_micro = {std::llround(turn.w * 1.0e6), 0, std::llround(turn.y * 1.0e6), 0};
    fact.magnification_milli = 8'000 + tick;
    facts.push_back(fact);
  }
  return facts;
}

std::vector<Measurement> some_measurements() {
  Measurement angle;
  angle.metric = "angle_deg";
  angle.cut = "proximal_face";
  angle.value = 3.141593;
  angle.done_fraction = 0.75;
  angle.bound = 0.01;
  angle.direction = "dorsal";
  angle.detail = {DetailKind::EdgesOff, {0.5, 1.0 / 3.0}, {"proximal", "distal"}};
  angle.remark = Remark::SawnAfterDone;
  angle.start_us = 1'000;
  angle.end_us = 9'000'000;
  angle.place_in_bone_mm = {0.1, -7.25, 1.0e-6};
  Measurement wedge;
  wedge.metric = "wedge_error_deg";
  wedge.hinge = "lateral_hinge";
  wedge.absence = Absence::NotMade;
  Measurement contacts;
  contacts.metric = "danger_contacts_count";
  contacts.zone = "nerve";
  contacts.detail = {DetailKind::Zones, {}, {"a nerve, \"dorsal\""}};
  return {angle, wedge, contacts};
}

void produce(const simulator::Recording& recording, simulator::AttemptChannels& channels,
             std::span<const simulator::DisplayFact> facts) {
  const auto push = [&channels](auto& ring, const auto& row) {
    while (!ring.push(row) && !channels.recorder_failed.load()) std::this_thread::yield();
  };
  std::size_t next_event = 0;
  for (std::size_t i = 0; i < recording.tape.size(); ++i) {
    for (; !facts.empty() && facts.front().tick <= recording.tape[i].tick; facts = facts.subspan(1))
      push(channels.display_facts, facts.front());
    push(channels.tape, recording.tape[i]);
    push(channels.samples, recording.samples[i]);
    for (; next_event < recording.events.size() &&
           recording.events[next_event].tick == recording.tape[i].tick;
         ++next_event) {
      push(channels.events, recording.events[next_event]);
    }
  }
  channels.closed.store(true);
}

AttemptId record(Database& database, const NewAttempt& attempt,
                 const simulator::Recording& recording,
                 std::span<const simulator::DisplayFact> facts) {
  simulator::AttemptChannels channels{4096};
  Recorder recorder{database, create_attempt(database, attempt), channels};
  produce(recording, channels, facts);
  recorder.finish(R"({"complete": true})");
  return recorder.attempt();
}

std::int64_t check_recording(Database& database, const AttemptId& id) {
  return RecordingCheck{database}.check(load_header(database, id));
}

std::vector<KeptScore> kept_scores(Database& database, const AttemptId& id) {
  return rows_of(prepared(database,
                          "SELECT score_milli, superseded_by IS NULL FROM score JOIN attempt USING "
                          "(attempt_id) WHERE uuid = ? ORDER BY score_id DESC",
                          id),
                 &KeptScore::score_milli, &KeptScore::is_in_force);
}

void tamper(const Database& database, const std::string& sql) {
  SQLite::Database other{database.file().string(), SQLite::OPEN_READWRITE, 1000};
  other.exec(sql);
}

bool is_same(const simulator::Recording& a, const simulator::Recording& b) {
  return a.engine == b.engine && a.tape == b.tape && a.samples == b.samples && a.events == b.events;
}

}  // namespace hallux::database
