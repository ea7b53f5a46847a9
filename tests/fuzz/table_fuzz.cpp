/// Feeds any bytes to the reader of an exported record: the first byte says which of the three
/// tables the rest is, the other two have no rows. It must throw DatabaseError, or give rows that
/// are written as the same bytes again.
#include <stdlib.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "database/exchange/record_tables.h"
#include "simulator/base/check.h"
#include "tests/fuzz/text_fuzz.h"

namespace {

namespace fs = std::filesystem;
using namespace hallux::database;

/// A folder in memory with three tables without rows; gone at the end.
class Place {
 public:
  Place() {
    std::string name = (fs::exists("/dev/shm") ? "/dev/shm" : fs::temp_directory_path().string()) +
                       "/hallux-fuzz-XXXXXX";
    CHECK(::mkdtemp(name.data()) != nullptr);
    folder_ = name;
    empty_ = write_record_tables(folder_, {}, {});
    fs::create_directory(folder_ / "again");
    for (const ExchangeFile& file : empty_) {
      std::ifstream in(folder_ / file.name, std::ios::binary);
      texts_.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    }
  }
  ~Place() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;

  const fs::path& folder() const { return folder_; }
  fs::path again() const { return folder_ / "again"; }
  const std::vector<ExchangeFile>& empty() const { return empty_; }
  void write(std::size_t table, std::string_view text) const {
    std::ofstream(folder_ / empty_[table].name, std::ios::binary | std::ios::trunc) << text;
  }
  void write_empty(std::size_t table) const { write(table, texts_[table]); }

 private:
  fs::path folder_;
  std::vector<ExchangeFile> empty_;
  std::vector<std::string> texts_;
};

void expect_the_same(const Place& place, const ReadTables& read,
                     const std::vector<ExchangeFile>& files) {
  for (const ExchangeFile& file : files) fs::remove(place.again() / file.name);
  CHECK(write_record_tables(place.again(), read.recording, read.places) == files);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const Place place;
  if (size == 0) return 0;
  const std::size_t table = bytes[0] % record_table_names.size();
  const std::string_view text = hallux::tests::text_of(bytes + 1, size - 1);
  std::vector<ExchangeFile> files = place.empty();
  files[table].bytes = static_cast<std::int64_t>(text.size());
  files[table].digest = hallux::digest_of(std::as_bytes(std::span{text.data(), text.size()}));
  place.write(table, text);
  try {
    expect_the_same(place, read_record_tables(ForeignFolder(place.folder()), files), files);
  } catch (const DatabaseError&) {
  }
  place.write_empty(table);
  return 0;
}
