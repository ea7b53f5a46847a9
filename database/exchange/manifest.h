/// Manifest of an exported attempt: facts, scenario, scores, and the digests of the files beside
/// it. Inside this corner only.
///
/// Names of people and what they wrote are never in it: a person is a number of the directory it
/// was made in. The schema is docs/schemas/attempt_manifest.schema.json.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "database/content/assets.h"
#include "database/exchange/exchange_file.h"
#include "database/records/attempt.h"
#include "database/records/decision.h"

namespace hallux::database {

inline constexpr const char* manifest_name = "manifest.json";
inline constexpr const char* bone_name = "bone.bin";
inline constexpr const char* score_table_name = "score.csv";
/// 2: with an act of the audit; 3: score cards keep facts in place of words. A reader takes 1 and 2
/// as well.
inline constexpr std::int32_t manifest_format = 3;
/// Scenario and score cards together: what a reader takes memory for.
inline constexpr std::int64_t manifest_bytes_max = std::int64_t{32} << 20U;

struct ExportedScore {
  std::string stored_utc;
  bool is_in_force = false;
  std::string card_json;
};

struct ExportedDecision {
  DecisionKind kind = DecisionKind::Voided;
  /// Which of the scores.
  std::optional<std::size_t> about;
  std::optional<std::int64_t> score_milli;
  PersonId decided_by;
  std::string decided_utc;
};

/// What binds person and decisions, which stay outside the seal, to the audit of where the attempt
/// was made: the newest act that left its row, by number and link, and a digest of all of them.
struct ExportedAct {
  std::int64_t number = 0;
  Digest link, facts;
};

struct Manifest {
  /// Where it was made.
  DirectoryId directory;
  /// The facts that are sealed, state and person as they are there. Not filled: order, login,
  /// score, decision, origin.
  AttemptHeader header;
  ScenarioText scenario;
  /// Of the chain of chunks; zeros where there is none.
  Digest last_link;
  /// Oldest first.
  std::vector<ExportedScore> scores;
  /// Oldest first; the last one is in force.
  std::vector<ExportedDecision> decisions;
  /// Nothing in format 1.
  std::optional<ExportedAct> act;
  /// Beside it, by name.
  std::vector<ExchangeFile> files;
};

}  // namespace hallux::database
