#include <gtest/gtest.h>

#include <ctime>
#include <iostream>
#include <thread>

#include "database/course/begin_attempt.h"
#include "database/recording/recordings.h"
#include "tests/database/some_database.h"

namespace hallux::database {

namespace {

TEST(RecordingCost, OfAMinuteIsFewBytesASampleAndUnderOnePercentOfACore) {
  const TemporaryDirectory temporary{Medium::Disk};
  Database database = Database::open(temporary.data());
  const simulator::Recording recording = some_recording(60'000);
  simulator::AttemptChannels channels;
  Recorder recorder{database, create_attempt(database, some_attempt(database)), channels};
  const std::jthread producer{[&] { produce(recording, channels); }};
  const RecorderStatistics statistics = recorder.finish("{}");
  const std::clock_t start = std::clock();
  EXPECT_TRUE(is_same(load_recording(database, recorder.attempt()), recording));
  const double read_cpu_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  const double samples = static_cast<double>(statistics.samples);
  const double recorded_s = samples / 1000.0;
  std::cout << "bytes a sample (three streams) " << static_cast<double>(statistics.bytes) / samples
            << ", CPU " << 1000.0 * statistics.cpu_s / recorded_s
            << " ms a recorded second, commit "
            << 1000.0 * statistics.commit_s / static_cast<double>(statistics.commits)
            << " ms mean, " << 1000.0 * statistics.commit_max_s << " ms longest, read back "
            << 1000.0 * read_cpu_s << " ms of CPU a minute\n";
  // Seven noisy integers a row cannot be kept in less than about one byte each, twice (tape and
  // sample).
  EXPECT_LT(static_cast<double>(statistics.bytes) / samples, 40.0);
#ifdef NDEBUG
  EXPECT_LT(statistics.cpu_s / recorded_s, 0.01);
#endif
}

}  // namespace

}  // namespace hallux::database
