/// From which desk a person does something with one attempt: their own, or that of a cohort they
/// teach.
#pragma once

#include <optional>
#include <vector>

#include "database/desks/session.h"

namespace hallux::ui {

/// The desk of a cohort that the person teaches from which the table allows `action` on that
/// attempt; nothing where none does.
/// thread  work's
std::optional<database::InstructorDesk> instructor_desk_for(database::Session& session,
                                                            database::Action action,
                                                            const database::AttemptHeader& header);
/// The person's own desk, where the table allows it from there.
std::optional<database::TraineeDesk> trainee_desk_for(database::Session& session,
                                                      database::Action action,
                                                      const database::AttemptHeader& header);

/// The attempt's facts, if the person may see them.
/// errors  DatabaseError: NotFound; Refused, which is written to the audit
database::AttemptHeader header_for(database::Session& session, const database::AttemptId& id);

/// What a person may do with an attempt, so that a screen offers it.
struct AttemptRights {
  bool may_decide = false, may_write_notes = false, may_reply = false, may_read_notes = false,
       may_ask_for_help = false;
};
AttemptRights rights_to(database::Session& session, const database::AttemptHeader& header);

/// Notes and questions about an attempt that the person may read, from whichever desk may; none
/// where none may.
std::vector<database::Note> notes_about(database::Session& session,
                                        const database::AttemptHeader& header);
std::vector<database::HelpRequest> questions_about(database::Session& session,
                                                   const database::AttemptHeader& header);

/// Answers a note from whichever desk may.
/// errors  DatabaseError: Refused; as CourseDesk::reply
void reply_to_note(database::Session& session, const database::AttemptHeader& header,
                   database::NoteId note, const std::string& text);
/// errors  DatabaseError: Refused; as TraineeDesk::ask_for_help
void ask_for_help(database::Session& session, const database::AttemptHeader& header,
                  const database::NewHelpRequest& request);

}  // namespace hallux::ui
