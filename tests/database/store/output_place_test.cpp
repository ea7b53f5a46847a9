#include "database/store/output_place.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/database/some_database.h"

namespace hallux::database {

namespace {

namespace fs = std::filesystem;

class OutputPlace : public testing::Test {
 protected:
  OutputPlace() { Database::open(data()); }
  fs::path data() const { return temporary_.data(); }
  fs::path beside() const { return temporary_.data().parent_path(); }
  bool is_refused(const fs::path& output) const {
    try {
      check_outside(output, data());
      return false;
    } catch (const DatabaseError& error) {
      EXPECT_EQ(error.kind(), DatabaseErrorKind::BadInput);
      EXPECT_NE(std::string{error.what()}.find(output.string()), std::string::npos);
      return true;
    }
  }
  TemporaryDirectory temporary_;
};

TEST_F(OutputPlace, IsAnywhereElse) {
  EXPECT_FALSE(is_refused(beside() / "page.html"));
  EXPECT_FALSE(is_refused(beside() / "no" / "such" / "folder"));
  EXPECT_FALSE(is_refused(data().string() + "-of-somebody-else"));
}

TEST_F(OutputPlace, IsNeverTheDataDirectoryNorInIt) {
  EXPECT_TRUE(is_refused(data()));
  EXPECT_TRUE(is_refused(data() / "hallux.db"));
  EXPECT_TRUE(is_refused(data() / "page.html"));
  EXPECT_TRUE(is_refused(data() / "no" / "such" / "folder"));
  EXPECT_TRUE(is_refused(data() / ".." / data().filename() / "page.html"));
}

TEST_F(OutputPlace, IsKnownThroughLinks) {
  const fs::path door = beside() / "door", file = beside() / "page.html",
                 twin = beside() / "twin.html";
  fs::create_directory_symlink(data(), door);
  fs::create_symlink(data() / "hallux.db", file);
  fs::create_hard_link(data() / "hallux.db", twin);
  EXPECT_TRUE(is_refused(door));
  EXPECT_TRUE(is_refused(door / "page.html"));
  EXPECT_TRUE(is_refused(file));
  EXPECT_TRUE(is_refused(twin));
  for (const fs::path& link : {door, file, twin}) fs::remove(link);
}

TEST_F(OutputPlace, HasAName) { EXPECT_THROW(check_outside("", data()), DatabaseError); }

TEST_F(OutputPlace, IsFreeWhereNothingIsKept) {
  const fs::path empty = beside() / "empty";
  fs::create_directory(empty);
  EXPECT_NO_THROW(check_outside(empty / "page.html", empty));
  EXPECT_NO_THROW(check_outside(empty / "page.html", {}));
}

}  // namespace

}  // namespace hallux::database
