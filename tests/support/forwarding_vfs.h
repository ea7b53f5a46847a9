/// A file system for SQLite that passes everything on to the default one, with places to step in.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

struct sqlite3_vfs;

namespace hallux::tests {

/// Registered with SQLite under its own name for as long as it lives. What derives from it
/// overrides what it steps into.
class ForwardingVfs {
 public:
  /// needs   no other of that name lives; every connection through it is closed before it goes
  explicit ForwardingVfs(std::string name);
  virtual ~ForwardingVfs();
  ForwardingVfs(const ForwardingVfs&) = delete;
  ForwardingVfs& operator=(const ForwardingVfs&) = delete;

  const std::string& name() const noexcept { return name_; }

  // -- Called by SQLite, on the thread of the connection; a path is "" for a file without a name.
  /// The flags that a file is opened with where `flags` were asked for.
  virtual int at_opening(const char* path, int flags);
  /// SQLITE_OK to write; anything else is answered instead.
  virtual int at_writing(const char* path, const void* bytes, int count, std::int64_t offset);
  virtual void at_truncating(const char* path, std::int64_t size);
  /// Whether the real file is synced.
  virtual bool at_syncing(const char* path);
  virtual void at_removing(const char* path);
  /// What is said of the disk where the default one says `real`.
  virtual int sector_bytes(int real) const;
  virtual int characteristics(int real) const;

  sqlite3_vfs* real() const noexcept { return real_; }

 private:
  std::string name_;
  sqlite3_vfs* real_ = nullptr;
  std::unique_ptr<sqlite3_vfs> shim_;
};

}  // namespace hallux::tests
