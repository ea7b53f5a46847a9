/// Files cut short and bits turned over: each damage of something sealed is named, and none makes
/// the program fall.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "database/audit/audit.h"
#include "database/course/scores.h"
#include "database/maintenance/verify.h"
#include "database/recording/recordings.h"
#include "database/store/log_size.h"
#include "simulator/base/random.h"
#include "tests/database/some_database.h"

namespace hallux::database {

namespace {

using Content = std::vector<char>;

/// Two closed attempts, each with a score, in one file.
class Damage : public testing::Test {
 protected:
  Damage() {
    Database database = Database::open(temporary_.data());
    for (const std::int64_t milli : {50'000, 70'000}) {
      const AttemptId id = record(database, some_attempt(database), recording_);
      ScoreCard card;
      card.score_milli = milli;
      store_score(database, id, card);
      attempts_.push_back(id);
    }
    acts_ = read_audit(database).size();
    shorten_log(database);
    std::ifstream file{database.file(), std::ios::binary};
    whole_.assign(std::istreambuf_iterator<char>{file}, {});
  }

  /// What is said of a directory that holds these bytes: "" where nothing is.
  std::string said_of(const Content& content) {
    const TemporaryDirectory place;
    std::filesystem::create_directory(place.data());
    {
      std::ofstream file{place.data() / "hallux.db", std::ios::binary};
      file.write(content.data(), static_cast<std::streamsize>(content.size()));
    }
    OpenOptions for_reading;
    for_reading.access = Access::ReadOnly;
    try {
      Database database = Database::open(place.data(), for_reading);
      const Verification found = verify(database);
      if (!found.is_whole()) return *found.first_damage;
      expect_all_sealed(database);
      return "";
    } catch (const DatabaseError& error) {
      EXPECT_EQ(error.kind(), DatabaseErrorKind::Damaged) << error.what();
      return error.what();
    }
  }

  const Content& whole() const noexcept { return whole_; }

 private:
  /// Where no damage is named, none may be in what is sealed.
  void expect_all_sealed(Database& database) {
    for (std::size_t i = 0; i < attempts_.size(); ++i) {
      EXPECT_TRUE(is_same(load_recording(database, attempts_[i]), recording_));
      EXPECT_EQ(load_score(database, attempts_[i])->card.score_milli, i == 0 ? 50'000 : 70'000);
    }
    EXPECT_EQ(read_audit(database).size(), acts_);
  }

  TemporaryDirectory temporary_;
  simulator::Recording recording_ = some_recording(6000);
  std::vector<AttemptId> attempts_;
  std::size_t acts_ = 0;
  Content whole_;
};

TEST_F(Damage, OfNothingIsNone) { EXPECT_EQ(said_of(whole()), ""); }

TEST_F(Damage, OfAFileCutShortIsNamed) {
  Random random{11};
  const auto last = static_cast<double>(whole().size());
  for (int i = 0; i < 60; ++i) {
    // Nothing at all is an empty database, which is no damage but nothing either.
    const auto size = static_cast<std::size_t>(random.uniform(1.0, last));
    const Content cut(whole().begin(), whole().begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_NE(said_of(cut), "") << "cut at " << size;
  }
}

TEST_F(Damage, OfOneBitIsNamedWhereAnythingSealedHasIt) {
  Random random{12};
  int named = 0;
  constexpr int flips = 120;
  for (int i = 0; i < flips; ++i) {
    Content damaged = whole();
    std::uint64_t at = random.bits() % damaged.size();
    // Tables with few rows leave most of their page zero; three of four bits are in something that
    // was written.
    while (i % 4 != 0 && damaged[at] == '\0') at = random.bits() % damaged.size();
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << (random.bits() % 8)));
    named += said_of(damaged).empty() ? 0 : 1;
  }
  std::cout << flips << " bits turned over, " << named << " of them named\n";
  EXPECT_GE(named, flips / 4);
}

TEST_F(Damage, OfAPageOfZerosIsNamed) {
  constexpr std::size_t page = 8192;
  int named = 0, pages = 0;
  for (std::size_t at = page; at < whole().size(); at += page) {
    Content damaged = whole();
    std::fill_n(damaged.begin() + static_cast<std::ptrdiff_t>(at), page, '\0');
    named += said_of(damaged).empty() ? 0 : 1;
    ++pages;
  }
  std::cout << pages << " pages emptied, " << named << " of them noticed\n";
  EXPECT_GE(named, pages * 9 / 10);
}

/// Above a size the chunks are compared with their indices in place of SQLite's page check.
TEST(DamageOfALargeFile, IsNamedToo) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  record(database, some_attempt(database), some_recording(1200));
  for (int i = 0; i < 70; ++i) {
    tamper(database,
           "INSERT INTO sign_in_guard VALUES (randomblob(32), zeroblob(32), 1, "
           "hex(zeroblob(524288)))");
  }
  shorten_log(database);
  ASSERT_GT(std::filesystem::file_size(database.file()), 64U * 1024U * 1024U);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_TRUE(verify(database).is_whole()) << *verify(database).first_damage;
  const std::chrono::duration<double> spent_s = std::chrono::steady_clock::now() - start;
  std::cout << "a file of 70 MB was checked in " << spent_s.count() << " s\n";
  const auto says = [&](const std::string& part) {
    const std::string damage = verify(database).first_damage.value_or("nothing");
    EXPECT_NE(damage.find(part), std::string::npos) << damage;
  };
  tamper(
      database,
      "INSERT INTO chunk (chunk_id, attempt_id, seq, stream, first_tick, row_count, bytes, link) "
      "VALUES (99, 77, 0, 0, 0, 1, x'00', zeroblob(32))");
  says("chunk 99, which its attempt or an index does not know");
  tamper(database,
         "DELETE FROM chunk WHERE chunk_id = 99; "
         "INSERT INTO note_reply (note_id, author_person_id, text, written_utc) "
         "VALUES (5, 5, '', '')");
  says("which names a missing row");
}

}  // namespace

}  // namespace hallux::database
