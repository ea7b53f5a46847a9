/// Files of an export: private, digested while they are written, bounded while they are read.
/// Inside this corner only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "database/store/database_error.h"
#include "simulator/base/digest.h"

namespace hallux::database {

/// A file of an export, as its manifest names it.
struct ExchangeFile {
  /// Never a path: see is_exchange_name.
  std::string name;
  std::int64_t bytes = 0;
  Digest digest;
  friend bool operator==(const ExchangeFile&, const ExchangeFile&) = default;
};

/// One of the names that a folder of an export may hold: lower-case letters, digits and dashes with
/// one dot, no path.
bool is_exchange_name(std::string_view name) noexcept;

/// A descriptor that is closed with it.
class OwnedDescriptor {
 public:
  explicit OwnedDescriptor(int number) noexcept : number_(number) {}
  OwnedDescriptor(OwnedDescriptor&& other) noexcept;
  OwnedDescriptor& operator=(OwnedDescriptor&&) = delete;
  ~OwnedDescriptor();
  int number() const noexcept { return number_; }

 private:
  int number_;
};

/// A new file, mode 0600.
class ExchangeWriter {
 public:
  /// errors  DatabaseError: Full, ReadOnly, InputOutput, BadInput where the file is there already;
  ///         of the others as well
  ExchangeWriter(const std::filesystem::path& folder, std::string name);
  void write(std::string_view text);
  /// What was written, once it lies on the disk.
  ExchangeFile finish();

 private:
  void flush();

  std::filesystem::path file_;
  ExchangeFile written_;
  OwnedDescriptor descriptor_;
  Digester digester_;
  std::string waiting_;
};

/// A folder of others: no link in it is followed.
class ForeignFolder {
 public:
  /// errors  DatabaseError BadInput where it is no folder
  explicit ForeignFolder(std::filesystem::path folder);
  const std::filesystem::path& path() const noexcept { return folder_; }
  int descriptor() const noexcept { return descriptor_.number(); }
  bool has(const std::string& name) const noexcept;
  /// The whole file.
  /// errors  DatabaseError BadInput: missing, a link, no regular file, larger than the bound
  std::string read(const std::string& name, std::int64_t bytes_max) const;

 private:
  std::filesystem::path folder_;
  OwnedDescriptor descriptor_;
};

/// Reads a file of a foreign folder line by line and digests it meanwhile.
class ForeignLines {
 public:
  static constexpr std::size_t line_bytes_max = 1024;

  /// errors  DatabaseError BadInput as ForeignFolder::read; also where its size is not what
  ///         `expected` says. Of the others as well
  ForeignLines(const ForeignFolder& folder, const ExchangeFile& expected);
  /// The next line without its CR LF, valid until the next call; false after the last.
  /// errors  besides: longer than a line may be, not ended by CR LF, other bytes than `expected`
  ///         says
  bool next(std::string_view& line);
  /// "FILE, line N".
  std::string place() const;
  [[noreturn]] void refuse(std::string_view why) const;

 private:
  bool fill();

  std::filesystem::path file_;
  ExchangeFile expected_;
  std::int64_t bytes_on_disk_ = 0;
  OwnedDescriptor descriptor_;
  Digester digester_;
  std::vector<char> buffer_;
  std::size_t first_ = 0, last_ = 0;
  std::int64_t bytes_read_ = 0, line_number_ = 0;
};

}  // namespace hallux::database
