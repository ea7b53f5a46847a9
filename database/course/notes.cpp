#include "database/course/notes.h"

#include <algorithm>
#include <cmath>

#include "database/course/moment_columns.h"
#include "database/recording/attempts.h"
#include "database/store/sql.h"
#include "database/text/free_text.h"

namespace hallux::database {

namespace {

constexpr std::int64_t us_per_tick = 1000;
/// No bone of a foot is that far from its own frame.
constexpr double place_mm_max = 10'000.0;

constexpr const char* note_columns =
    "SELECT n.note_id, a.uuid, n.moment_us, n.body, n.x_in_bone_mm, n.y_in_bone_mm, "
    "n.z_in_bone_mm, n.author_person_id, coalesce(d.display_name, ''), n.is_private, n.text, "
    "n.written_utc FROM note n JOIN attempt a USING (attempt_id) "
    "LEFT JOIN person_detail d ON d.person_id = n.author_person_id ";

Note note_in(SQLite::Statement& row) {
  Note note;
  read_columns(row, 0, note.id, note.attempt);
  note.moment = moment_in(row, 2);
  read_columns(row, 7, note.author, note.author_name, note.is_private, note.text, note.written_utc);
  return note;
}

std::vector<NoteReply> replies_to(Database& database, NoteId note) {
  auto rows =
      prepared(database,
               "SELECT r.author_person_id, coalesce(d.display_name, ''), r.text, r.written_utc "
               "FROM note_reply r LEFT JOIN person_detail d ON d.person_id = r.author_person_id "
               "WHERE r.note_id = ? ORDER BY r.note_reply_id",
               note.number);
  return rows_of(std::move(rows), &NoteReply::author, &NoteReply::author_name, &NoteReply::text,
                 &NoteReply::written_utc);
}

}  // namespace

void check_moment(const AttemptMoment& moment, std::optional<std::int64_t> duration_ticks) {
  const auto fail = [](const char* why) { throw DatabaseError{DatabaseErrorKind::BadInput, why}; };
  if (moment.moment_us < 0) fail("the moment lies before the attempt; choose one of the attempt");
  if (duration_ticks && moment.moment_us > *duration_ticks * us_per_tick) {
    fail("the moment lies after the attempt's end; choose one of the attempt");
  }
  if (!moment.place) return;
  if (moment.place->body < 0) fail("the place is on no body; point at the bone or a piece of it");
  for (const double coordinate_mm : moment.place->point_in_bone_mm) {
    if (!(std::abs(coordinate_mm) < place_mm_max)) {
      fail("the place is not near the bone; point at the bone or a piece of it");
    }
  }
}

NoteId add_note(Database& database, const NewNote& note, PersonId author) {
  check_free_text("the note", note.text);
  const AttemptHeader header = load_header(database, note.attempt);
  check_moment(note.moment, header.duration_ticks);
  return in_transaction_of_caller(database, "add a note", [&] {
    execute(
        database,
        "INSERT INTO note (attempt_id, author_person_id, is_private, text, written_utc, moment_us, "
        "body, x_in_bone_mm, y_in_bone_mm, z_in_bone_mm) "
        "SELECT attempt_id, ?, ?, ?, ?, ?, ?, ?, ?, ? FROM attempt WHERE uuid = ?",
        author, note.is_private, note.text, utc_now(database), columns_of(note.moment), header.id);
    return NoteId{database.connection().getLastInsertRowid()};
  });
}

std::vector<Note> list_notes(Database& database, const AttemptId& attempt, bool with_private) {
  return translating(database, "read the notes of attempt " + attempt.text, [&] {
    auto rows = prepared(database,
                         std::string{note_columns} +
                             "WHERE a.uuid = ? AND (n.is_private = 0 OR ?) "
                             "ORDER BY n.moment_us, n.note_id",
                         attempt.text, with_private ? 1 : 0);
    std::vector<Note> notes;
    while (rows.executeStep()) notes.push_back(note_in(rows));
    for (Note& note : notes) note.replies = replies_to(database, note.id);
    return notes;
  });
}

std::optional<Note> find_note(Database& database, NoteId id) {
  return translating(database, "read a note", [&]() -> std::optional<Note> {
    auto row = prepared(database, std::string{note_columns} + "WHERE n.note_id = ?", id.number);
    if (!row.executeStep()) return std::nullopt;
    Note note = note_in(row);
    note.replies = replies_to(database, id);
    return note;
  });
}

Note load_note(Database& database, NoteId id) {
  if (std::optional<Note> note = find_note(database, id)) return *std::move(note);
  throw DatabaseError{DatabaseErrorKind::NotFound, "there is no note " + std::to_string(id.number) +
                                                       " in " + database.file().string()};
}

void add_reply(Database& database, NoteId note, const std::string& text, PersonId author) {
  check_free_text("the reply", text);
  in_transaction_of_caller(database, "reply to a note", [&] {
    if (load_note(database, note).is_private) {
      throw DatabaseError{DatabaseErrorKind::BadInput,
                          "a private note has no replies; write a note of your own"};
    }
    execute(database,
            "INSERT INTO note_reply (note_id, author_person_id, text, "
            "written_utc) VALUES (?, ?, ?, ?)",
            note.number, author.number, text, utc_now(database));
  });
}

}  // namespace hallux::database
