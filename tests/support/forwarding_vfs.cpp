#include "tests/support/forwarding_vfs.h"

#include <sqlite3.h>

#include <new>

namespace hallux::tests {

namespace {

/// SQLite gives room for this and, right behind it, for the real file.
struct ShimFile {
  sqlite3_file base;
  ForwardingVfs* vfs;
  /// SQLite keeps it for as long as the file is open.
  const char* path;
};

ShimFile* shim_of(sqlite3_file* file) { return reinterpret_cast<ShimFile*>(file); }
sqlite3_file* real_of(sqlite3_file* file) {
  return reinterpret_cast<sqlite3_file*>(shim_of(file) + 1);
}

int close_file(sqlite3_file* file) { return real_of(file)->pMethods->xClose(real_of(file)); }
int read_file(sqlite3_file* file, void* bytes, int count, sqlite3_int64 offset) {
  return real_of(file)->pMethods->xRead(real_of(file), bytes, count, offset);
}
int write_file(sqlite3_file* file, const void* bytes, int count, sqlite3_int64 offset) {
  const int answer = shim_of(file)->vfs->at_writing(shim_of(file)->path, bytes, count, offset);
  if (answer != SQLITE_OK) return answer;
  return real_of(file)->pMethods->xWrite(real_of(file), bytes, count, offset);
}
int truncate_file(sqlite3_file* file, sqlite3_int64 size) {
  shim_of(file)->vfs->at_truncating(shim_of(file)->path, size);
  return real_of(file)->pMethods->xTruncate(real_of(file), size);
}
int sync_file(sqlite3_file* file, int flags) {
  if (!shim_of(file)->vfs->at_syncing(shim_of(file)->path)) return SQLITE_OK;
  return real_of(file)->pMethods->xSync(real_of(file), flags);
}
int size_of_file(sqlite3_file* file, sqlite3_int64* size) {
  return real_of(file)->pMethods->xFileSize(real_of(file), size);
}
int lock_file(sqlite3_file* file, int lock) {
  return real_of(file)->pMethods->xLock(real_of(file), lock);
}
int unlock_file(sqlite3_file* file, int lock) {
  return real_of(file)->pMethods->xUnlock(real_of(file), lock);
}
int check_lock(sqlite3_file* file, int* answer) {
  return real_of(file)->pMethods->xCheckReservedLock(real_of(file), answer);
}
int control_file(sqlite3_file* file, int operation, void* argument) {
  return real_of(file)->pMethods->xFileControl(real_of(file), operation, argument);
}
int sector_size(sqlite3_file* file) {
  return shim_of(file)->vfs->sector_bytes(real_of(file)->pMethods->xSectorSize(real_of(file)));
}
int characteristics(sqlite3_file* file) {
  return shim_of(file)->vfs->characteristics(
      real_of(file)->pMethods->xDeviceCharacteristics(real_of(file)));
}
int map_shared(sqlite3_file* file, int region, int size, int extend, void volatile** memory) {
  return real_of(file)->pMethods->xShmMap(real_of(file), region, size, extend, memory);
}
int lock_shared(sqlite3_file* file, int offset, int count, int flags) {
  return real_of(file)->pMethods->xShmLock(real_of(file), offset, count, flags);
}
void fence_shared(sqlite3_file* file) { real_of(file)->pMethods->xShmBarrier(real_of(file)); }
int unmap_shared(sqlite3_file* file, int remove) {
  return real_of(file)->pMethods->xShmUnmap(real_of(file), remove);
}

/// Version 2: with shared memory for WAL, without memory mapping, which would go round the shim.
constexpr sqlite3_io_methods methods{2,
                                     close_file,
                                     read_file,
                                     write_file,
                                     truncate_file,
                                     sync_file,
                                     size_of_file,
                                     lock_file,
                                     unlock_file,
                                     check_lock,
                                     control_file,
                                     sector_size,
                                     characteristics,
                                     map_shared,
                                     lock_shared,
                                     fence_shared,
                                     unmap_shared,
                                     nullptr,
                                     nullptr};

int open_file(sqlite3_vfs* vfs, const char* name, sqlite3_file* file, int flags, int* flags_out) {
  auto* forwarding = static_cast<ForwardingVfs*>(vfs->pAppData);
  ShimFile* shim = shim_of(file);
  shim->base.pMethods = nullptr;
  shim->vfs = forwarding;
  shim->path = name == nullptr ? "" : name;
  flags = forwarding->at_opening(shim->path, flags);
  sqlite3_vfs* real = forwarding->real();
  const int answer = real->xOpen(real, name, real_of(file), flags, flags_out);
  if (answer == SQLITE_OK) shim->base.pMethods = &methods;
  return answer;
}

int delete_file(sqlite3_vfs* vfs, const char* name, int sync) {
  auto* forwarding = static_cast<ForwardingVfs*>(vfs->pAppData);
  forwarding->at_removing(name);
  return forwarding->real()->xDelete(forwarding->real(), name, sync);
}
int access_file(sqlite3_vfs* vfs, const char* name, int flags, int* answer) {
  auto* real = static_cast<ForwardingVfs*>(vfs->pAppData)->real();
  return real->xAccess(real, name, flags, answer);
}
int full_path(sqlite3_vfs* vfs, const char* name, int size, char* path) {
  auto* real = static_cast<ForwardingVfs*>(vfs->pAppData)->real();
  return real->xFullPathname(real, name, size, path);
}

}  // namespace

ForwardingVfs::ForwardingVfs(std::string name)
    : name_(std::move(name)),
      real_(sqlite3_vfs_find(nullptr)),
      shim_(std::make_unique<sqlite3_vfs>(*real_)) {
  shim_->szOsFile = static_cast<int>(sizeof(ShimFile)) + real_->szOsFile;
  shim_->pNext = nullptr;
  shim_->zName = name_.c_str();
  shim_->pAppData = this;
  shim_->xOpen = open_file;
  shim_->xDelete = delete_file;
  shim_->xAccess = access_file;
  shim_->xFullPathname = full_path;
  if (sqlite3_vfs_register(shim_.get(), 0) != SQLITE_OK) throw std::bad_alloc{};
}

ForwardingVfs::~ForwardingVfs() { sqlite3_vfs_unregister(shim_.get()); }

int ForwardingVfs::at_opening(const char*, int flags) { return flags; }
int ForwardingVfs::at_writing(const char*, const void*, int, std::int64_t) { return SQLITE_OK; }
void ForwardingVfs::at_truncating(const char*, std::int64_t) {}
bool ForwardingVfs::at_syncing(const char*) { return true; }
void ForwardingVfs::at_removing(const char*) {}
int ForwardingVfs::sector_bytes(int real) const { return real; }
int ForwardingVfs::characteristics(int real) const { return real; }

}  // namespace hallux::tests
