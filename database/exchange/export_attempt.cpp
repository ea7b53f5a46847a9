/// All is read in one transaction of the database, then written. An imported attempt leaves with
/// the manifest it came with, byte for byte, and only if its files still have the digests of that
/// manifest: a copy of a copy is the original, or it is refused.
#include "database/exchange/export_attempt.h"

#include <algorithm>

#include "database/course/score_json.h"
#include "database/exchange/read_manifest.h"
#include "database/exchange/record_tables.h"
#include "database/exchange/score_table.h"
#include "database/exchange/view_table.h"
#include "database/exchange/vouched_facts.h"
#include "database/exchange/write_manifest.h"
#include "database/recording/attempts.h"
#include "database/recording/display_facts.h"
#include "database/recording/recordings.h"
#include "database/store/files.h"
#include "database/store/own_directory.h"
#include "database/store/sql.h"

namespace hallux::database {

namespace {

/// All that is read, from one moment of the database.
struct Exported {
  Manifest manifest;
  std::string kept_manifest;  ///< of an imported attempt
  std::vector<std::byte> bone;
  simulator::Recording recording;
  std::vector<ChunkPlace> places;
  std::vector<simulator::DisplayFact> display_facts;
};

std::vector<ChunkPlace> load_places(Database& database, const AttemptId& id) {
  auto rows = prepared(database,
                       "SELECT c.stream, c.seq, c.first_tick, c.row_count FROM chunk c JOIN "
                       "attempt a USING (attempt_id) WHERE a.uuid = ? ORDER BY c.seq, c.stream",
                       id.text);
  return rows_of(std::move(rows), &ChunkPlace::stream, &ChunkPlace::seq, &ChunkPlace::first_tick,
                 &ChunkPlace::row_count);
}

std::vector<std::int64_t> load_scores_of(Database& database, const AttemptId& id,
                                         std::vector<ExportedScore>& scores) {
  auto rows = prepared(database,
                       "SELECT score_id, stored_utc, superseded_by IS NULL, card_json FROM score "
                       "JOIN attempt USING (attempt_id) WHERE uuid = ? ORDER BY score_id",
                       id.text);
  std::vector<std::int64_t> numbers;
  while (rows.executeStep()) {
    numbers.push_back(rows.getColumn(0).getInt64());
    scores.push_back({rows.getColumn(1).getString(), rows.getColumn(2).getInt() != 0,
                      rows.getColumn(3).getString()});
  }
  return numbers;
}

void load_decisions_of(Database& database, const AttemptId& id,
                       const std::vector<std::int64_t>& score_numbers,
                       std::vector<ExportedDecision>& decisions) {
  auto rows = prepared(
      database,
      "SELECT r.kind, r.score_id, r.score_milli, r.decided_by_person_id, r.decided_utc FROM "
      "decision r JOIN attempt a USING (attempt_id) WHERE a.uuid = ? ORDER BY r.decision_id",
      id.text);
  while (rows.executeStep()) {
    ExportedDecision decision;
    read_columns(rows, 0, decision.kind);
    const auto about =
        std::find(score_numbers.begin(), score_numbers.end(), rows.getColumn(1).getInt64());
    if (about != score_numbers.end()) {
      decision.about = static_cast<std::size_t>(about - score_numbers.begin());
    }
    read_columns(rows, 2, decision.score_milli, decision.decided_by, decision.decided_utc);
    decisions.push_back(std::move(decision));
  }
}

/// The manifest that an imported attempt came with; empty for one that was made here.
std::string load_kept_manifest(Database& database, const AttemptId& id) {
  const auto digest = found<Digest>(database,
                                    "SELECT manifest_digest FROM attempt WHERE uuid = ? AND "
                                    "manifest_digest IS NOT NULL",
                                    id);
  if (!digest) return {};
  const std::vector<std::byte> bytes = get_asset(database, *digest);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void check_exportable(Database& database, const AttemptHeader& header) {
  if (header.state == AttemptState::Recording) {
    throw DatabaseError{
        DatabaseErrorKind::BadInput,
        "attempt " + header.id.text + " is still being recorded; export it when it has ended"};
  }
  auto erased = prepared(database,
                         "SELECT substr(erased_utc, 1, 10) FROM erased_recording JOIN attempt "
                         "USING (attempt_id) WHERE uuid = ?",
                         header.id.text);
  if (!erased.executeStep()) return;
  throw DatabaseError{DatabaseErrorKind::BadInput,
                      "the recording of attempt " + header.id.text + " was erased (" +
                          erased.getColumn(0).getString() + "); there is nothing to export"};
}

/// The newest act that left the attempt's row, which each decision does; the same each time.
ExportedAct act_of(Database& database, const AttemptId& id) {
  ExportedAct act;
  auto row = prepared(database,
                      "SELECT u.audit_id, u.link FROM audit_row r JOIN audit u USING (audit_id) "
                      "WHERE r.table_name = 'attempt' AND r.row_key = "
                      "(SELECT CAST(attempt_id AS TEXT) FROM attempt WHERE uuid = ?) "
                      "ORDER BY r.audit_id DESC LIMIT 1",
                      id.text);
  if (row.executeStep()) read_columns(row, 0, act.number, act.link);
  return act;
}

/// What is known of an attempt that was made here.
Manifest manifest_of(Database& database, const AttemptHeader& header) {
  Manifest manifest;
  manifest.directory = own_directory(database);
  manifest.header = header;
  manifest.scenario = get_scenario_version(database, header.begun.scenario);
  load_decisions_of(database, header.id, load_scores_of(database, header.id, manifest.scores),
                    manifest.decisions);
  manifest.act = act_of(database, header.id);
  manifest.act->facts = facts_of(manifest);
  return manifest;
}

Exported load_exported(Database& database, const AttemptId& id) {
  return translating(database, "read what is to be exported", [&] {
    SQLite::Transaction moment{database.connection()};
    Exported exported;
    const AttemptHeader header = load_header(database, id);
    check_exportable(database, header);
    exported.kept_manifest = load_kept_manifest(database, header.id);
    exported.manifest = exported.kept_manifest.empty() ? manifest_of(database, header)
                                                       : manifest_from_json(exported.kept_manifest);
    exported.bone = get_asset(database, header.begun.bone);
    exported.recording = load_recording(database, header.id);
    exported.places = load_places(database, header.id);
    exported.display_facts = load_display_facts(database, header.id);
    return exported;
  });
}

/// The last one is in force, if any is.
std::vector<ExchangeFile> write_own_files(const Exported& exported,
                                          const std::filesystem::path& folder) {
  std::vector<ExchangeFile> files =
      write_record_tables(folder, exported.recording, exported.places);
  ExchangeWriter bone(folder, bone_name);
  bone.write({reinterpret_cast<const char*>(exported.bone.data()), exported.bone.size()});
  files.push_back(bone.finish());
  if (!exported.display_facts.empty())
    files.push_back(write_view_table(folder, exported.display_facts));
  if (!exported.manifest.scores.empty()) {
    files.push_back(
        write_score_table(folder, card_from_json(exported.manifest.scores.back().card_json)));
  }
  return files;
}

bool is_named(const std::vector<ExchangeFile>& files, const DerivedFile& file) {
  const Digest digest = digest_of(std::as_bytes(std::span{file.bytes.data(), file.bytes.size()}));
  return std::any_of(files.begin(), files.end(), [&](const ExchangeFile& known) {
    return known.name == file.name && known.digest == digest;
  });
}

/// An imported attempt must leave as it came, or not at all.
void check_as_it_came(const Exported& exported, const std::vector<ExchangeFile>& files) {
  for (const ExchangeFile& file : files) {
    const auto& known = exported.manifest.files;
    if (std::find(known.begin(), known.end(), file) != known.end()) continue;
    throw DatabaseError{DatabaseErrorKind::Damaged,
                        file.name + " of attempt " + exported.manifest.header.id.text +
                            " is not what it was imported with; restore a backup"};
  }
}

}  // namespace

void export_attempt(Database& database, const AttemptId& id, const std::filesystem::path& folder,
                    const MakeDerived& make_derived) {
  Exported exported = load_exported(database, id);
  Manifest& manifest = exported.manifest;
  const bool is_imported = !exported.kept_manifest.empty();
  const std::filesystem::path own_folder = folder / manifest.header.id.text;
  make_private_directory(own_folder);
  std::vector<ExchangeFile> files = write_own_files(exported, own_folder);
  if (is_imported) check_as_it_came(exported, files);
  for (const DerivedFile& derived :
       make_derived({manifest.header, manifest.scenario, exported.bone, exported.recording})) {
    if (is_imported && !is_named(manifest.files, derived)) continue;
    ExchangeWriter writer(own_folder, derived.name);
    writer.write(derived.bytes);
    files.push_back(writer.finish());
  }
  if (!is_imported) {
    std::sort(files.begin(), files.end(),
              [](const ExchangeFile& a, const ExchangeFile& b) { return a.name < b.name; });
    manifest.files = std::move(files);
    manifest.last_link = last_link_of(manifest.header.id, exported.recording, exported.places);
  }
  ExchangeWriter writer(own_folder, manifest_name);
  writer.write(is_imported ? exported.kept_manifest : json_from_manifest(manifest));
  writer.finish();
}

}  // namespace hallux::database
