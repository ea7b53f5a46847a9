#include "database/course/begin_attempt.h"

#include <sodium.h>

#include <array>

#include "database/audit/audit.h"
#include "database/course/limits.h"
#include "database/course/simulated_course.h"
#include "database/recording/chain.h"
#include "database/store/sql.h"

namespace hallux::database {

namespace {

AttemptId random_attempt_id() {
  std::array<unsigned char, 16> bytes{};
  randombytes_buf(bytes.data(), bytes.size());
  bytes[6] = static_cast<unsigned char>((bytes[6] & 0x0FU) | 0x40U);
  bytes[8] = static_cast<unsigned char>((bytes[8] & 0x3FU) | 0x80U);
  constexpr std::string_view digits = "0123456789abcdef";
  AttemptId id;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (i == 4 || i == 6 || i == 8 || i == 10) id.text.push_back('-');
    id.text.push_back(digits[bytes[i] >> 4U]);
    id.text.push_back(digits[bytes[i] & 15U]);
  }
  return id;
}

void insert_attempt(Database& database, const AttemptId& id, const NewAttempt& attempt) {
  execute(database,
          "INSERT INTO attempt (uuid, scenario_version_id, person_id, hand, seed, "
          "device_class, pacing, "
          "stereo_mode, bone_digest, engine_version, started_utc, kind, "
          "guidance, is_simulated, state) "
          "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
          "EXISTS (SELECT 1 FROM simulated_course), 'recording')",
          id.text, attempt.scenario.number, attempt.person, attempt.hand,
          static_cast<std::int64_t>(attempt.seed), attempt.device_class, attempt.pacing,
          attempt.stereo_mode, attempt.bone, attempt.engine, utc_now(database),
          name_of(attempt.kind), name_of(attempt.guidance));
}

/// A person's attempt is made by that person's own hand; only in a simulated course is it a
/// scripted one's.
void check_whose_hand(Database& database, const NewAttempt& attempt) {
  if (!attempt.person || attempt.hand.empty() || is_simulated_course(database)) return;
  throw DatabaseError{DatabaseErrorKind::BadInput,
                      "the scripted hand '" + attempt.hand +
                          "' belongs to the robot; a person's attempt is made by their own hand"};
}

void check_nothing_helps(const NewAttempt& attempt) {
  if (attempt.kind == AttemptKind::Practice || attempt.guidance == simulator::Guidance::None)
    return;
  throw DatabaseError{DatabaseErrorKind::BadInput,
                      "an assessment is not guided; choose practice, or no guide"};
}

}  // namespace

WriterLease create_attempt(Database& database, const NewAttempt& attempt) {
  check_whose_hand(database, attempt);
  check_nothing_helps(attempt);
  // The lease comes first: a row without one would be taken for an interrupted attempt.
  WriterLease lease = WriterLease::take(database.directory(), random_attempt_id());
  in_transaction(database, "begin an attempt (its scenario version and bone must be stored)", [&] {
    check_allowance(database, attempt);
    insert_attempt(database, lease.attempt(), attempt);
    append_audit(
        database,
        {attempt.person, "attempt_begun", "attempt", lease.attempt().text, false,
         purpose_digest(attempt.kind, is_simulated_course(database), attempt.guidance), ""});
  });
  return lease;
}

}  // namespace hallux::database
