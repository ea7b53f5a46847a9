/// A file is a head (magic, key, digest, length) and packed bytes. Whatever is wrong with it, it is
/// not there: the caller computes it again. It is written under the name of the process and
/// renamed, so that two windows never read half of one; the oldest go where the folder grows beyond
/// its bound.
#include "database/content/cached_bytes.h"

#include <unistd.h>
#include <zstd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string_view>
#include <system_error>

#include "database/store/files.h"
#include "simulator/base/check.h"

namespace hallux::database {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view file_magic = "HALLUXK1";
constexpr int zstd_level = 3;
/// No attempt's fields are larger, and no file may make us take more memory than that.
constexpr std::uint64_t plain_bytes_max = std::uint64_t{1} << 29U;

/// What stands before the packed bytes.
struct Head {
  std::array<char, file_magic.size()> magic{};
  Digest key, content;
  std::uint64_t plain_bytes = 0;
};

fs::path folder_of(const fs::path& data_directory) { return data_directory / "cache"; }

bool is_name(const std::string& name) {
  return !name.empty() && name.front() != '.' && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
           c == '-';
  });
}

std::vector<std::byte> packed(std::span<const std::byte> bytes) {
  std::vector<std::byte> result(ZSTD_compressBound(bytes.size()));
  const std::size_t used =
      ZSTD_compress(result.data(), result.size(), bytes.data(), bytes.size(), zstd_level);
  CHECK(ZSTD_isError(used) == 0);
  result.resize(used);
  return result;
}

std::vector<std::byte> content_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream) return {};
  const std::streamoff size = stream.tellg();
  if (size < 0 || static_cast<std::uint64_t>(size) > plain_bytes_max) return {};
  std::vector<std::byte> bytes(static_cast<std::size_t>(size));
  stream.seekg(0);
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): a stream reads chars
  stream.read(reinterpret_cast<char*>(bytes.data()), size);
  if (!stream) return {};
  return bytes;
}

void write_file(const fs::path& file, const Head& head, std::span<const std::byte> bytes) {
  make_private_file(file);
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  // NOLINTBEGIN(cppcoreguidelines-pro-type-reinterpret-cast): a stream writes chars
  stream.write(reinterpret_cast<const char*>(&head), sizeof(head));
  stream.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  // NOLINTEND(cppcoreguidelines-pro-type-reinterpret-cast)
  stream.close();
  if (stream) return;
  const int error_number = errno == 0 ? EIO : errno;
  std::error_code ignored;
  fs::remove(file, ignored);
  throw file_error(file, "keep", error_number);
}

struct KeptFile {
  fs::path file;
  fs::file_time_type written;
  std::int64_t bytes = 0;
};

/// Another process may remove a file meanwhile: what is not there needs no removing.
void remove_oldest(const fs::path& folder, std::int64_t bytes_max) {
  std::vector<KeptFile> files;
  std::int64_t total = 0;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const auto bytes = static_cast<std::int64_t>(entry.file_size(error));
    if (error) continue;
    files.push_back({entry.path(), entry.last_write_time(error), bytes});
    total += bytes;
  }
  std::sort(files.begin(), files.end(),
            [](const KeptFile& a, const KeptFile& b) { return a.written < b.written; });
  for (const KeptFile& kept : files) {
    if (total <= bytes_max) return;
    fs::remove(kept.file, error);
    total -= kept.bytes;
  }
}

}  // namespace

std::optional<std::vector<std::byte>> load_cached(const fs::path& data_directory,
                                                  const std::string& name, const Digest& key) {
  CHECK(is_name(name));
  const std::vector<std::byte> content = content_of(folder_of(data_directory) / name);
  Head head;
  if (content.size() < sizeof(head)) return std::nullopt;
  std::memcpy(&head, content.data(), sizeof(head));
  const bool is_ours = std::string_view(head.magic.data(), head.magic.size()) == file_magic &&
                       head.key == key && head.plain_bytes <= plain_bytes_max;
  if (!is_ours) return std::nullopt;
  std::vector<std::byte> bytes(head.plain_bytes);
  const std::size_t used = ZSTD_decompress(
      bytes.data(), bytes.size(), content.data() + sizeof(head), content.size() - sizeof(head));
  if (ZSTD_isError(used) != 0 || used != bytes.size() || digest_of(bytes) != head.content)
    return std::nullopt;
  return bytes;
}

void store_cached(const fs::path& data_directory, const std::string& name, const Digest& key,
                  std::span<const std::byte> bytes, std::int64_t bytes_max) {
  CHECK(is_name(name) && bytes.size() <= plain_bytes_max);
  const fs::path folder = folder_of(data_directory);
  make_private_directory(folder);
  Head head{{}, key, digest_of(bytes), bytes.size()};
  std::copy(file_magic.begin(), file_magic.end(), head.magic.begin());
  const fs::path file = folder / name;
  const fs::path unfinished = file.string() + "." + std::to_string(::getpid()) + ".part";
  write_file(unfinished, head, packed(bytes));
  std::error_code error;
  fs::rename(unfinished, file, error);
  if (error) throw file_error(file, "keep", error.value());
  remove_oldest(folder, bytes_max);
}

void drop_cached(const fs::path& data_directory, const std::string& name) {
  CHECK(is_name(name));
  std::error_code error;
  const fs::path file = folder_of(data_directory) / name;
  fs::remove(file, error);
  if (error) throw file_error(file, "remove", error.value());
}

}  // namespace hallux::database
