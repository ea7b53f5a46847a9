#include "tests/database/big_course.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <sqlite3.h>

#include <array>
#include <string>
#include <vector>

#include "database/course/score_json.h"
#include "database/course/standings.h"
#include "database/desks/session.h"
#include "database/store/sql.h"
#include "simulator/base/random.h"

namespace hallux::database {

namespace {

constexpr std::array<const char*, 6> operations{"akin",  "chevron", "lapidus",
                                                "scarf", "silver",  "weil"};
constexpr const char* quality =
    R"({"complete": true, "valid": true, "expected_samples": 61000, "received_samples": 61000, )"
    R"("gaps": 0, "duplicates": 0, "clock_steps": 0, "missed_ticks": 3, "lateness_p50_us": 41, )"
    R"("lateness_p99_us": 220, "lateness_max_us": 1890, "ring_high_water": 312, )"
    R"("device_faults": 0, "realtime": true})";

/// The same for all: what is asked of many goes by the columns beside it.
std::string card_text(bool is_gated) { return json_from_card(card_of_usual_length(is_gated)); }

void make_people(Database& database, const BigCourse& course, const std::string& password) {
  OpenHouse::enter(database)->add_first_administrator({"root", "Root", true}, secret(password),
                                                      cheap);
  for (const char* login : {"kim", "lee"})
    create_person(database, {login, login, false}, secret(password), cheap);
  const CohortId big = create_cohort(database, "big"), idle = create_cohort(database, "idle");
  enrol(database, big, find_person(database, "kim").id, CohortRole::Instructor);
  enrol(database, idle, find_person(database, "lee").id, CohortRole::Instructor);
  in_transaction(database, "make people", [&] {
    for (int number = 1; number <= course.trainees + 5; ++number) {
      const std::string login = "trainee-" + std::to_string(number);
      const NewPerson person{login, "Trainee " + std::to_string(number), false};
      const PersonId id = number == 1 ? create_person(database, person, secret(password), cheap)
                                      : create_person_without_password(database, person);
      enrol(database, number <= course.trainees ? big : idle, id, CohortRole::Trainee);
    }
  });
}

void publish_operations(Database& database, const std::string& password) {
  AdministratorDesk desk = *sign_in(database, "root", secret(password), cheap).administrator();
  for (const char* name : operations) {
    desk.publish_scenario(
        desk.import_scenario({name, 1, "{\"name\": \"" + std::string(name) + "\"}", false}));
  }
}

/// One attempt with all that hangs on it, as rows.
class Rows {
 public:
  explicit Rows(Database& database)
      : attempt_{database.connection(),
                 "INSERT INTO attempt (uuid, scenario_version_id, person_id, hand, seed, "
                 "device_class, pacing, stereo_mode, bone_digest, engine_version, started_utc, "
                 "state, duration_ticks, quality_json, seal, kind, is_valid) VALUES (?, ?, ?, '', "
                 "0, 'mouse', 'real_time', 'none', ?, 4, strftime('%Y-%m-%dT%H:%M:%fZ', "
                 "'2026-01-05', ? || ' minutes'), 'closed', 61000, ?, zeroblob(32), ?, 1)"},
        score_{database.connection(),
               "INSERT INTO score (attempt_id, scenario_version, rubric_version, engine_version, "
               "score_milli, measured_weight_milli, card_json, stored_utc, rubric_milli, is_gated, "
               "safety_measured_milli, safety_earned_milli) VALUES (?, 1, 2, 4, ?, 100000, ?, '', "
               "100000, ?, 20000, 15000)"},
        decision_{database.connection(),
                  "INSERT INTO decision (attempt_id, kind, score_id, score_milli, reason, "
                  "decided_by_person_id, decided_utc) SELECT attempt_id, 'confirmed', score_id, "
                  "score_milli, 'seen', 2, '' FROM score WHERE attempt_id = ?"},
        question_{database.connection(),
                  "INSERT INTO help_request (attempt_id, asker_person_id, moment_us, question, "
                  "asked_utc, answer, answered_by_person_id, answered_utc) VALUES (?1, ?2, 1, "
                  "'was this too deep?', '2026-01-05', ?3, CASE WHEN ?3 IS NULL THEN NULL ELSE 2 "
                  "END, CASE WHEN ?3 IS NULL THEN NULL ELSE '2026-01-06' END)"},
        audit_{database.connection(),
               "INSERT INTO audit (at_utc, actor_person_id, action, subject_kind, subject_id, "
               "outcome, link) VALUES ('2026-01-05', ?, ?, 'attempt', ?, ?, zeroblob(32))"} {}

