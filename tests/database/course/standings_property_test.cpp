/// How people stand is kept by triggers; here random courses are played, and counted once more by
/// hand.
#include "database/course/standings.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

#include "tests/database/some_database.h"

namespace hallux::database {

namespace {

/// One attempt as the test remembers it.
struct Remembered {
  std::int64_t attempt = 0, person = 0, started_s = 0;
  std::string scenario, device;
  bool is_assessment = false, is_void = false, is_invalid = false, is_refused_origin = false;
  std::optional<std::int64_t> machine_milli, decided_milli;

  bool counts() const { return !is_void && !is_invalid && !is_refused_origin; }
  std::optional<std::int64_t> milli() const {
    return decided_milli ? decided_milli : machine_milli;
  }
  /// Of two on different devices that were begun in one moment, by the name of the device class.
  bool is_before(const Remembered& other) const {
    return std::tie(started_s, device, attempt) <
           std::tie(other.started_s, other.device, other.attempt);
  }
};

std::string utc_of(std::int64_t second) {
  std::string digits = std::to_string(100 + second);
  return "2026-01-01T00:00:" + digits.substr(1) + ".000Z";
}

/// Plays what happens to attempts with raw rows: what the functions of the room may do and more.
class PlayedCourse {
 public:
  PlayedCourse() : database_(Database::open(temporary_.data())) {
    bone_ = some_attempt(database_).bone;
    tamper(
        database_,
        "INSERT INTO person VALUES (1, 0, 0, 'then'), (2, 0, 0, 'then'), (3, 0, 0, 'then');"
        "INSERT INTO scenario_version (scenario_version_id, name, version, json, digest, "
        "is_reviewed, stored_utc) VALUES (11, 'akin', 1, '{}', randomblob(32), 0, ''), "
        "(12, 'akin', 2, '{}', randomblob(32), 0, ''), (13, 'tip', 1, '{}', randomblob(32), 0, '');"
        "INSERT INTO origin VALUES (1, '0123456789abcdef0123456789abcdef', 0, 'then');");
  }

  Database& database() { return database_; }
  void exec(const std::string& sql) { database_.connection().exec(sql); }

  void start_anew() {
    exec("BEGIN");
    next_attempt_ = 1;
    is_accepted_ = false;
    attempts_.clear();
  }

  void begin(int draw) {
    Remembered made;
    made.attempt = next_attempt_++;
    made.person = 1 + draw % 3;
    const int version = draw / 3 % 3;
    made.scenario = version == 2 ? "tip" : "akin";
    made.device = draw / 9 % 2 == 0 ? "mouse" : "arm";
    made.is_assessment = draw / 18 % 2 == 0;
    made.started_s = draw / 36 % 60;
    const bool is_imported = draw / 2160 % 4 == 0;
    made.is_refused_origin = is_imported && !is_accepted_;
    SQLite::Statement insert{
        database_.connection(),
        "INSERT INTO attempt (attempt_id, uuid, scenario_version_id, person_id, hand, seed, "
        "device_class, pacing, stereo_mode, bone_digest, engine_version, started_utc, state, kind, "
        "origin_id) VALUES (?, ?, ?, ?, '', 0, ?, '', '', ?, 1, ?, 'interrupted', ?, ?)"};
    insert.bind(1, made.attempt);
    insert.bind(2, "uuid" + std::to_string(made.attempt));
    insert.bind(3, 11 + version);
    insert.bind(4, made.person);
    insert.bind(5, made.device);
    insert.bind(6, bone_.bytes.data(), static_cast<int>(bone_.bytes.size()));
    insert.bind(7, utc_of(made.started_s));
    insert.bind(8, made.is_assessment ? "assessment" : "practice");
    if (is_imported) insert.bind(9, 1);
    insert.exec();
    attempts_.push_back(made);
  }

