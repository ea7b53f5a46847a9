#include "database/course/help_requests.h"

#include "database/course/moment_columns.h"
#include "database/course/notes.h"
#include "database/recording/attempt_numbers.h"
#include "database/recording/attempts.h"
#include "database/store/sql.h"
#include "database/text/free_text.h"

namespace hallux::database {

namespace {

constexpr const char* help_columns =
    "SELECT h.help_request_id, a.uuid, v.name, h.moment_us, h.body, h.x_in_bone_mm, "
    "h.y_in_bone_mm, h.z_in_bone_mm, h.asker_person_id, coalesce(d.display_name, ''), h.question, "
    "h.asked_utc, h.answer, coalesce(e.display_name, ''), h.answered_utc, a.attempt_id, "
    "a.person_id "
    "FROM help_request h JOIN attempt a USING (attempt_id) "
    "JOIN scenario_version v USING (scenario_version_id) "
    "LEFT JOIN person_detail d ON d.person_id = h.asker_person_id "
    "LEFT JOIN person_detail e ON e.person_id = h.answered_by_person_id ";

constexpr const char* listing_order =
    "ORDER BY h.answered_utc IS NOT NULL, "
    "CASE WHEN h.answered_utc IS NULL THEN h.help_request_id ELSE -h.help_request_id END ";
/// After years there are ten thousand answered ones in an inbox; nobody turns so many pages.
constexpr std::int32_t listed_most = 500;

HelpRequest request_in(AttemptNumbers& numbers, SQLite::Statement& row) {
  HelpRequest request;
  read_columns(row, 0, request.id, request.attempt, request.scenario_name);
  request.moment = moment_in(row, 3);
  read_columns(row, 8, request.asker, request.asker_name, request.question, request.asked_utc);
  if (!row.getColumn(12).isNull()) {
    request.answer = HelpAnswer{row.getColumn(13).getString(), row.getColumn(12).getString(),
                                row.getColumn(14).getString()};
  }
  CountedAttempt about{std::nullopt, request.scenario_name};
  read_columns(row, 15, about.order, about.person);
  request.attempt_number = numbers.number_of(about);
  return request;
}

}  // namespace

HelpRequestId add_help_request(Database& database, const NewHelpRequest& request, PersonId asker) {
  check_free_text("the question", request.question);
  const AttemptHeader header = load_header(database, request.attempt);
  check_moment(request.moment, header.duration_ticks);
  return in_transaction_of_caller(database, "ask for help", [&] {
    execute(
        database,
        "INSERT INTO help_request (attempt_id, asker_person_id, question, asked_utc, moment_us, "
        "body, x_in_bone_mm, y_in_bone_mm, z_in_bone_mm) "
        "SELECT attempt_id, ?, ?, ?, ?, ?, ?, ?, ? FROM attempt WHERE uuid = ?",
        asker, request.question, utc_now(database), columns_of(request.moment), header.id);
    return HelpRequestId{database.connection().getLastInsertRowid()};
  });
}

std::vector<HelpRequest> list_help_requests(Database& database, const HelpFilter& filter) {
  return translating(database, "list the help requests", [&] {
    auto rows = prepared(
        database,
        std::string{help_columns} +
            "WHERE h.help_request_id IN (SELECT h.help_request_id FROM help_request h "
            "WHERE (?1 IS NULL OR h.asker_person_id = ?1) "
            "AND (?2 IS NULL OR h.asker_person_id IN (SELECT person_id FROM membership "
            "WHERE cohort_id = ?2 AND role = 'trainee')) "
            "AND (h.answered_utc IS NULL OR NOT ?3) "
            "AND (?5 IS NULL OR h.attempt_id = (SELECT attempt_id FROM attempt WHERE "
            "uuid = ?5)) " +
            listing_order + "LIMIT ?4) " + listing_order,
        filter.asker, filter.cohort, filter.open_only ? 1 : 0, listed_most, filter.attempt);
    AttemptNumbers numbers{database};
    return collected(rows, [&numbers](SQLite::Statement& row) { return request_in(numbers, row); });
  });
}

std::optional<HelpRequest> find_help_request(Database& database, HelpRequestId id) {
  return translating(database, "read a help request", [&]() -> std::optional<HelpRequest> {
    auto row =
        prepared(database, std::string{help_columns} + "WHERE h.help_request_id = ?", id.number);
    if (!row.executeStep()) return std::nullopt;
    AttemptNumbers numbers{database};
    return request_in(numbers, row);
  });
}

HelpRequest load_help_request(Database& database, HelpRequestId id) {
  if (std::optional<HelpRequest> request = find_help_request(database, id)) {
    return *std::move(request);
  }
  throw DatabaseError{
      DatabaseErrorKind::NotFound,
      "there is no help request " + std::to_string(id.number) + " in " + database.file().string()};
}

void answer_help_request(Database& database, HelpRequestId id, const std::string& answer,
                         PersonId by) {
  check_free_text("the answer", answer);
  in_transaction_of_caller(database, "answer a help request", [&] {
    load_help_request(database, id);
    if (execute(database,
                "UPDATE help_request SET answer = ?, answered_by_person_id = ?, answered_utc = ? "
                "WHERE help_request_id = ? AND answered_utc IS NULL",
                answer, by.number, utc_now(database), id.number) == 1)
      return;
    throw DatabaseError{DatabaseErrorKind::BadInput,
                        "help request " + std::to_string(id.number) +
                            " was answered already; add a note to the attempt instead"};
  });
}

}  // namespace hallux::database
