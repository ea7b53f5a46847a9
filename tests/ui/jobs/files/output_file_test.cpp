#include "ui/jobs/files/output_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <functional>
#include <iterator>

#include "database/store/database_error.h"
#include "ui/jobs/files/output_error.h"

namespace hallux::ui {
namespace {

namespace fs = std::filesystem;

constexpr OutputKind letters{"a letter", "Dear ", true};

class OutputFile : public testing::Test {
 protected:
  OutputFile() {
    std::string name = (fs::temp_directory_path() / "hallux-output-XXXXXX").string();
    folder_ = mkdtemp(name.data());
    fs::create_directory(data());
    write(data() / "hallux.db", "kept");
  }
  ~OutputFile() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  static void write(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }
  static std::string read(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  static unsigned mode_of(const fs::path& file) {
    struct stat facts {};
    EXPECT_EQ(::stat(file.c_str(), &facts), 0);
    return facts.st_mode & 0777U;
  }
  fs::path data() const { return folder_ / "data"; }
  void put(const fs::path& file, const OutputKind& kind = letters) const {
    write_output(file, "Dear Anna", kind, data());
  }
  template <typename Error>
  void expect_refused(const fs::path& file) const {
    const std::string before = read(file);
    EXPECT_THROW(put(file), Error) << file;
    EXPECT_EQ(read(file), before);
  }
  fs::path folder_;
};

TEST_F(OutputFile, IsNewOrReplacesOneOfItsKind) {
  const fs::path file = folder_ / "letter.txt";
  put(file);
  EXPECT_EQ(read(file), "Dear Anna");
  write(file, "Dear Ben");
  put(file);
  EXPECT_EQ(read(file), "Dear Anna");
  write(file, "");  // as mktemp makes it
  put(file);
  EXPECT_EQ(read(file), "Dear Anna");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 2) << "nothing is left beside it";
}

TEST_F(OutputFile, IsItsOwnersWhereItTellsOfPeople) {
  put(folder_ / "letter.txt");
  EXPECT_EQ(mode_of(folder_ / "letter.txt"), 0600U);
  OutputKind open = letters;
  open.is_of_people = false;
  put(folder_ / "open.txt", open);
  EXPECT_NE(mode_of(folder_ / "open.txt"), 0600U);
}

TEST_F(OutputFile, ReplacesNothingOfAnotherKind) {
  for (const char* content : {"Anna", "D", "dear Ben"}) {
    write(folder_ / "thesis.txt", content);
    expect_refused<OutputError>(folder_ / "thesis.txt");
  }
}

TEST_F(OutputFile, KeepsOutOfTheDataDirectory) {
  expect_refused<database::DatabaseError>(data() / "hallux.db");
  expect_refused<database::DatabaseError>(data() / "letter.txt");
  fs::create_symlink(data() / "hallux.db", folder_ / "letter.txt");
  expect_refused<database::DatabaseError>(folder_ / "letter.txt");
}

TEST_F(OutputFile, IsNoFolderNoDeviceAndNotNowhere) {
  expect_refused<OutputError>(folder_ / "no" / "letter.txt");
  EXPECT_THROW(put(folder_), OutputError);
  EXPECT_THROW(put("/dev/null"), OutputError);
}

TEST_F(OutputFile, IsReplacedAsAWhole) {
  const fs::path file = folder_ / "letter.txt";
  put(file);
  std::ifstream reader(file);  // opened before the replacement: sees the old file to its end
  write_output(file, "Dear Ben", letters, data());
  EXPECT_EQ((std::string{std::istreambuf_iterator<char>(reader), {}}), "Dear Anna");
}

}  // namespace
}  // namespace hallux::ui
