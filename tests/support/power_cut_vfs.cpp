#include "tests/support/power_cut_vfs.h"

#include <sqlite3.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <new>

#include "simulator/base/random.h"

namespace hallux::tests {

namespace {

using Bytes = std::vector<std::uint8_t>;
using Change = PowerCutVfs::Change;

constexpr std::size_t sector_bytes = 512;

/// SQLite gives room for this and, right behind it, for the real file.
struct ShimFile {
  sqlite3_file base;
  PowerCutVfs* vfs;
  const char* path;  ///< SQLite keeps it for as long as the file is open
};

ShimFile* shim_of(sqlite3_file* file) { return reinterpret_cast<ShimFile*>(file); }
sqlite3_file* real_of(sqlite3_file* file) {
  return reinterpret_cast<sqlite3_file*>(shim_of(file) + 1);
}

void apply(const Change& change, Bytes& content) {
  const auto offset = static_cast<std::size_t>(change.offset);
  if (change.bytes.empty()) {
    content.resize(std::min(content.size(), offset));
    return;
  }
  content.resize(std::max(content.size(), offset + change.bytes.size()));
  std::copy(change.bytes.begin(), change.bytes.end(),
            content.begin() + static_cast<std::ptrdiff_t>(offset));
}

/// Some of its sectors, each as it is or not at all.
void apply_torn(const Change& change, Random& random, Bytes& content) {
  for (std::size_t at = 0; at < change.bytes.size(); at += sector_bytes) {
    if (random.uniform() < 0.5) continue;
    const std::size_t count = std::min(sector_bytes, change.bytes.size() - at);
    const auto first = change.bytes.begin() + static_cast<std::ptrdiff_t>(at);
    apply({change.offset + static_cast<std::int64_t>(at),
           Bytes(first, first + static_cast<std::ptrdiff_t>(count))},
          content);
  }
}

Bytes content_of(const std::string& path) {
  std::ifstream file{path, std::ios::binary};
  return {std::istreambuf_iterator<char>{file}, {}};
}

int close_file(sqlite3_file* file) { return real_of(file)->pMethods->xClose(real_of(file)); }
int read_file(sqlite3_file* file, void* bytes, int count, sqlite3_int64 offset) {
  return real_of(file)->pMethods->xRead(real_of(file), bytes, count, offset);
}
int write_file(sqlite3_file* file, const void* bytes, int count, sqlite3_int64 offset) {
  ShimFile* shim = shim_of(file);
  if (shim->vfs->before_write) shim->vfs->before_write();
  const auto* first = static_cast<const std::uint8_t*>(bytes);
  shim->vfs->note(shim->path, {offset, Bytes(first, first + count)});
  return real_of(file)->pMethods->xWrite(real_of(file), bytes, count, offset);
}
int truncate_file(sqlite3_file* file, sqlite3_int64 size) {
  shim_of(file)->vfs->note(shim_of(file)->path, {size, {}});
  return real_of(file)->pMethods->xTruncate(real_of(file), size);
}
int sync_file(sqlite3_file* file, int) {
  ShimFile* shim = shim_of(file);
  if (shim->vfs->before_write) shim->vfs->before_write();
  // The real disk need not be waited for: this machine's power stays on.
  shim->vfs->note_sync(shim->path);
  return SQLITE_OK;
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
int sector_size(sqlite3_file*) { return static_cast<int>(sector_bytes); }
/// Nothing is promised: no atomic write, no order of appends, no sector that survives beside a written one.
int characteristics(sqlite3_file*) { return 0; }
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
  auto* power = static_cast<PowerCutVfs*>(vfs->pAppData);
  auto* shim = shim_of(file);
  shim->base.pMethods = nullptr;
  shim->vfs = power;
  shim->path = name == nullptr ? "" : name;
  if (name != nullptr) power->know(name);
  const int answer = power->real()->xOpen(power->real(), name, real_of(file), flags, flags_out);
  if (answer == SQLITE_OK) shim->base.pMethods = &methods;
  return answer;
}

int delete_file(sqlite3_vfs* vfs, const char* name, int sync) {
  auto* power = static_cast<PowerCutVfs*>(vfs->pAppData);
  power->note_removal(name);
  return power->real()->xDelete(power->real(), name, sync);
}
int access_file(sqlite3_vfs* vfs, const char* name, int flags, int* answer) {
  auto* real = static_cast<PowerCutVfs*>(vfs->pAppData)->real();
  return real->xAccess(real, name, flags, answer);
}
int full_path(sqlite3_vfs* vfs, const char* name, int size, char* path) {
  auto* real = static_cast<PowerCutVfs*>(vfs->pAppData)->real();
  return real->xFullPathname(real, name, size, path);
}

}  // namespace

PowerCutVfs::PowerCutVfs(std::string name)
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

PowerCutVfs::~PowerCutVfs() { sqlite3_vfs_unregister(shim_.get()); }

void PowerCutVfs::know(const std::string& path) {
  const std::lock_guard lock{mutex_};
  if (!files_.contains(path)) files_[path].durable = content_of(path);
}

void PowerCutVfs::note(const std::string& path, Change change) {
  const std::lock_guard lock{mutex_};
  files_[path].unsynced.push_back(std::move(change));
}

void PowerCutVfs::note_sync(const std::string& path) {
  const std::lock_guard lock{mutex_};
  File& file = files_[path];
  for (const Change& change : file.unsynced) apply(change, file.durable);
  file.unsynced.clear();
}

void PowerCutVfs::note_removal(const std::string& path) {
  const std::lock_guard lock{mutex_};
  files_.erase(path);
}

void PowerCutVfs::leave_after_power_cut(const std::filesystem::path& directory,
                                        std::uint64_t seed) {
  const std::lock_guard lock{mutex_};
  Random random{seed};
  for (const auto& [path, file] : files_) {
    Bytes content = file.durable;
    for (const Change& change : file.unsynced) {
      const double chance = random.uniform();
      if (chance < 0.4) apply(change, content);
      if (chance >= 0.8) apply_torn(change, random, content);
    }
    std::ofstream left{directory / std::filesystem::path(path).filename(), std::ios::binary};
    left.write(reinterpret_cast<const char*>(content.data()),
               static_cast<std::streamsize>(content.size()));
  }
}

}  // namespace hallux::tests
