/// Notes, questions and answers about a moment of an attempt.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "database/records/ids.h"

namespace hallux::database {

/// A point on a body: 0 is any of the patient's bones, then the pieces by number. In the frame of
/// the first bone, or of the one that the piece came of, before anything moved.
struct BonePoint {
  std::int32_t body = 0;
  std::array<double, 3> point_in_bone_mm{};
  friend bool operator==(const BonePoint&, const BonePoint&) = default;
};

/// When in an attempt, and perhaps where.
struct AttemptMoment {
  /// Simulated, from the attempt's first tick.
  std::int64_t moment_us = 0;
  std::optional<BonePoint> place = std::nullopt;
};

struct NewNote {
  AttemptId attempt;
  AttemptMoment moment;
  /// For the instructors of the cohort only.
  bool is_private = false;
  std::string text;
};

struct NoteReply {
  PersonId author;
  /// As shown; "" for erased people.
  std::string author_name;
  std::string text;
  std::string written_utc;
};

struct Note {
  NoteId id;
  AttemptId attempt;
  AttemptMoment moment;
  PersonId author;
  std::string author_name;
  bool is_private = false;
  std::string text;
  std::string written_utc;
  /// Oldest first.
  std::vector<NoteReply> replies;
};

struct NewHelpRequest {
  AttemptId attempt;
  AttemptMoment moment;
  std::string question;
};

struct HelpAnswer {
  std::string by_name;
  std::string text;
  std::string answered_utc;
};

struct HelpRequest {
  HelpRequestId id;
  AttemptId attempt;
  std::string scenario_name;
  /// Of the attempt, as in AttemptHeader.
  std::int64_t attempt_number = 0;
  AttemptMoment moment;
  PersonId asker;
  std::string asker_name;
  std::string question;
  std::string asked_utc;
  /// Nothing: open.
  std::optional<HelpAnswer> answer;
};

}  // namespace hallux::database
