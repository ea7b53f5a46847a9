/// Ids of stored rows, as distinct types, so that one is never taken for another.
#pragma once

#include <cstdint>
#include <string>

namespace hallux::database {

/// A random UUID (version 4) in lower-case hexadecimal with dashes.
struct AttemptId {
  std::string text;
  friend auto operator<=>(const AttemptId&, const AttemptId&) = default;  // NOLINT: no null
};

struct PersonId {
  std::int64_t number = 0;
  friend auto operator<=>(const PersonId&, const PersonId&) = default;
};

struct CohortId {
  std::int64_t number = 0;
  friend auto operator<=>(const CohortId&, const CohortId&) = default;
};

struct ScenarioVersionId {
  std::int64_t number = 0;
  friend auto operator<=>(const ScenarioVersionId&, const ScenarioVersionId&) = default;
};

struct ScoreId {
  std::int64_t number = 0;
  friend auto operator<=>(const ScoreId&, const ScoreId&) = default;
};

struct NoteId {
  std::int64_t number = 0;
  friend auto operator<=>(const NoteId&, const NoteId&) = default;
};

struct HelpRequestId {
  std::int64_t number = 0;
  friend auto operator<=>(const HelpRequestId&, const HelpRequestId&) = default;  // NOLINT: no null
};

/// The identity of a data directory: 32 hexadecimal digits, made with it.
struct DirectoryId {
  std::string text;
  friend auto operator<=>(const DirectoryId&, const DirectoryId&) = default;
};

struct DecisionId {
  std::int64_t number = 0;
  friend auto operator<=>(const DecisionId&, const DecisionId&) = default;
};

struct NoticeId {
  std::int64_t number = 0;
  friend auto operator<=>(const NoticeId&, const NoticeId&) = default;  // NOLINT: no null
};

}  // namespace hallux::database