  void happen(int what, int draw) {
    if (attempts_.empty()) return begin(draw);
    Remembered& attempt = attempts_[static_cast<std::size_t>(draw) % attempts_.size()];
    const std::string id = std::to_string(attempt.attempt);
    const std::string where = " WHERE attempt_id = " + id;
    switch (what) {
      case 0:
        attempt.is_invalid = draw % 2 == 0;
        return exec("UPDATE attempt SET is_valid = " + std::string(draw % 2 == 0 ? "0" : "1") +
                    where);
      case 1:
        return score(attempt, draw % 100'001);
      case 2:
        return decide(attempt, draw % 100'001);
      case 3:
        attempt.is_void = !attempt.is_void;
        return exec("UPDATE attempt SET state = " +
                    std::string(attempt.is_void ? "'void'" : "'interrupted'") + where);
      case 4:
        is_accepted_ = true;
        for (Remembered& each : attempts_) each.is_refused_origin = false;
        return exec("UPDATE origin SET is_accepted = 1");
      case 5:
        attempt.person = 1 + draw % 3;
        return exec("UPDATE attempt SET person_id = " + std::to_string(attempt.person) + where);
      default:
        return begin(draw);
    }
  }

  std::vector<OperationStanding> counted(std::int64_t person) const {
    std::map<std::string, OperationStanding> operations;
    std::vector<Remembered> in_order = attempts_;
    std::sort(in_order.begin(), in_order.end(),
              [](const Remembered& a, const Remembered& b) { return a.is_before(b); });
    for (const Remembered& attempt : in_order) {
      if (attempt.person != person) continue;
      OperationStanding& standing = operations[attempt.scenario];
      standing.scenario_name = attempt.scenario;
      ++standing.attempts;
      standing.last_started_utc = utc_of(attempt.started_s);
      if (attempt.counts() && attempt.is_assessment) ++standing.assessments;
      if (!attempt.counts() || !attempt.milli()) continue;
      standing.best_milli = std::max(standing.best_milli.value_or(-1), *attempt.milli());
      standing.last_milli = attempt.milli();
    }
    std::vector<OperationStanding> list;
    list.reserve(operations.size());
    for (auto& [name, standing] : operations) list.push_back(std::move(standing));
    return list;
  }

  /// Points of the scored assessments that count, oldest first.
  std::vector<std::int64_t> runs(const OperationStanding& standing, std::int64_t person,
                                 const std::string& device) const {
    std::vector<Remembered> in_order;
    for (const Remembered& attempt : attempts_) {
      if (attempt.person == person && attempt.scenario == standing.scenario_name &&
          attempt.device == device && attempt.is_assessment && attempt.counts() &&
          attempt.machine_milli)
        in_order.push_back(attempt);
    }
    std::sort(in_order.begin(), in_order.end(),
              [](const Remembered& a, const Remembered& b) { return a.is_before(b); });
    std::vector<std::int64_t> points;
    points.reserve(in_order.size());
    for (const Remembered& attempt : in_order) points.push_back(*attempt.milli());
    return points;
  }

 private:
  void score(Remembered& attempt, std::int64_t milli) {
    const std::string id = std::to_string(attempt.attempt);
    exec("UPDATE score SET superseded_by = score_id WHERE superseded_by IS NULL AND attempt_id = " +
         id);
    exec(
        "INSERT INTO score (attempt_id, scenario_version, rubric_version, engine_version, "
        "score_milli, measured_weight_milli, card_json, stored_utc, rubric_milli, is_gated, "
        "safety_measured_milli, safety_earned_milli) VALUES (" +
        id + ", 1, 1, 1, " + std::to_string(milli) +
        ", 100000, '{\"rubric_milli\": 100000, \"gates\": [], \"groups\": []}', '', 100000, 0, 0, "
        "0)");
    attempt.machine_milli = milli;
  }

  void decide(Remembered& attempt, std::int64_t milli) {
    if (!attempt.machine_milli) return;
    const std::string id = std::to_string(attempt.attempt);
    exec(
        "UPDATE decision SET superseded_by = decision_id WHERE superseded_by IS NULL AND "
        "attempt_id = " +
        id);
    exec(
        "INSERT INTO decision (attempt_id, kind, score_id, score_milli, reason, "
        "decided_by_person_id, decided_utc) SELECT attempt_id, 'overridden', score_id, " +
        std::to_string(milli) + ", 'so', 1, '' FROM score WHERE superseded_by IS NULL AND " +
        "attempt_id = " + id);
    attempt.decided_milli = milli;
  }

  TemporaryDirectory temporary_;
  Database database_;
  Digest bone_;
  std::int64_t next_attempt_ = 1;
  bool is_accepted_ = false;
  std::vector<Remembered> attempts_;
};

void check_person(PlayedCourse& course, std::int64_t person) {
  const auto kept = operation_standings(course.database(), {person});
  const auto counted = course.counted(person);
  RC_ASSERT(kept.size() == counted.size());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    RC_ASSERT(kept[i].scenario_name == counted[i].scenario_name);
    RC_ASSERT(kept[i].attempts == counted[i].attempts);
    RC_ASSERT(kept[i].assessments == counted[i].assessments);
    RC_ASSERT(kept[i].best_milli == counted[i].best_milli);
    RC_ASSERT(kept[i].last_milli == counted[i].last_milli);
    RC_ASSERT(kept[i].last_started_utc == counted[i].last_started_utc);
    std::map<std::string, std::vector<std::int64_t>> points;
    for (const DeviceRuns& device : kept[i].by_device)
      for (const AssessedRun& run : device.runs)
        points[device.device_class].push_back(run.standing_milli);
    for (const char* device : {"mouse", "arm"})
      RC_ASSERT(points[device] == course.runs(kept[i], person, device));
  }
}

TEST(RandomCourses, StandAsIsCountedByHandAfterWhateverHappened) {
  PlayedCourse course;
  EXPECT_TRUE(rc::check([&course] {
    course.start_anew();
    try {
      const auto steps = *rc::gen::inRange(1, 40);
      for (int step = 0; step < steps; ++step)
        course.happen(*rc::gen::inRange(0, 10), *rc::gen::inRange(0, 1 << 20));
      for (std::int64_t person = 1; person <= 3; ++person) check_person(course, person);
      check_standings(course.database());
    } catch (...) {
      course.exec("ROLLBACK");
      throw;
    }
    course.exec("ROLLBACK");
  }));
}

}  // namespace

}  // namespace hallux::database
