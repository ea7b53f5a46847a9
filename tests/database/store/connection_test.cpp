#include "database/store/connection.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "database/store/migrations.h"
#include "tests/database/some_database.h"

namespace hallux::database {

namespace {

unsigned mode_of(const std::filesystem::path& file) {
  struct stat facts {};
  EXPECT_EQ(::stat(file.c_str(), &facts), 0) << file;
  return facts.st_mode & 0777U;
}

std::string answer_to(Database& database, const char* query) {
  SQLite::Statement statement{database.connection(), query};
  statement.executeStep();
  return statement.getColumn(0).getString();
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream{file, std::ios::binary};
  return {std::istreambuf_iterator<char>{stream}, {}};
}

DatabaseErrorKind kind_of_opening(const std::filesystem::path& directory,
                                  const OpenOptions& options = {}) {
  try {
    Database::open(directory, options);
  } catch (const DatabaseError& error) {
    EXPECT_NE(std::string{error.what()}.find(directory.string()), std::string::npos)
        << error.what();
    return error.kind();
  }
  ADD_FAILURE() << "the database was opened";
  return DatabaseErrorKind::BadInput;
}

TEST(Connection, MakesAPrivateDirectoryWithPrivateFiles) {
  const TemporaryDirectory temporary;
  const Database database = Database::open(temporary.data());
  EXPECT_EQ(mode_of(temporary.data()), 0700U);
  EXPECT_EQ(mode_of(database.file()), 0600U);
  EXPECT_EQ(mode_of(temporary.data() / "hallux.db-wal"), 0600U);
  EXPECT_EQ(mode_of(temporary.data() / "hallux.db-shm"), 0600U);
}

TEST(Connection, TakesTheRightsOfOthersAway) {
  const TemporaryDirectory temporary;
  std::filesystem::create_directory(temporary.data());
  ::chmod(temporary.data().c_str(), 0755);
  Database::open(temporary.data());
  EXPECT_EQ(mode_of(temporary.data()), 0700U);
  ::chmod((temporary.data() / "hallux.db").c_str(), 0644);
  const Database database = Database::open(temporary.data());
  EXPECT_EQ(mode_of(database.file()), 0600U);
}

TEST(Connection, LeavesADirectoryWithOtherThingsInItAsItIs) {
  const TemporaryDirectory temporary;
  std::filesystem::create_directory(temporary.data());
  std::ofstream{temporary.data() / "letter.txt"} << "dear";
  ::chmod(temporary.data().c_str(), 0755);
  Database::open(temporary.data());
  EXPECT_EQ(mode_of(temporary.data()), 0755U);
}

TEST(Connection, SetsWhatEveryConnectionHas) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  EXPECT_EQ(answer_to(database, "PRAGMA journal_mode"), "wal");
  EXPECT_EQ(answer_to(database, "PRAGMA synchronous"), "2");
  EXPECT_EQ(answer_to(database, "PRAGMA foreign_keys"), "1");
  EXPECT_EQ(answer_to(database, "PRAGMA trusted_schema"), "0");
  EXPECT_EQ(database.busy_timeout_ms(), 5000);
  EXPECT_EQ(answer_to(database, "PRAGMA page_size"), "8192");
  EXPECT_EQ(answer_to(database, "PRAGMA application_id"), std::to_string(application_id));
  EXPECT_EQ(answer_to(database, "PRAGMA user_version"), std::to_string(newest_schema()));
}

TEST(Connection, RefusesANewerSchemaAndTouchesNothing) {
  const TemporaryDirectory temporary;
  { tamper(Database::open(temporary.data()), "PRAGMA user_version = 4711"); }
  const std::string before = bytes_of(temporary.data() / "hallux.db");
  EXPECT_EQ(kind_of_opening(temporary.data()), DatabaseErrorKind::Newer);
  EXPECT_EQ(bytes_of(temporary.data() / "hallux.db"), before);
}

TEST(Connection, RefusesTheDatabaseOfAnotherProgram) {
  const TemporaryDirectory temporary;
  std::filesystem::create_directory(temporary.data());
  {
    SQLite::Database other{(temporary.data() / "hallux.db").string(),
                           SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE};
    other.exec("CREATE TABLE recipe (name TEXT)");
  }
  const std::string before = bytes_of(temporary.data() / "hallux.db");
  EXPECT_EQ(kind_of_opening(temporary.data()), DatabaseErrorKind::Damaged);
  EXPECT_EQ(bytes_of(temporary.data() / "hallux.db"), before);
}

TEST(Connection, SaysThatATextFileIsNoDatabase) {
  const TemporaryDirectory temporary;
  std::filesystem::create_directory(temporary.data());
  std::ofstream{temporary.data() / "hallux.db"} << std::string(5000, 'x');
  EXPECT_EQ(kind_of_opening(temporary.data()), DatabaseErrorKind::Damaged);
}

TEST(Connection, SaysThatAnEmptyFileIsDamageAndPutsNothingIntoIt) {
  for (const std::string left : {"", "x"}) {
    const TemporaryDirectory temporary;
    { Database::open(temporary.data()); }
    std::ofstream{temporary.data() / "hallux.db"} << left;
    for (const Access access : {Access::ReadOnly, Access::ReadWrite}) {
      OpenOptions options;
      options.access = access;
      EXPECT_EQ(kind_of_opening(temporary.data(), options), DatabaseErrorKind::Damaged);
      EXPECT_EQ(bytes_of(temporary.data() / "hallux.db"), left);
    }
  }
}

TEST(Connection, ANewFileAppearsWholeAndNothingStaysBesideIt) {
  const TemporaryDirectory temporary;
  std::filesystem::create_directories(temporary.data() / ".new-ab12cd");  // as a kill leaves it
  std::ofstream{temporary.data() / ".new-ab12cd" / "hallux.db"} << "half";
  { Database::open(temporary.data()); }
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator{temporary.data()}) {
    names.push_back(entry.path().filename().string());
  }
  EXPECT_EQ(names, std::vector<std::string>{"hallux.db"});
}

TEST(Connection, SaysThatADirectoryIsAFile) {
  const TemporaryDirectory temporary;
  std::ofstream{temporary.data()} << "not a directory";
  EXPECT_EQ(kind_of_opening(temporary.data()), DatabaseErrorKind::ReadOnly);
}

TEST(Connection, ForReadingMakesNothing) {
  const TemporaryDirectory temporary;
  EXPECT_EQ(kind_of_opening(temporary.data(), {Access::ReadOnly, 5000, ""}),
            DatabaseErrorKind::NotFound);
  EXPECT_FALSE(std::filesystem::exists(temporary.data()));
}

TEST(Connection, ForReadingSeesWhatAWriterCommitted) {
  const TemporaryDirectory temporary;
  Database writer = Database::open(temporary.data());
  some_attempt(writer);
  Database reader = Database::open(temporary.data(), {Access::ReadOnly, 5000, ""});
  EXPECT_EQ(answer_to(reader, "SELECT count(*) FROM asset"), "1");
  EXPECT_THROW(reader.connection().exec("DELETE FROM asset"), SQLite::Exception);
}

}  // namespace

}  // namespace hallux::database
