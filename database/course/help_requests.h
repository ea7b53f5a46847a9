/// Questions of trainees about a moment of their attempts: an inbox for the instructors of their
/// cohorts. Inside this room only.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "database/records/note.h"
#include "database/store/connection.h"

namespace hallux::database {

/// errors  DatabaseError: NotFound; BadInput for the question or the moment
///         (database/course/notes.h)
HelpRequestId add_help_request(Database& database, const NewHelpRequest& request, PersonId asker);

/// What a list holds; a field that is set narrows it.
struct HelpFilter {
  std::optional<PersonId> asker;
  /// Asked by its trainees.
  std::optional<CohortId> cohort;
  bool open_only = false;
  std::optional<AttemptId> attempt = std::nullopt;
};

/// Open ones first, oldest first among them; then the answered, newest first.
std::vector<HelpRequest> list_help_requests(Database& database, const HelpFilter& filter);

std::optional<HelpRequest> find_help_request(Database& database, HelpRequestId id);
/// errors  DatabaseError NotFound
HelpRequest load_help_request(Database& database, HelpRequestId id);

/// errors  DatabaseError: NotFound; BadInput for the text, or where it was answered already
void answer_help_request(Database& database, HelpRequestId id, const std::string& answer,
                         PersonId by);

}  // namespace hallux::database
