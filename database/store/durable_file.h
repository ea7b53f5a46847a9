/// Durable files, whole on the disk before the next step relies on them; untrusted files.
/// Inside this room only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "database/store/database_error.h"
#include "simulator/base/digest.h"

namespace hallux::database {

/// An open file; closed with its owner.
class DurableFile {
 public:
  /// A new one, 0600; one of that name is written anew.
  /// errors  DatabaseError, of all methods
  static DurableFile create(const std::filesystem::path& file);
  /// One to add to, 0600, made where it is missing; held by nobody else while it is open.
  static DurableFile open_to_append(const std::filesystem::path& file);
  /// errors  DatabaseError: NotFound; BadInput where it is a link, a directory or no plain file
  static DurableFile open_to_read(const std::filesystem::path& file);

  DurableFile(DurableFile&& other) noexcept;
  DurableFile& operator=(DurableFile&&) = delete;
  ~DurableFile();

  void write(std::span<const std::byte> bytes);
  /// How many bytes came: fewer than asked for at the end of the file only.
  std::size_t read(std::span<std::byte> bytes);
  std::int64_t bytes() const;
  /// Where the next read begins.
  void skip_to(std::int64_t bytes);
  void cut_to(std::int64_t bytes);
  /// Returns when the disk says that it holds what was written.
  void sync();

 private:
  DurableFile(std::filesystem::path file, int descriptor);
  std::filesystem::path file_;
  int descriptor_ = -1;
};

/// The name stands for the whole new content from now on; after a power cut once its directory was
/// synced.
void name_finished(const std::filesystem::path& finished, const std::filesystem::path& file);
/// The same, also after a power cut.
void put_in_place(const std::filesystem::path& finished, const std::filesystem::path& file);
/// The same without ever replacing anything: false where something has the name.
bool put_in_free_place(const std::filesystem::path& finished, const std::filesystem::path& file);
void sync_directory(const std::filesystem::path& directory);
void sync_file(const std::filesystem::path& file);
/// All that was written into the file system of that directory: for many files at once.
void sync_file_system(const std::filesystem::path& directory);

/// errors  DatabaseError: as open_to_read; BadInput where it is larger than `bytes_max`
std::vector<std::byte> read_plain_file(const std::filesystem::path& file, std::int64_t bytes_max);

struct DigestedFile {
  std::int64_t bytes = 0;
  Digest digest;
};

/// errors  DatabaseError: as open_to_read
DigestedFile digest_of_file(const std::filesystem::path& file);
/// Copies the bytes that are digested: who exchanges the file meanwhile changes nothing.
DigestedFile copy_digested(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace hallux::database
