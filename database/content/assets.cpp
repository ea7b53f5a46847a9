#include "database/content/assets.h"

#include <zstd.h>

#include <algorithm>

#include "database/store/sql.h"

namespace hallux::database {

namespace {

constexpr int zstd_level = 3;
/// A bone of a million triangles is 40 MB; more than this is no asset of ours.
constexpr std::int64_t asset_bytes_max = 1LL << 30U;

std::vector<std::byte> compressed(std::span<const std::byte> bytes) {
  std::vector<std::byte> packed(ZSTD_compressBound(bytes.size()));
  packed.resize(
      ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), zstd_level));
  return packed;
}

Digest digest_of_text(std::string_view text) {
  return digest_of(std::as_bytes(std::span{text.data(), text.size()}));
}

}  // namespace

Digest put_asset(Database& database, std::string_view kind, std::span<const std::byte> bytes) {
  const Digest digest = digest_of(bytes);
  translating(database, "look for an asset", [&] {
    auto found = prepared(database, "SELECT 1 FROM asset WHERE digest = ?", digest);
    if (found.executeStep()) return;
    const std::vector<std::byte> packed = compressed(bytes);
    in_transaction_of_caller(database, "store an asset", [&] {
      execute(database,
              "INSERT OR IGNORE INTO asset (digest, kind, plain_bytes, zstd) "
              "VALUES (?, ?, ?, ?)",
              digest, kind, static_cast<std::int64_t>(bytes.size()), packed);
    });
  });
  return digest;
}

std::vector<std::byte> get_asset(Database& database, const Digest& digest) {
  return translating(database, "read an asset", [&] {
    auto row = prepared(database, "SELECT plain_bytes, zstd FROM asset WHERE digest = ?", digest);
    const std::string name = "asset " + hex_from_digest(digest) + " of " + database.file().string();
    if (!row.executeStep()) {
      throw DatabaseError{DatabaseErrorKind::NotFound, "there is no " + name};
    }
    const std::int64_t plain_bytes = row.getColumn(0).getInt64();
    const SQLite::Column packed = row.getColumn(1);
    std::vector<std::byte> bytes;
    if (plain_bytes >= 0 && plain_bytes <= asset_bytes_max) {
      bytes.resize(static_cast<std::size_t>(plain_bytes));
      const std::size_t read = ZSTD_decompress(bytes.data(), bytes.size(), packed.getBlob(),
                                               static_cast<std::size_t>(packed.getBytes()));
      if (ZSTD_isError(read) == 0 && read == bytes.size() && digest_of(bytes) == digest) {
        return bytes;
      }
    }
    throw DatabaseError{DatabaseErrorKind::Damaged,
                        name + " was altered: its bytes do not give its digest; restore a backup"};
  });
}

ScenarioVersionId put_scenario_version(Database& database, const ScenarioText& text) {
  const Digest digest = digest_of_text(text.json);
  return in_transaction_of_caller(database, "store a scenario version", [&] {
    execute(database,
            "INSERT OR IGNORE INTO scenario_version (name, version, json, digest, is_reviewed, "
            "stored_utc) VALUES (?, ?, ?, ?, ?, ?)",
            text.name, text.version, text.json, digest, text.is_reviewed ? 1 : 0,
            utc_now(database));
    return single<ScenarioVersionId>(
        database, "SELECT scenario_version_id FROM scenario_version WHERE digest = ?", digest);
  });
}

ScenarioText get_scenario_version(Database& database, ScenarioVersionId id) {
  return translating(database, "read a scenario version", [&] {
    auto row = prepared(database,
                        "SELECT name, version, json, is_reviewed, digest FROM scenario_version "
                        "WHERE scenario_version_id = ?",
                        id.number);
    const std::string name =
        "scenario version " + std::to_string(id.number) + " of " + database.file().string();
    if (!row.executeStep()) {
      throw DatabaseError{DatabaseErrorKind::NotFound, "there is no " + name};
    }
    ScenarioText text{row.getColumn(0).getString(), row.getColumn(1).getInt(),
                      row.getColumn(2).getString(), row.getColumn(3).getInt() != 0};
    if (digest_of_text(text.json) != digest_in(row.getColumn(4))) {
      throw DatabaseError{DatabaseErrorKind::Damaged, name + " was altered; restore a backup"};
    }
    return text;
  });
}

}  // namespace hallux::database
