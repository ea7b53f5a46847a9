#include "database/exchange/read_exported.h"

#include <algorithm>

#include "database/exchange/read_manifest.h"
#include "database/exchange/view_table.h"
#include "database/exchange/vouched_facts.h"
#include "database/recording/chain.h"

namespace hallux::database {

namespace {

namespace fs = std::filesystem;

/// A bone of a million triangles is 40 MB, its pieces are twice as much.
constexpr std::int64_t other_bytes_max = std::int64_t{1} << 28U;
constexpr std::size_t folders_max = 1'000'000;

[[noreturn]] void refuse(const fs::path& folder, const std::string& why) {
  throw DatabaseError{DatabaseErrorKind::BadInput, folder.string() + ": " + why};
}

/// That is read line by line.
bool is_table(const ExchangeFile& file) {
  return file.name == view_table_name ||
         std::find(record_table_names.begin(), record_table_names.end(), file.name) !=
             record_table_names.end();
}

/// What is made from the record may be missing; what is there must be what the manifest says.
void check_others(const ForeignFolder& folder, ImportedAttempt& attempt) {
  bool has_bone = false;
  for (const ExchangeFile& file : attempt.manifest.files) {
    if (is_table(file) || (file.name != bone_name && !folder.has(file.name))) continue;
    const std::string content = folder.read(file.name, std::min(other_bytes_max, file.bytes));
    const auto bytes = std::as_bytes(std::span{content.data(), content.size()});
    if (digest_of(bytes) != file.digest) {
      refuse(folder.path() / file.name, "does not have the digest that the manifest says");
    }
    if (file.name != bone_name) continue;
    has_bone = true;
    if (file.digest != attempt.manifest.header.begun.bone) {
      refuse(folder.path() / file.name, "is another bone than the one that was operated on");
    }
    attempt.bone.assign(bytes.begin(), bytes.end());
  }
  if (!has_bone) refuse(folder.path(), "the manifest names no bone; it is no export");
}

void check_chain(const fs::path& folder, const ImportedAttempt& attempt) {
  const Manifest& manifest = attempt.manifest;
  const Digest link =
      last_link_of(manifest.header.id, attempt.tables.recording, attempt.tables.places);
  if (link != manifest.last_link) {
    refuse(folder,
           "its tables do not give the last link of its chain; a row was altered, or they "
           "are of another attempt");
  }
  if (manifest.header.seal && !seal_form(link, manifest.header)) {
    refuse(folder, "it does not fit its seal; a fact of it was altered");
  }
}

}  // namespace

ImportedAttempt read_exported(const fs::path& folder) {
  const ForeignFolder foreign(folder);
  ImportedAttempt attempt;
  attempt.manifest_text = foreign.read(manifest_name, manifest_bytes_max);
  try {
    attempt.manifest = manifest_from_json(attempt.manifest_text);
  } catch (const DatabaseError& error) {
    throw DatabaseError{error.kind(), (folder / manifest_name).string() + ": " + error.what()};
  }
  attempt.tables = read_record_tables(foreign, attempt.manifest.files);
  attempt.tables.recording.engine = attempt.manifest.header.begun.engine;
  attempt.display_facts = read_view_table(foreign, attempt.manifest.files);
  check_others(foreign, attempt);
  check_chain(folder, attempt);
  TakenManifest taken = taken_of(attempt.manifest);
  attempt.manifest = std::move(taken.manifest);
  attempt.why_not_all = std::move(taken.why_not_all);
  return attempt;
}

std::vector<fs::path> find_exported(const fs::path& folder) {
  std::vector<fs::path> found;
  if (ForeignFolder(folder).has(manifest_name)) return {folder};
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    // A link is not followed: it may lead anywhere.
    if (!fs::is_directory(entry->symlink_status())) continue;
    if (ForeignFolder(entry->path()).has(manifest_name)) found.push_back(entry->path());
    if (found.size() > folders_max) refuse(folder, "holds too many folders");
  }
  if (found.empty()) refuse(folder, "holds no exported attempt; name what `hallux export` wrote");
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace hallux::database
