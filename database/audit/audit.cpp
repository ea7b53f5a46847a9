#include "database/audit/audit.h"

#include <sodium.h>

#include <array>
#include <map>

#include "database/audit/row_accounts.h"
#include "database/store/sql.h"
#include "simulator/base/check.h"

namespace hallux::database {

namespace {

using Salt = std::array<std::byte, 16>;
constexpr std::int64_t rows_at_once = 1000;

Digest salted_digest(std::span<const std::byte> salt, std::string_view text) {
  Digester digester;
  digester.add_bytes(salt);
  digester.add_text(text);
  return digester.finish();
}

/// `accounts` of the rows that the act left; an act of before there were any has none.
Digest audit_link(const Digest& before, const AuditRow& row,
                  const std::optional<Digest>& accounts) {
  Digester digester;
  digester.add_digest(before);
  digester.add_int(row.number);
  digester.add_text(row.at_utc);
  digester.add_int(row.entry.actor ? row.entry.actor->number : 0);
  digester.add_text(row.entry.action);
  digester.add_text(row.entry.subject_kind);
  digester.add_text(row.entry.subject_id);
  digester.add_text(row.entry.was_refused ? "refused" : "done");
  digester.add_digest(row.entry.detail.value_or(Digest{}));
  if (accounts) digester.add_digest(*accounts);
  return digester.finish();
}

void store_text(Database& database, std::int64_t number, const Salt& salt,
                const std::string& text) {
  execute(database, "INSERT INTO audit_text (audit_id, salt, text) VALUES (?, ?, ?)", number, salt,
          text);
}

void store_row(Database& database, const AuditRow& row, const Digest& link) {
  execute(database,
          "INSERT INTO audit (audit_id, at_utc, actor_person_id, action, subject_kind, subject_id, "
          "outcome, detail_digest, link) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)",
          row.number, row.at_utc, row.entry.actor, row.entry.action, row.entry.subject_kind,
          row.entry.subject_id, row.entry.was_refused ? "refused" : "done", row.entry.detail, link);
}

/// needs   a transaction that began IMMEDIATE: two writers must not take the same number
void append_in_transaction(Database& database, AuditEntry entry, std::vector<RowAccount> accounts) {
  Digest before;
  std::int64_t last_number = 0;
  {
    auto last =
        prepared(database, "SELECT audit_id, link FROM audit ORDER BY audit_id DESC LIMIT 1");
    if (last.executeStep()) read_columns(last, 0, last_number, before);
  }
  CHECK(entry.text.empty() || !entry.detail);
  Salt salt{};
  if (!entry.text.empty()) {
    randombytes_buf(salt.data(), salt.size());
    entry.detail = salted_digest(salt, entry.text);
  }
  const AuditRow row{last_number + 1, utc_now(database), std::move(entry)};
  if (!row.entry.text.empty()) {
    accounts.push_back(account_of_text(row.number, salt, row.entry.text));
  }
  store_row(database, row, audit_link(before, row, digest_of_accounts(accounts)));
  store_accounts(database, row.number, accounts);
  if (row.entry.text.empty()) return;
  store_text(database, row.number, salt, row.entry.text);
  if (database.changes() != nullptr) {
    database.changes()->forget({"audit_text", std::to_string(row.number)});
  }
}

std::vector<RowAccount> accounts_of_changes(Database& database) {
  if (database.changes() == nullptr) return {};
  return account_for(database, database.changes()->take());
}

AuditRow row_in(SQLite::Statement& rows) {
  AuditRow row;
  read_columns(rows, 0, row.number, row.at_utc, row.entry.actor, row.entry.action,
               row.entry.subject_kind, row.entry.subject_id);
  row.entry.was_refused = rows.getColumn(6).getString() == "refused";
  read_columns(rows, 7, row.entry.detail);
  read_columns(rows, 9, row.entry.text);
  return row;
}

/// The outcome is one of two words, and a text that was not erased is the one that the row's digest
/// is of.
bool has_own_words(SQLite::Statement& rows, const AuditRow& row) {
  if (rows.getColumn(6).getString() != (row.entry.was_refused ? "refused" : "done")) return false;
  if (rows.getColumn(9).isNull()) return true;
  const SQLite::Column salt = rows.getColumn(10);
  const auto* bytes = static_cast<const std::byte*>(salt.getBlob());
  return salted_digest({bytes, static_cast<std::size_t>(salt.getBytes())}, row.entry.text) ==
         row.entry.detail;
}

/// The accounts of each act of some in a row, as its link takes them in.
class AccountsOfActs {
 public:
  AccountsOfActs(Database& database, std::int64_t first, std::int64_t baseline)
      : baseline_(baseline) {
    if (baseline_ == 0) return;
    for (auto& [act, account] : load_accounts(database, first, first + rows_at_once)) {
      of_act_[act].push_back(std::move(account));
    }
  }
  std::optional<Digest> digest(std::int64_t act) {
    if (baseline_ == 0 || act < baseline_) return std::nullopt;
    return digest_of_accounts(of_act_[act]);
  }

 private:
  std::int64_t baseline_;
  std::map<std::int64_t, std::vector<RowAccount>> of_act_;
};

/// Some rows after number `last`, the link of which is `link`; that becomes the link of the last of
/// them.
std::vector<AuditRow> rows_after(Database& database, std::int64_t last, Digest& link,
                                 std::int64_t baseline) {
  return translating(database, "read the audit", [&] {
    AccountsOfActs accounts{database, last + 1, baseline};
    auto rows = prepared(
        database,
        "SELECT a.audit_id, a.at_utc, a.actor_person_id, a.action, a.subject_kind, a.subject_id, "
        "a.outcome, a.detail_digest, a.link, t.text, t.salt FROM audit a "
        "LEFT JOIN audit_text t ON t.audit_id = a.audit_id WHERE a.audit_id > ? "
        "ORDER BY a.audit_id LIMIT ?",
        last, rows_at_once);
    std::vector<AuditRow> some;
    while (rows.executeStep()) {
      AuditRow row = row_in(rows);
      link = audit_link(link, row, accounts.digest(row.number));
      if (row.number != ++last || !has_own_words(rows, row) ||
          link != digest_in(rows.getColumn(8))) {
        throw DatabaseError{DatabaseErrorKind::Damaged,
                            "row " + std::to_string(row.number) + " of the audit in " +
                                database.file().string() +
                                " was altered, or one before it was taken away"};
      }
      some.push_back(std::move(row));
    }
    return some;
  });
}

}  // namespace

void append_audit(Database& database, const AuditEntry& entry) {
  in_transaction_of_caller(database, "add to the audit", [&] {
    append_in_transaction(database, entry, accounts_of_changes(database));
  });
}

void append_baseline(Database& database, const AuditEntry& entry,
                     std::vector<RowAccount> accounts) {
  append_in_transaction(database, entry, std::move(accounts));
}

void walk_audit(Database& database, const std::function<void(const AuditRow&)>& visit) {
  Digest link;
  std::int64_t last = 0;
  const std::int64_t baseline = translating(database, "look for the baseline", [&] {
    return first_baseline(database).value_or(Baseline{}).act;
  });
  for (auto some = rows_after(database, last, link, baseline); !some.empty();
       some = rows_after(database, last, link, baseline)) {
    for (const AuditRow& row : some) visit(row);
    last = some.back().number;
  }
}

std::vector<AuditRow> read_audit(Database& database) {
  std::vector<AuditRow> audit;
  walk_audit(database, [&audit](const AuditRow& row) { audit.push_back(row); });
  return audit;
}

}  // namespace hallux::database
