/// The file is written once and never again, so that a hundred backups share it: each later one
/// only looks at head, length and digest. It comes back into tables that know the attempt and none
/// of its chunks, from bytes that are a stranger's until their digest is the manifest's.
#include "database/maintenance/recording_file.h"

#include <array>
#include <string_view>

#include "database/recording/display_facts.h"
#include "database/store/durable_file.h"
#include "database/store/sql.h"

namespace hallux::database {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view file_magic = "HALLUXR2", magic_without_facts = "HALLUXR1";
static_assert(file_magic.size() == magic_without_facts.size());
constexpr std::size_t uuid_bytes = 36, digest_bytes = 32;
/// Twelve hours of a hand are 500 MB.
constexpr std::int64_t file_bytes_max = std::int64_t{1} << 30U;
/// What a backup that is stopped has to write once more is at most this.
constexpr std::int64_t unnamed_bytes_max = std::int64_t{64} << 20U;

fs::path recording_folder(const fs::path& backups) { return backups / "recordings"; }
fs::path unnamed(const fs::path& file) { return file.string() + ".part"; }

struct KeptChunk {
  std::int64_t seq = 0, stream = 0, first_tick = 0, row_count = 0;
  std::span<const std::byte> bytes, link;
};

void append(std::vector<std::byte>& file, std::span<const std::byte> bytes) {
  file.insert(file.end(), bytes.begin(), bytes.end());
}

void append_text(std::vector<std::byte>& file, std::string_view text) {
  append(file, std::as_bytes(std::span{text.data(), text.size()}));
}

void append_int(std::vector<std::byte>& file, std::int64_t value) {
  for (unsigned shift = 0; shift < 64; shift += 8) {
    file.push_back(static_cast<std::byte>((static_cast<std::uint64_t>(value) >> shift) & 0xFFU));
  }
}

std::span<const std::byte> blob_in(const SQLite::Column& column) {
  return {static_cast<const std::byte*>(column.getBlob()),
          static_cast<std::size_t>(column.getBytes())};
}

void append_facts(std::vector<std::byte>& file, std::span<const simulator::DisplayFact> facts) {
  append_int(file, static_cast<std::int64_t>(facts.size()));
  for (const simulator::DisplayFact& fact : facts) {
    for (const std::int64_t column : columns_of(fact)) append_int(file, column);
  }
}

std::vector<std::byte> content_from(Database& database, const AttemptId& attempt) {
  return translating(database, "read the recording of attempt " + attempt.text, [&] {
    auto rows =
        prepared(database,
                 "SELECT c.seq, c.stream, c.first_tick, c.row_count, c.bytes, c.link FROM chunk c "
                 "JOIN attempt a USING (attempt_id) WHERE a.uuid = ? ORDER BY c.seq, c.stream",
                 attempt.text);
    std::vector<std::byte> chunks;
    std::int64_t count = 0;
    for (; rows.executeStep(); ++count) {
      for (int column = 0; column < 4; ++column) append_int(chunks, rows.getColumn(column));
      const std::span<const std::byte> bytes = blob_in(rows.getColumn(4));
      append_int(chunks, static_cast<std::int64_t>(bytes.size()));
      append(chunks, bytes);
      append(chunks, blob_in(rows.getColumn(5)));
    }
    std::vector<std::byte> file;
    append_text(file, file_magic);
    append_text(file, attempt.text);
    append_int(file, count);
    append(file, chunks);
    append_facts(file, load_display_facts(database, attempt));
    return file;
  });
}

/// Never beyond the end, whatever the file claims.
class Reader {
 public:
  Reader(std::span<const std::byte> rest, const fs::path& file) : rest_(rest), file_(file) {}

  std::span<const std::byte> take(std::size_t bytes) {
    if (bytes > rest_.size()) fail_backup(file_, "it ends too early");
    const auto taken = rest_.first(bytes);
    rest_ = rest_.subspan(bytes);
    return taken;
  }

  std::int64_t take_int() {
    std::uint64_t value = 0;
    unsigned shift = 0;
    for (const std::byte byte : take(8)) {
      value |= std::to_integer<std::uint64_t>(byte) << shift;
      shift += 8;
    }
    return static_cast<std::int64_t>(value);
  }

  bool takes(std::string_view text) { return is_text(take(text.size()), text); }

  /// Whether the file says that it is a recording; if so, whether display facts stand in it.
  bool takes_magic() {
    const auto magic = take(file_magic.size());
    has_facts_ = is_text(magic, file_magic);
    return has_facts_ || is_text(magic, magic_without_facts);
  }

  KeptChunk take_chunk() {
    KeptChunk chunk;
    chunk.seq = take_int();
    chunk.stream = take_int();
    chunk.first_tick = take_int();
    chunk.row_count = take_int();
    const std::int64_t length = take_int();
    if (length < 0) fail_backup(file_, "a chunk has a length below zero");
    chunk.bytes = take(static_cast<std::size_t>(length));
    chunk.link = take(digest_bytes);
    return chunk;
  }

  /// After the chunks.
  std::vector<simulator::DisplayFact> take_facts() {
    std::vector<simulator::DisplayFact> facts;
    if (!has_facts_) return facts;
    const std::int64_t count = take_int();
    for (std::int64_t i = 0; i < count; ++i) {
      std::array<std::int64_t, simulator::display_columns> columns{};
      for (std::int64_t& column : columns) column = take_int();
      facts.push_back(simulator::display_fact_from(columns));
    }
    return facts;
  }

