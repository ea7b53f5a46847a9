#include "ui/screens/parts/attempt_desks.h"

#include "ui/screens/parts/desk_work.h"

namespace hallux::ui {

using database::Action;
using database::AttemptHeader;
using database::Session;

std::optional<database::InstructorDesk> instructor_desk_for(Session& session, Action action,
                                                            const AttemptHeader& header) {
  for (const database::Membership& membership : session.memberships()) {
    if (membership.role != database::CohortRole::Instructor) continue;
    std::optional<database::InstructorDesk> desk = session.instructor_of(membership.cohort);
    if (desk && desk->may(action, header)) return desk;
  }
  return std::nullopt;
}

std::optional<database::TraineeDesk> trainee_desk_for(Session& session, Action action,
                                                      const AttemptHeader& header) {
  std::optional<database::TraineeDesk> desk = session.trainee();
  if (desk && !desk->may(action, header)) desk.reset();
  return desk;
}

AttemptHeader header_for(Session& session, const database::AttemptId& id) {
  return desk_or_refused(session.desk_for(Action::ViewAttempt, id),
                         "this account may not see attempts any more; ask the administrator")
      .header(id);
}

AttemptRights rights_to(Session& session, const AttemptHeader& header) {
  const auto as_instructor = [&](Action action) {
    return instructor_desk_for(session, action, header).has_value();
  };
  const auto as_trainee = [&](Action action) {
    return trainee_desk_for(session, action, header).has_value();
  };
  AttemptRights rights;
  rights.may_decide = as_instructor(Action::DecideResult);
  rights.may_write_notes = as_instructor(Action::WriteNote);
  rights.may_reply = as_trainee(Action::ReplyToNote) || as_instructor(Action::ReplyToNote);
  rights.may_read_notes = as_trainee(Action::ReadNotes) || as_instructor(Action::ReadNotes);
  rights.may_ask_for_help = as_trainee(Action::AskForHelp);
  return rights;
}

std::vector<database::Note> notes_about(Session& session, const AttemptHeader& header) {
  if (auto desk = instructor_desk_for(session, Action::ReadNotes, header))
    return desk->notes(header.id);
  if (auto own = trainee_desk_for(session, Action::ReadNotes, header)) return own->notes(header.id);
  return {};
}

std::vector<database::HelpRequest> questions_about(Session& session, const AttemptHeader& header) {
  if (auto desk = instructor_desk_for(session, Action::ReadHelp, header))
    return desk->help_requests_about(header.id);
  if (auto own = trainee_desk_for(session, Action::ReadHelp, header))
    return own->help_requests_about(header.id);
  return {};
}

void reply_to_note(Session& session, const AttemptHeader& header, database::NoteId note,
                   const std::string& text) {
  if (auto desk = instructor_desk_for(session, Action::ReplyToNote, header)) {
    desk->reply(note, text);
    return;
  }
  desk_or_refused(trainee_desk_for(session, Action::ReplyToNote, header),
                  "this note is not yours to answer")
      .reply(note, text);
}

void ask_for_help(Session& session, const AttemptHeader& header,
                  const database::NewHelpRequest& request) {
  desk_or_refused(trainee_desk_for(session, Action::AskForHelp, header),
                  "help can be asked for on own attempts only")
      .ask_for_help(request);
}

}  // namespace hallux::ui
