#include "database/people/notices.h"

#include "database/store/sql.h"

namespace hallux::database {

namespace {

/// Everybody sees their newest ones first; who was away for years is not buried.
constexpr const char* newest_first = " ORDER BY n.notice_id DESC LIMIT 50";

/// `about_id` is a person's number, an attempt's row, or a count: the kind says which. A decision
/// is told of just before it is made.
constexpr const char* notice_columns =
    "SELECT n.notice_id, n.kind, n.at_utc, n.person_id IS NULL, coalesce(d.login, "
    "(SELECT p.login FROM decision r JOIN person_detail p ON p.person_id = r.decided_by_person_id "
    "WHERE r.attempt_id = a.attempt_id AND 'result_' || r.kind = n.kind "
    "AND r.decided_utc >= n.at_utc ORDER BY r.decision_id LIMIT 1), ''), a.uuid, "
    "coalesce(n.about_id, 0) FROM notice n "
    "LEFT JOIN person_detail d ON d.person_id = n.about_id "
    "AND n.kind IN ('recovered', 'administrator_made', 'code_issued', 'password_set', "
    "'name_corrected') "
    "LEFT JOIN attempt a ON a.attempt_id = n.about_id "
    "AND n.kind IN ('result_overridden', 'result_voided') "
    "WHERE NOT EXISTS (SELECT 1 FROM notice_seen s WHERE s.notice_id = n.notice_id "
    "AND s.person_id = ?1) AND ";

void insert_notice(Database& database, std::optional<PersonId> told, NoticeKind kind,
                   std::optional<std::int64_t> about) {
  execute(database, "INSERT INTO notice (person_id, kind, about_id, at_utc) VALUES (?, ?, ?, ?)",
          told, name_of(kind), about, utc_now(database));
}

std::optional<std::int64_t> number_of(Database& database, const NoticeSubject& about) {
  if (about.person) return about.person->number;
  if (!about.attempt) return std::nullopt;
  return found<std::int64_t>(database, "SELECT attempt_id FROM attempt WHERE uuid = ?",
                             about.attempt->text);
}

std::vector<Notice> read_notices(Database& database, PersonId person, const char* whose) {
  return translating(database, "read the notices", [&] {
    auto rows =
        prepared(database, std::string{notice_columns} + whose + newest_first, person.number);
    std::vector<Notice> notices;
    while (rows.executeStep()) {
      const auto kind = named<NoticeKind>(rows.getColumn(1).getString());
      if (!kind) continue;
      Notice notice;
      read_columns(rows, 0, notice.id);
      notice.kind = *kind;
      read_columns(rows, 2, notice.at_utc, notice.is_for_administrators, notice.login,
                   notice.attempt);
      if (*kind == NoticeKind::SignInsRefused) notice.count = rows.getColumn(6).getInt64();
      notices.push_back(std::move(notice));
    }
    return notices;
  });
}

}  // namespace

void tell_person(Database& database, PersonId told, NoticeKind kind, const NoticeSubject& about) {
  in_transaction_of_caller(database, "tell a person", [&] {
    insert_notice(database, told, kind, number_of(database, about));
  });
}

void tell_administrators(Database& database, NoticeKind kind, const NoticeSubject& about) {
  in_transaction_of_caller(database, "tell the administrators", [&] {
    insert_notice(database, std::nullopt, kind, number_of(database, about));
  });
}

void tell_of_refused_sign_in(Database& database, PersonId told) {
  in_transaction_of_caller(database, "tell a person", [&] {
    if (execute(database,
                "UPDATE notice SET about_id = about_id + 1, at_utc = ?1 WHERE notice_id = "
                "(SELECT n.notice_id FROM notice n WHERE n.person_id = ?2 AND n.kind = "
                "'sign_ins_refused' "
                "AND NOT EXISTS (SELECT 1 FROM notice_seen s WHERE s.notice_id = n.notice_id) "
                "ORDER BY n.notice_id DESC LIMIT 1)",
                utc_now(database), told.number) == 0)
      insert_notice(database, told, NoticeKind::SignInsRefused, 1);
  });
}

std::vector<Notice> unseen_notices(Database& database, PersonId person) {
  return read_notices(database, person, "n.person_id = ?1");
}

std::vector<Notice> unseen_notices_of_administrators(Database& database, PersonId person) {
  return read_notices(database, person, "n.person_id IS NULL");
}

std::optional<NoticeAudience> audience_of(Database& database, NoticeId notice) {
  return translating(database, "look for a notice", [&]() -> std::optional<NoticeAudience> {
    auto row =
        prepared(database, "SELECT person_id FROM notice WHERE notice_id = ?", notice.number);
    if (!row.executeStep()) return std::nullopt;
    NoticeAudience audience;
    read_columns(row, 0, audience.person);
    return audience;
  });
}

void acknowledge_notice(Database& database, NoticeId notice, PersonId person) {
  in_transaction_of_caller(database, "acknowledge a notice", [&] {
    execute(database,
            "INSERT OR IGNORE INTO notice_seen (notice_id, person_id, seen_utc) VALUES (?, ?, ?)",
            notice.number, person.number, utc_now(database));
  });
}

}  // namespace hallux::database
