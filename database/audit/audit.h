/// The audit: what was done by whom to what, only ever added to, each row chained to the one
/// before. Inside this room only.
///
/// Each act also says what the rows are that it left, by digest (database/audit/row_accounts.h).
/// A row holds numbers, uuids and digests. Names and free text stand in audit_text with a salt, can
/// be erased there, and are bound to the chain by their salted digest. What it can show: that a row
/// was altered or one in the middle taken away. What it cannot: that the last rows were cut off, or
/// that the whole file was written anew, by someone who owns the operating-system account.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "database/records/ids.h"
#include "database/store/connection.h"
#include "simulator/base/digest.h"

namespace hallux::database {

struct RowAccount;

struct AuditEntry {
  /// Nothing: nobody signed in.
  std::optional<PersonId> actor;
  /// "signed_in", "attempt_sealed".
  std::string action;
  /// "attempt" and its uuid, "person" and its number.
  std::string subject_kind, subject_id;
  bool was_refused = false;
  /// Of what was sealed or stored; not together with `text`.
  std::optional<Digest> detail = {};
  /// Names and free text: kept where it can be erased.
  std::string text = {};
};

struct AuditRow {
  std::int64_t number = 0;
  std::string at_utc;
  AuditEntry entry;
};

/// Appends inside the caller's transaction, or in one of its own where there is none.
/// errors  DatabaseError
void append_audit(Database& database, const AuditEntry& entry);

/// An act that accounts for those rows, whatever changed.
/// needs   the caller's transaction
void append_baseline(Database& database, const AuditEntry& entry, std::vector<RowAccount> accounts);

/// Shows each row to `visit`, oldest first, a thousand in one reading.
/// errors  DatabaseError Damaged naming the first row whose link does not fit; what `visit` throws
void walk_audit(Database& database, const std::function<void(const AuditRow&)>& visit);

/// All rows, oldest first.
/// errors  DatabaseError Damaged naming the first row whose link does not fit
std::vector<AuditRow> read_audit(Database& database);

}  // namespace hallux::database
