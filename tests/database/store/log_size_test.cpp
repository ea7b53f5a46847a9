#include "database/store/log_size.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include "tests/database/some_database.h"

namespace hallux::database {

namespace {

/// A megabyte in each of `count` transactions, taken away again.
void write_megabytes(Database& database, int count) {
  for (int i = 0; i < count; ++i) {
    database.connection().exec(
        "INSERT INTO sign_in_guard VALUES (zeroblob(32), zeroblob(32), 1, hex(zeroblob(500000))); "
        "DELETE FROM sign_in_guard");
  }
}

TEST(LogSize, IsNothingWhereThereIsNoLog) {
  const TemporaryDirectory temporary;
  EXPECT_EQ(log_bytes(temporary.data()), 0U);
}

TEST(LogSize, IsNothingAfterAnAttempt) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  write_megabytes(database, 1);
  EXPECT_GT(log_bytes(temporary.data()), 0U);
  record(database, some_attempt(database), some_recording(2000));
  EXPECT_EQ(log_bytes(temporary.data()), 0U);
}

TEST(LogSize, StaysBoundedWhileMuchIsWritten) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  write_megabytes(database, 40);
  EXPECT_LT(log_bytes(temporary.data()), static_cast<std::uintmax_t>(log_bytes_kept));
}

TEST(LogSize, FallsAgainAfterSomebodyReadForLong) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  {
    Database reader = database.open_again();
    reader.connection().exec("BEGIN; SELECT count(*) FROM person;");
    write_megabytes(database, 30);
    shorten_log(database);
    EXPECT_GT(log_bytes(temporary.data()), static_cast<std::uintmax_t>(log_bytes_kept))
        << "what a reader still needs is not thrown away";
    reader.connection().exec("COMMIT");
  }
  write_megabytes(database, 12);
  EXPECT_LE(log_bytes(temporary.data()), static_cast<std::uintmax_t>(log_bytes_kept));
}

}  // namespace

}  // namespace hallux::database
