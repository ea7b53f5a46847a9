#include "database/maintenance/backup_manifest.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "database/store/durable_file.h"

namespace hallux::database {

namespace {

using nlohmann::ordered_json;

constexpr std::string_view manifest_kind = "hallux backup";
constexpr int depth_max = 4;
/// A million recordings.
constexpr std::int64_t backup_manifest_bytes_max = std::int64_t{256} << 20U;

ordered_json json_of(const BackupManifest& manifest) {
  ordered_json recordings = ordered_json::array();
  for (const BackedUpRecording& kept : manifest.recordings) {
    recordings.push_back({{"attempt", kept.attempt.text},
                          {"bytes", kept.bytes},
                          {"digest", hex_from_digest(kept.digest)}});
  }
  ordered_json damaged = ordered_json::array();
  for (const AttemptId& attempt : manifest.damaged) damaged.push_back(attempt.text);
  return {
      {"kind", manifest_kind},
      {"format", backup_format},
      {"name", manifest.name},
      {"directory", manifest.directory},
      {"made_utc", manifest.made_utc},
      {"tables", {{"bytes", manifest.tables_bytes}, {"digest", hex_from_digest(manifest.tables)}}},
      {"recordings", recordings},
      {"damaged", damaged}};
}

std::string check_of(const ordered_json& json) {
  const std::string text = json.dump();
  return hex_from_digest(digest_of(std::as_bytes(std::span{text.data(), text.size()})));
}

Digest digest_at(const ordered_json& json) {
  return digest_from_hex(json.at("digest").get<std::string>()).value();
}

/// Throws what the library throws where a member is missing or of another type.
BackupManifest manifest_in(const ordered_json& json) {
  BackupManifest manifest;
  manifest.name = json.at("name").get<std::string>();
  manifest.directory = json.at("directory").get<std::string>();
  manifest.made_utc = json.at("made_utc").get<std::string>();
  manifest.tables_bytes = json.at("tables").at("bytes").get<std::int64_t>();
  manifest.tables = digest_at(json.at("tables"));
  for (const ordered_json& kept : json.at("recordings")) {
    manifest.recordings.push_back({{kept.at("attempt").get<std::string>()},
                                   kept.at("bytes").get<std::int64_t>(),
                                   digest_at(kept)});
  }
  for (const ordered_json& attempt : json.at("damaged")) {
    manifest.damaged.push_back({attempt.get<std::string>()});
  }
  return manifest;
}

[[noreturn]] void fail(DatabaseErrorKind kind, const std::filesystem::path& file,
                       const char* reason) {
  throw DatabaseError{kind, file.string() + " " + reason};
}

/// What a name in it may lead to is this folder only.
void check_names(const BackupManifest& manifest, const std::filesystem::path& file) {
  const bool names_itself = manifest.name == file.stem().string();
  const bool are_uuids =
      std::all_of(manifest.recordings.begin(), manifest.recordings.end(),
                  [](const BackedUpRecording& kept) { return is_uuid(kept.attempt.text); });
  if (names_itself && are_uuids) return;
  fail(DatabaseErrorKind::Damaged, file,
       "names a file that no backup of that name has; give a backup its own name back, or take "
       "another one");
}

}  // namespace

bool is_uuid(const std::string& text) noexcept {
  return text.size() == 36 && text.find_first_not_of("0123456789abcdef-") == std::string::npos;
}

void write_manifest(const std::filesystem::path& file, const BackupManifest& manifest) {
  ordered_json json = json_of(manifest);
  json["check"] = check_of(json);
  const std::string text = json.dump(1) + "\n";
  const std::filesystem::path unfinished = file.string() + ".part";
  {
    DurableFile written = DurableFile::create(unfinished);
    written.write(std::as_bytes(std::span{text.data(), text.size()}));
    written.sync();
  }
  put_in_place(unfinished, file);
}

BackupManifest read_manifest(const std::filesystem::path& file) {
  const std::vector<std::byte> bytes = read_plain_file(file, backup_manifest_bytes_max);
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes that are a text
  const std::string_view text{reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  // What lies deeper than a manifest goes is dropped, and then the check does not fit.
  const auto is_shallow = [](int depth, auto, auto&) { return depth <= depth_max; };
  ordered_json json = ordered_json::parse(text, is_shallow, false);
  if (!json.is_object() || json.value("kind", ordered_json{}) != manifest_kind) {
    fail(DatabaseErrorKind::BadInput, file, "is no manifest of a backup; give one, or its folder");
  }
  const ordered_json format = json.value("format", ordered_json{});
  if (format.is_number_integer() && format.get<std::int64_t>() > backup_format) {
    fail(DatabaseErrorKind::Newer, file,
         "was written by a newer version of this program; install that one");
  }
  const ordered_json check = json.value("check", ordered_json{});
  json.erase("check");
  try {
    if (check != check_of(json)) {
      fail(DatabaseErrorKind::Damaged, file, "was altered or damaged; take another backup");
    }
    BackupManifest manifest = manifest_in(json);
    check_names(manifest, file);
    return manifest;
  } catch (const nlohmann::json::exception&) {
    fail(DatabaseErrorKind::Damaged, file, "was altered or damaged; take another backup");
  } catch (const std::bad_optional_access&) {
    fail(DatabaseErrorKind::Damaged, file, "was altered or damaged; take another backup");
  }
}

}  // namespace hallux::database
