/// Notes on a moment of an attempt, and the replies to them. The desks decide who may read and
/// write which. Inside this room only.
#pragma once

#include <vector>

#include "database/records/note.h"
#include "database/store/connection.h"

namespace hallux::database {

/// errors  DatabaseError: NotFound; BadInput where the text (database/text/free_text.h) or the
///         moment cannot be kept: after the attempt's end, or at a place that is no number
NoteId add_note(Database& database, const NewNote& note, PersonId author);

/// By moment. `with_private`: also what is for instructors only.
std::vector<Note> list_notes(Database& database, const AttemptId& attempt, bool with_private);

std::optional<Note> find_note(Database& database, NoteId id);
/// errors  DatabaseError NotFound
Note load_note(Database& database, NoteId id);

/// errors  DatabaseError: NotFound; BadInput for the text, or where the note is private
void add_reply(Database& database, NoteId note, const std::string& text, PersonId author);

/// errors  DatabaseError BadInput: before the attempt's start or after its end, a place that is no
///         number or on no body
void check_moment(const AttemptMoment& moment, std::optional<std::int64_t> duration_ticks);

}  // namespace hallux::database
