/// Worlds for the tests of this room: an empty data directory, stored bones, recordings of a hand
/// that moves.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "database/people/passwords.h"
#include "database/recording/attempts.h"
#include "database/recording/recorder.h"
#include "database/records/measurement.h"
#include "database/store/connection.h"
#include "simulator/record/channels.h"
#include "tests/support/temporary_directory.h"

namespace hallux::database {

using tests::Medium;
using tests::TemporaryDirectory;

/// The cheapest Argon2id there is: for tests that are not about its cost.
inline constexpr PasswordCost cheap{1, 8192};

SecretText secret(std::string text);

/// A robot's attempt on a stored bone and a stored scenario.
NewAttempt some_attempt(Database& database);

/// `ticks` milliseconds of a hand that trembles and saws, with an event each quarter of a second.
simulator::Recording some_recording(std::int64_t ticks);

/// A view that is turned for so long, noted ten times a second.
std::vector<simulator::DisplayFact> some_display_facts(std::int64_t ticks);

/// One with a value, one without, one of a zone with all that a row can say.
std::vector<Measurement> some_measurements();

/// Pushes a recording as the loop does, and with it what was on the screen: tick by tick, waiting
/// for room; sets `closed` at the end.
void produce(const simulator::Recording& recording, simulator::AttemptChannels& channels,
             std::span<const simulator::DisplayFact> facts = {});

/// Records and seals `recording` as a new attempt.
AttemptId record(Database& database, const NewAttempt& attempt,
                 const simulator::Recording& recording,
                 std::span<const simulator::DisplayFact> facts = {});

/// What the store's cards of an attempt say, newest first, and whether they are in force.
struct KeptScore {
  std::int64_t score_milli = 0;
  bool is_in_force = false;
};
std::vector<KeptScore> kept_scores(Database& database, const AttemptId& id);

/// The number of its chunks; throws as RecordingCheck does.
std::int64_t check_recording(Database& database, const AttemptId& id);

/// Runs SQL as somebody with another tool would.
void tamper(const Database& database, const std::string& sql);

bool is_same(const simulator::Recording& a, const simulator::Recording& b);

}  // namespace hallux::database
