/// What the rows of a directory must be by its audit: each act says of the rows that it left what
/// they were then, or that they are gone. Inside this room only.
///
///     act --audit_row--> table, key, digest; all of them in the link of the act
///     fold: of each row the newest digest  <--compared with-->  the rows that are there
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "database/store/changed_rows.h"
#include "database/store/connection.h"
#include "simulator/base/digest.h"

namespace hallux::database {

/// A row and its digest; without one it is gone.
struct RowAccount {
  std::string table, key;
  std::optional<Digest> digest;
};

/// Of those rows as they are now, by table and key; a row that holds words gets a new salt, and the
/// salt of one that is gone goes.
/// needs   the caller's transaction
std::vector<RowAccount> account_for(Database& database, const std::set<RowName>& rows);

/// The digest of a text of the audit that is about to be stored.
RowAccount account_of_text(std::int64_t act, std::span<const std::byte> salt,
                           const std::string& text);

/// Of the accounts of one act, in their order: what its link takes in.
Digest digest_of_accounts(const std::vector<RowAccount>& accounts);

void store_accounts(Database& database, std::int64_t act, const std::vector<RowAccount>& accounts);

/// Those of the acts from `first` to `last`, by act, each in its order.
std::vector<std::pair<std::int64_t, RowAccount>> load_accounts(Database& database,
                                                               std::int64_t first,
                                                               std::int64_t last);

/// The act from which on rows are accounted for, and when it was; nothing in a database that an
/// older program made and nobody migrated.
struct Baseline {
  std::int64_t act = 0;
  std::string at_utc;
};
std::optional<Baseline> first_baseline(Database& database);

/// What differs from the accounts in one table: "is not as the audit says", "is missing", "is there
/// without an act"; nothing where all is as it should be. Reads one moment.
struct Unaccounted {
  std::string row;
  const char* how = "";
};
std::optional<Unaccounted> first_unaccounted(Database& database, const AccountedTable& table);

}  // namespace hallux::database
