#include "database/maintenance/erasure_journal.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "database/store/durable_file.h"
#include "database/store/files.h"
#include "simulator/base/digest.h"

namespace hallux::database {

namespace {

/// A hundred thousand erasures are 30 MB.
constexpr std::int64_t journal_bytes_max = std::int64_t{64} << 20U;

std::string check_of(const JournalLine& line) {
  Digester digester;
  digester.add_text(line.directory);
  digester.add_int(line.person.number);
  digester.add_int(line.with_recordings ? 1 : 0);
  digester.add_text(line.erased_utc);
  return hex_from_digest(digester.finish());
}

std::string text_of(const JournalLine& line) {
  const nlohmann::ordered_json json{{"directory", line.directory},
                                    {"person", line.person.number},
                                    {"recordings", line.with_recordings},
                                    {"erased_utc", line.erased_utc},
                                    {"check", check_of(line)}};
  return json.dump() + "\n";
}

std::optional<JournalLine> line_in(std::string_view text) {
  const auto json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  const auto text_at = [&](const char* key) {
    return json.contains(key) && json[key].is_string() ? json[key].get<std::string>() : "";
  };
  JournalLine line{text_at("directory"), {}, false, text_at("erased_utc")};
  if (!json.contains("person") || !json["person"].is_number_integer()) return std::nullopt;
  if (!json.contains("recordings") || !json["recordings"].is_boolean()) return std::nullopt;
  line.person.number = json["person"].get<std::int64_t>();
  line.with_recordings = json["recordings"].get<bool>();
  if (check_of(line) != text_at("check")) return std::nullopt;
  return line;
}

struct ReadLines {
  std::vector<JournalLine> lines;
  std::int64_t whole_bytes = 0;  ///< up to the end of the last whole line
};

ReadLines lines_in(std::string_view content, const std::filesystem::path& file) {
  ReadLines read;
  for (std::size_t at = 0; at < content.size();) {
    const std::size_t end = content.find('\n', at);
    // A line without its end was never acknowledged: the erasure did not happen.
    if (end == std::string_view::npos) break;
    const auto line = line_in(content.substr(at, end - at));
    if (!line) {
      throw DatabaseError{DatabaseErrorKind::Damaged,
                          "line " + std::to_string(read.lines.size() + 1) + " of " + file.string() +
                              " was altered or damaged; put a whole copy of the journal there "
                              "(each folder of backups holds one)"};
    }
    read.lines.push_back(*line);
    at = end + 1;
    read.whole_bytes = static_cast<std::int64_t>(at);
  }
  return read;
}

std::string_view as_text(std::span<const std::byte> bytes) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes that are a text
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

std::filesystem::path journal_in(const std::filesystem::path& backups) {
  return backups / "erasures.jsonl";
}

std::vector<JournalLine> read_journal(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(std::filesystem::symlink_status(file, error))) return {};
  return lines_in(as_text(read_plain_file(file, journal_bytes_max)), file).lines;
}

void add_to_journal(const std::filesystem::path& file, std::span<const JournalLine> lines) {
  make_private_directory(file.parent_path());
  DurableFile journal = DurableFile::open_to_append(file);
  const std::vector<std::byte> content = read_plain_file(file, journal_bytes_max);
  const ReadLines known = lines_in(as_text(content), file);
  std::string added;
  for (const JournalLine& line : lines) {
    if (std::find(known.lines.begin(), known.lines.end(), line) == known.lines.end()) {
      added += text_of(line);
    }
  }
  journal.cut_to(known.whole_bytes);
  try {
    journal.write(std::as_bytes(std::span{added.data(), added.size()}));
    journal.sync();
  } catch (const DatabaseError&) {
    journal.cut_to(known.whole_bytes);
    throw;
  }
  sync_directory(file.parent_path());
}

}  // namespace hallux::database