  void add(std::int64_t number, PersonId person, const Digest& bone, Random& random) {
    const std::string uuid = std::to_string(100'000'000 + number) + "-big";
    const bool is_assessment = number % 2 == 0;
    attempt_.bind(1, uuid);
    attempt_.bind(2, 1 + static_cast<std::int64_t>(random.uniform(0.0, 5.999)));
    attempt_.bind(3, person.number);
    attempt_.bind(4, bone.bytes.data(), static_cast<int>(bone.bytes.size()));
    attempt_.bind(5, "+" + std::to_string(number));
    attempt_.bind(6, quality);
    attempt_.bind(7, is_assessment ? "assessment" : "practice");
    run(attempt_);
    const auto score_milli = static_cast<std::int64_t>(random.uniform(30'000.0, 99'000.0));
    const bool is_gated = number % 7 == 0;
    score_.bind(1, number);
    score_.bind(2, score_milli);
    score_.bind(3, is_gated ? gated_card_ : card_);
    score_.bind(4, is_gated ? 1 : 0);
    run(score_);
    if (is_assessment && number % 10 != 0) {
      decision_.bind(1, number);
      run(decision_);
    }
    if (number % 10 == 0) ask(number, person);
    for (const char* action : {"attempt_begun", "attempt_sealed", "attempt_viewed"}) {
      audit_.bind(1, person.number);
      audit_.bind(2, action);
      audit_.bind(3, uuid);
      audit_.bind(4, number % 50 == 0 ? "refused" : "done");
      run(audit_);
    }
  }

 private:
  void ask(std::int64_t attempt, PersonId person) {
    question_.bind(1, attempt);
    question_.bind(2, person.number);
    if (attempt % 100 != 0) question_.bind(3, "no");
    run(question_);
  }
  static void run(SQLite::Statement& statement) {
    statement.exec();
    statement.reset();
    statement.clearBindings();
  }

  SQLite::Statement attempt_, score_, decision_, question_, audit_;
  const std::string card_ = card_text(false), gated_card_ = card_text(true);
};

}  // namespace

ScoreCard card_of_usual_length(bool is_gated) {
  ScoreCard card;
  card.score_milli = card.earned_milli = 60'000;
  card.measured_milli = card.rubric_milli = 100'000;
  for (const char* name : {"accuracy", "safety", "tool use", "procedure", "efficiency"})
    card.groups.push_back({name, 20'000, 20'000, 15'000});
  for (const char* name : {"joint", "critical", "plunge", "hinge"})
    card.gates.push_back({name, 59'000, is_gated, 1.25, 2.0, "mm", std::string(90, 'g')});
  for (int line = 0; line < 20; ++line) {
    LedgerLine& made = card.ledger.emplace_back();
    made.item = "A" + std::to_string(line);
    made.metric = "angle_deg";
    made.group = "accuracy";
    made.unit = "deg";
    made.text = std::string(120, 't');
  }
  card.shown_losses_milli.assign(20, 1000);
  card.sentences.assign(3, std::string(140, 's'));
  card.scenario = "akin";
  card.rubric_version = 2;
  return card;
}

void make_big_course(Database& database, const BigCourse& course, const std::string& password) {
  make_people(database, course, password);
  publish_operations(database, password);
  const Digest bone = some_attempt(database).bone;
  const std::vector<CohortMember> members = list_members(database, {1});
  Random random{7};
  // Each trigger would count a person's hundred attempts anew for each of them.
  sqlite3_db_config(database.connection().getHandle(), SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  in_transaction(database, "make attempts", [&] {
    Rows rows{database};
    std::int64_t number = 0;
    for (std::int32_t round = 0; round < course.attempts_each; ++round) {
      for (const CohortMember& member : members) {
        if (member.role == CohortRole::Trainee) rows.add(++number, member.id, bone, random);
      }
    }
    recount_standings(database);
  });
  sqlite3_db_config(database.connection().getHandle(), SQLITE_DBCONFIG_ENABLE_TRIGGER, 1, nullptr);
}

}  // namespace hallux::database
