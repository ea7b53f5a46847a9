#include "database/content/cached_bytes.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "database/store/database_error.h"
#include "tests/database/some_database.h"

namespace hallux::database {
namespace {

namespace fs = std::filesystem;

std::vector<std::byte> some_bytes(std::size_t count, std::uint8_t step = 7) {
  std::vector<std::byte> bytes(count);
  for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<std::byte>((i * step) & 0xFFU);
  return bytes;
}

Digest key_of(std::uint8_t number) {
  Digest key;
  key.bytes.fill(number);
  return key;
}

TEST(CachedBytes, ComeBackAsTheyWereForTheSameKeyAlone) {
  const TemporaryDirectory temporary;
  store_cached(temporary.data(), "a-1.fields", key_of(1), some_bytes(100000));
  EXPECT_EQ(load_cached(temporary.data(), "a-1.fields", key_of(1)), some_bytes(100000));
  EXPECT_FALSE(load_cached(temporary.data(), "a-1.fields", key_of(2)));
  EXPECT_FALSE(load_cached(temporary.data(), "a-2.fields", key_of(1)));
  store_cached(temporary.data(), "a-1.fields", key_of(2), some_bytes(5));
  EXPECT_EQ(load_cached(temporary.data(), "a-1.fields", key_of(2)), some_bytes(5));
  store_cached(temporary.data(), "none", key_of(2), {});
  EXPECT_EQ(load_cached(temporary.data(), "none", key_of(2)), std::vector<std::byte>());
}

TEST(CachedBytes, ArePrivate) {
  const TemporaryDirectory temporary;
  store_cached(temporary.data(), "a", key_of(1), some_bytes(10));
  struct stat folder {
  }, file{};
  ASSERT_EQ(::stat((temporary.data() / "cache").c_str(), &folder), 0);
  ASSERT_EQ(::stat((temporary.data() / "cache/a").c_str(), &file), 0);
  EXPECT_EQ(folder.st_mode & 0777U, 0700U);
  EXPECT_EQ(file.st_mode & 0777U, 0600U);
}

TEST(CachedBytes, AreNothingWhereAByteDiffersOrIsMissing) {
  const TemporaryDirectory temporary;
  store_cached(temporary.data(), "a", key_of(1), some_bytes(3000, 31));
  const fs::path file = temporary.data() / "cache/a";
  const auto size = fs::file_size(file);
  for (std::uintmax_t at = 0; at < size; at += 13) {
    {
      std::fstream stream(file, std::ios::binary | std::ios::in | std::ios::out);
      stream.seekg(static_cast<std::streamoff>(at));
      const int byte = stream.get();
      stream.seekp(static_cast<std::streamoff>(at));
      stream.put(static_cast<char>(byte ^ 0x10));
    }
    const auto found = load_cached(temporary.data(), "a", key_of(1));
    EXPECT_TRUE(!found || *found == some_bytes(3000, 31)) << at;
    store_cached(temporary.data(), "a", key_of(1), some_bytes(3000, 31));
  }
  for (std::uintmax_t left = 0; left < size; left += 37) {
    fs::resize_file(file, left);
    EXPECT_FALSE(load_cached(temporary.data(), "a", key_of(1))) << left;
    store_cached(temporary.data(), "a", key_of(1), some_bytes(3000, 31));
  }
}

TEST(CachedBytes, TheOldestGoWhereThereAreTooMany) {
  const TemporaryDirectory temporary;
  const auto now = fs::file_time_type::clock::now();
  std::int64_t one = 0;
  for (int i = 0; i < 4; ++i) {
    const std::string name = "f" + std::to_string(i);
    store_cached(temporary.data(), name, key_of(1), some_bytes(4000, 113));
    one = static_cast<std::int64_t>(fs::file_size(temporary.data() / "cache" / name));
    fs::last_write_time(temporary.data() / "cache" / name, now - std::chrono::hours(10 - i));
  }
  store_cached(temporary.data(), "new", key_of(1), some_bytes(4000, 113), 3 * one);
  EXPECT_FALSE(load_cached(temporary.data(), "f0", key_of(1)));
  EXPECT_FALSE(load_cached(temporary.data(), "f1", key_of(1)));
  EXPECT_TRUE(load_cached(temporary.data(), "f2", key_of(1)));
  EXPECT_TRUE(load_cached(temporary.data(), "new", key_of(1)));
}

TEST(CachedBytes, AreDroppedWithTheirRecording) {
  const TemporaryDirectory temporary;
  store_cached(temporary.data(), "a", key_of(1), some_bytes(10));
  drop_cached(temporary.data(), "a");
  EXPECT_FALSE(load_cached(temporary.data(), "a", key_of(1)));
  drop_cached(temporary.data(), "a");
}

TEST(CachedBytes, WhereTheFolderCannotBeTheReasonIsSaid) {
  const TemporaryDirectory temporary;
  fs::create_directories(temporary.data());
  std::ofstream(temporary.data() / "cache") << "a file";
  EXPECT_THROW(store_cached(temporary.data(), "a", key_of(1), some_bytes(10)), DatabaseError);
  EXPECT_FALSE(load_cached(temporary.data(), "a", key_of(1)));
}

}  // namespace
}  // namespace hallux::database
