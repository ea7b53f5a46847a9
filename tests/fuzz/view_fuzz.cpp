/// Feeds any bytes to the reader of an exported table of what was on the screen. It must throw
/// DatabaseError, or give views that are written as the same bytes again.
#include <stdlib.h>

#include <filesystem>
#include <fstream>

#include "database/exchange/view_table.h"
#include "simulator/base/check.h"
#include "tests/fuzz/text_fuzz.h"

namespace {

namespace fs = std::filesystem;
using namespace hallux::database;

/// A folder in memory; gone at the end.
class Place {
 public:
  Place() {
    std::string name = (fs::exists("/dev/shm") ? "/dev/shm" : fs::temp_directory_path().string()) +
                       "/hallux-fuzz-XXXXXX";
    CHECK(::mkdtemp(name.data()) != nullptr);
    folder_ = name;
    fs::create_directory(folder_ / "again");
  }
  ~Place() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;

  const fs::path& folder() const { return folder_; }
  fs::path again() const { return folder_ / "again"; }

 private:
  fs::path folder_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const Place place;
  const std::string_view text = hallux::tests::text_of(bytes, size);
  const ExchangeFile file{view_table_name, static_cast<std::int64_t>(text.size()),
                          hallux::digest_of(std::as_bytes(std::span{text.data(), text.size()}))};
  std::ofstream(place.folder() / file.name, std::ios::binary | std::ios::trunc) << text;
  try {
    const auto facts = read_view_table(ForeignFolder(place.folder()), {file});
    for (const hallux::simulator::DisplayFact& fact : facts) {
      CHECK(is_view(fact));
      CHECK(fact_of(shown_view_of(fact), fact.tick).has_value());
    }
    fs::remove(place.again() / file.name);
    CHECK(write_view_table(place.again(), facts) == file);
  } catch (const DatabaseError&) {
  }
  return 0;
}
