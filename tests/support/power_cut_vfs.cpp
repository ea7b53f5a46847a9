#include "tests/support/power_cut_vfs.h"

#include <sqlite3.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "simulator/base/random.h"

namespace hallux::tests {

namespace {

using Bytes = std::vector<std::uint8_t>;
using Change = PowerCutVfs::Change;

constexpr std::size_t written_at_once_bytes = 512;

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
  for (std::size_t at = 0; at < change.bytes.size(); at += written_at_once_bytes) {
    if (random.uniform() < 0.5) continue;
    const std::size_t count = std::min(written_at_once_bytes, change.bytes.size() - at);
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

}  // namespace

int PowerCutVfs::at_opening(const char* path, int flags) {
  const std::lock_guard lock{mutex_};
  if (*path != '\0' && !files_.contains(path)) files_[path].durable = content_of(path);
  return flags;
}

int PowerCutVfs::at_writing(const char* path, const void* bytes, int count, std::int64_t offset) {
  if (before_write) before_write();
  const auto* first = static_cast<const std::uint8_t*>(bytes);
  note(path, {offset, Bytes(first, first + count)});
  return SQLITE_OK;
}

void PowerCutVfs::at_truncating(const char* path, std::int64_t size) { note(path, {size, {}}); }

bool PowerCutVfs::at_syncing(const char* path) {
  if (before_write) before_write();
  const std::lock_guard lock{mutex_};
  File& file = files_[path];
  for (const Change& change : file.unsynced) apply(change, file.durable);
  file.unsynced.clear();
  // The real disk need not be waited for: this machine's power stays on.
  return false;
}

void PowerCutVfs::at_removing(const char* path) {
  const std::lock_guard lock{mutex_};
  files_.erase(path);
}

int PowerCutVfs::sector_bytes(int) const { return static_cast<int>(written_at_once_bytes); }
int PowerCutVfs::characteristics(int) const { return 0; }

void PowerCutVfs::note(const char* path, Change change) {
  const std::lock_guard lock{mutex_};
  files_[path].unsynced.push_back(std::move(change));
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
