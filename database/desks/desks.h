/// Desks, one for each role: the only door to the data of people.
///
/// A desk offers only what its role may ever do; whether this person may do it to that row is
/// decided by the policy table (database/desks/policy.h), which each method asks first. A refusal
/// is written to the audit and thrown. A desk is had from a Session, or from the house for what
/// belongs to nobody (database/desks/session.h); it must not outlive the Database. Here is what
/// desks share; the desks of people are in trainee_desk.h, instructor_desk.h and
/// administrator_desk.h.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "database/course/decisions.h"
#include "database/course/help_requests.h"
#include "database/course/notes.h"
#include "database/course/scores.h"
#include "database/desks/policy.h"
#include "database/exchange/derived_files.h"
#include "database/people/cohorts.h"
#include "database/people/notices.h"
#include "database/people/password_proof.h"
#include "database/people/people.h"
#include "database/recording/attempts.h"
#include "database/recording/recordings.h"
#include "database/store/writer_lease.h"
#include "simulator/record/display_fact.h"
#include "simulator/record/record.h"

namespace hallux::database {

class Session;

/// Who sits at a desk.
struct DeskHolder {
  Role role = Role::House;
  /// Nothing at the house's desk.
  std::optional<PersonId> person;
  /// The instructor's.
  std::optional<CohortId> cohort;
};

/// Reading attempts: the same for every role, with other rows. An attempt that this desk may not
/// view and one that does not exist are refused alike.
class AttemptDesk {
 public:
  /// The attempts that the table lets this desk list, newest first; all, or so many.
  std::vector<AttemptHeader> attempts(std::optional<std::int32_t> count_max = std::nullopt);
  /// errors  DatabaseError: NotFound where `id` begins none or more than one that may be viewed;
  ///         Refused; of the other methods as well
  AttemptHeader header(const AttemptId& id);
  simulator::Recording recording(const AttemptId& id, RecordingPart part = RecordingPart::Whole);
  PackedRecording packed_recording(const AttemptId& id);
  /// What was on the screen, by tick (simulator::is_view says whether it is a view); none of an
  /// older attempt, and of one without a window.
  std::vector<simulator::DisplayFact> display_facts(const AttemptId& id);
  std::optional<StoredScore> score(const AttemptId& id);
  /// What instructors decided about it, newest first.
  std::vector<Decision> decisions(const AttemptId& id);
  /// Whether the table allows `action` on that attempt; asking is no refusal and is not written to
  /// the audit.
  bool may(Action action, const AttemptHeader& header);
  ScoreId store_score(const AttemptId& id, const ScoreCard& card);
  /// All of them or none.
  void store_scores(std::span<const NewScore> scores);
  /// What was measured of its recording before; nothing where it is to be measured again.
  std::optional<std::vector<Measurement>> measurements(const AttemptId& id, const MeasuredBy& by);
  /// Keeps what the recording measured, for later scores.
  void store_measurements(const AttemptId& id, const MeasuredBy& by,
                          std::span<const Measurement> measurements);
  /// Writes it as files into a folder of its own within `folder`.
  void export_attempt(const AttemptId& id, const std::filesystem::path& folder,
                      const MakeDerived& make_derived);

 protected:
  friend class Session;
  AttemptDesk(Database& database, DeskHolder holder) : database_(&database), holder_(holder) {}
  WriterLease begin(const NewAttempt& attempt);
  /// What this desk's holder is to an attempt of `owner`.
  Relation relation_to(const std::optional<PersonId>& owner);
  /// The attempt that `id` names or begins, of those this desk may view or do `action` to: others
  /// are as if they were not there.
  /// errors  DatabaseError NotFound where it begins more than one of them
  std::optional<AttemptHeader> seen_header(const AttemptId& id, Action action);
  /// The header, once the table allowed `action` on it.
  /// errors  DatabaseError: NotFound, in the same words where it may not be viewed; Refused
  AttemptHeader allowed_header(Action action, const AttemptId& id);
  /// Refuses what is not there and what may not be seen in the same words and with the same work;
  /// the audit knows which.
  [[noreturn]] void refuse_unseen(Action action, const std::string& subject, bool is_there);
  /// Writes to the audit that the holder saw the attempt of another person, once in a minute.
  void note_view(const AttemptHeader& header);
  /// An audit row of something done by the holder.
  void audit(const std::string& action, const char* subject_kind, std::string subject_id);

  Database* database_;
  DeskHolder holder_;
};

/// Nobody's desk: the robot's attempts, for scripts and for a data directory without people.
class HouseDesk : public AttemptDesk {
 public:
  explicit HouseDesk(Database& database) : AttemptDesk(database, {}) {}
  /// errors  DatabaseError Refused where the attempt names a person
  WriterLease begin_attempt(const NewAttempt& attempt) { return begin(attempt); }
};

/// What trainees and instructors share: talking about an attempt.
class CourseDesk : public AttemptDesk {
 public:
  /// By moment, with their replies; private ones for those whom the table lets read them.
  std::vector<Note> notes(const AttemptId& id);
  /// Questions about that attempt, with their answers: open first, then the answered, newest first.
  std::vector<HelpRequest> help_requests_about(const AttemptId& id);
  /// errors  DatabaseError: NotFound, alike for a note that this desk may not read and for none;
  ///         BadInput for the text
  void reply(NoteId note, const std::string& text);

 protected:
  using AttemptDesk::AttemptDesk;
  void check_may_reply(NoteId note);
};

/// Whether the proof is the holder's own.
/// errors  DatabaseError Refused
void require_proof(const DeskHolder& holder, const PasswordProof& proof);

/// Asks the policy table, and whether the holder still has the role; writes a refusal to the audit.
/// errors  DatabaseError Refused
void require(Database& database, const DeskHolder& holder, Action action, Relation relation,
             const std::string& subject);

}  // namespace hallux::database