  bool is_at_end() const noexcept { return rest_.empty(); }

 private:
  static bool is_text(std::span<const std::byte> bytes, std::string_view text) {
    return std::equal(bytes.begin(), bytes.end(), text.begin(), text.end(),
                      [](std::byte a, char b) { return a == static_cast<std::byte>(b); });
  }

  std::span<const std::byte> rest_;
  const fs::path& file_;
  bool has_facts_ = false;
};

Digest digest_from(std::span<const std::byte> bytes) {
  Digest digest;
  for (std::size_t i = 0; i < digest.bytes.size(); ++i) {
    digest.bytes[i] = std::to_integer<std::uint8_t>(bytes[i]);
  }
  return digest;
}

/// What a file that is there says of itself; a backup does not read all of it again.
BackedUpRecording found_file(const fs::path& file, const AttemptId& attempt) {
  DurableFile found = DurableFile::open_to_read(file);
  std::array<std::byte, file_magic.size() + uuid_bytes> head{};
  const std::int64_t bytes = found.bytes();
  Reader reader{{head.data(), found.read(head)}, file};
  if (bytes < static_cast<std::int64_t>(head.size() + digest_bytes) || !reader.takes_magic() ||
      !reader.takes(attempt.text)) {
    throw DatabaseError{DatabaseErrorKind::BadInput,
                        file.string() + " is not the recording of attempt " + attempt.text +
                            "; move it away, the next backup writes it anew"};
  }
  std::array<std::byte, digest_bytes> tail{};
  found.skip_to(bytes - static_cast<std::int64_t>(digest_bytes));
  found.read(tail);
  return {attempt, bytes, digest_from(tail)};
}

void insert_chunk(Database& database, std::int64_t attempt, const KeptChunk& chunk) {
  execute(database,
          "INSERT INTO chunk (attempt_id, seq, stream, first_tick, row_count, "
          "bytes, link) VALUES (?, ?, ?, ?, ?, ?, ?)",
          attempt, chunk.seq, chunk.stream, chunk.first_tick, chunk.row_count, chunk.bytes,
          chunk.link);
}

std::int64_t attempt_without_chunks(Database& database, const AttemptId& attempt,
                                    const fs::path& file) {
  auto row = prepared(database,
                      "SELECT attempt_id, seal IS NOT NULL AND NOT EXISTS (SELECT 1 FROM chunk c "
                      "WHERE c.attempt_id = a.attempt_id) FROM attempt a WHERE uuid = ?",
                      attempt.text);
  if (!row.executeStep() || row.getColumn(1).getInt() == 0) {
    fail_backup(file, "the backup has no closed attempt that lacks it");
  }
  return row.getColumn(0).getInt64();
}

}  // namespace

void fail_backup(const fs::path& file, const char* reason) {
  throw DatabaseError{DatabaseErrorKind::Damaged, file.string() + " was altered or damaged: " +
                                                      reason + "; take an older backup"};
}

fs::path recording_file(const fs::path& backups, const AttemptId& attempt) {
  return recording_folder(backups) / (attempt.text + ".recording");
}

BackedUpRecording NewRecordingFiles::add(Database& database, const AttemptId& attempt) {
  const fs::path file = recording_file(backups_, attempt);
  std::error_code error;
  if (fs::exists(fs::symlink_status(file, error))) return found_file(file, attempt);
  std::vector<std::byte> content = content_from(database, attempt);
  const Digest digest = digest_of(content);
  append(content, std::as_bytes(std::span{digest.bytes}));
  DurableFile::create(unnamed(file)).write(content);
  unnamed_.push_back(file);
  unnamed_bytes_ += static_cast<std::int64_t>(content.size());
  if (unnamed_bytes_ >= unnamed_bytes_max) put_in_place();
  return {attempt, static_cast<std::int64_t>(content.size()), digest};
}

void NewRecordingFiles::put_in_place() {
  if (unnamed_.empty()) return;
  sync_file_system(backups_);
  for (const fs::path& file : unnamed_) name_finished(unnamed(file), file);
  sync_directory(recording_folder(backups_));
  unnamed_.clear();
  unnamed_bytes_ = 0;
}

void put_recording_back(Database& database, const BackedUpRecording& kept,
                        const fs::path& backups) {
  const fs::path file = recording_file(backups, kept.attempt);
  const std::vector<std::byte> content = read_plain_file(file, file_bytes_max);
  if (static_cast<std::int64_t>(content.size()) != kept.bytes || content.size() < digest_bytes) {
    fail_backup(file, "it has another size than the manifest says");
  }
  const auto body = std::span{content}.first(content.size() - digest_bytes);
  const Digest digest = digest_of(body);
  if (digest != kept.digest || digest != digest_from(std::span{content}.last(digest_bytes))) {
    fail_backup(file, "its bytes do not give the digest that the manifest says");
  }
  Reader reader{body, file};
  if (!reader.takes_magic() || !reader.takes(kept.attempt.text)) {
    fail_backup(file, "it is the recording of another attempt");
  }
  const std::int64_t count = reader.take_int();
  in_transaction(database, "put back the recording of attempt " + kept.attempt.text, [&] {
    const std::int64_t attempt = attempt_without_chunks(database, kept.attempt, file);
    for (std::int64_t i = 0; i < count; ++i) insert_chunk(database, attempt, reader.take_chunk());
    store_display_facts(database, attempt, reader.take_facts());
    if (!reader.is_at_end()) fail_backup(file, "it has more bytes than chunks");
  });
}

}  // namespace hallux::database
