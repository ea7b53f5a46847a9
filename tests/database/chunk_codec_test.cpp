#include "database/chunk_codec.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <limits>

#include "tests/database/some_database.h"

namespace hallux::database {

namespace {

template <typename Row>
std::vector<Row> through_bytes(Stream stream, const std::vector<Row>& rows) {
  ChunkPacker packer;
  const std::vector<std::byte> bytes = packer.pack(payload_from(std::span<const Row>{rows}));
  std::vector<Row> back;
  append_rows(unpack_payload(bytes, stream, rows.size()), rows.size(), back);
  return back;
}

simulator::ToolSample any_sample() {
  simulator::ToolSample sample;
  sample.tick = *rc::gen::arbitrary<std::int64_t>();
  for (auto& part : sample.world_from_tool.translation_um) {
    part = *rc::gen::arbitrary<std::int32_t>();
  }
  for (auto& part : sample.world_from_tool.rotation_micro) {
    part = *rc::gen::arbitrary<std::int32_t>();
  }
  for (auto& part : sample.force_mn) part = *rc::gen::arbitrary<std::int32_t>();
  sample.status = *rc::gen::arbitrary<std::uint32_t>();
  sample.kerf = *rc::gen::arbitrary<std::int32_t>();
  return sample;
}

std::vector<std::byte> small_chunk(const std::vector<simulator::ToolSample>& samples) {
  ChunkPacker packer;
  return packer.pack(payload_from(std::span<const simulator::ToolSample>{samples}));
}

/// The rows in `bytes`; nothing where the reader says that they are damaged.
std::optional<std::vector<simulator::ToolSample>> rows_in(const std::vector<std::byte>& bytes,
                                                          std::size_t row_count) {
  std::vector<simulator::ToolSample> rows;
  try {
    append_rows(unpack_payload(bytes, Stream::Sample, row_count), row_count, rows);
  } catch (const DatabaseError& error) {
    EXPECT_EQ(error.kind(), DatabaseErrorKind::Damaged);
    EXPECT_TRUE(rows.empty());
    return std::nullopt;
  }
  return rows;
}

TEST(ChunkCodec, GivesBackAnySamples) {
  EXPECT_TRUE(rc::check([] {
    std::vector<simulator::ToolSample> samples(*rc::gen::inRange<std::size_t>(1, 20));
    for (auto& sample : samples) sample = any_sample();
    RC_ASSERT(through_bytes(Stream::Sample, samples) == samples);
  }));
}

TEST(ChunkCodec, GivesBackTheEndsOfTheNumberRange) {
  constexpr std::int64_t lowest = std::numeric_limits<std::int64_t>::min();
  constexpr std::int64_t highest = std::numeric_limits<std::int64_t>::max();
  std::vector<simulator::CutEvent> events(4);
  events[0].value = lowest;
  events[1].value = highest;
  events[2].tick = highest;
  events[3].tick = lowest;
  EXPECT_EQ(through_bytes(Stream::Event, events), events);
}

TEST(ChunkCodec, GivesBackATapeAndItsEvents) {
  const simulator::Recording recording = some_recording(700);
  EXPECT_EQ(through_bytes(Stream::Tape, recording.tape), recording.tape);
  EXPECT_EQ(through_bytes(Stream::Event, recording.events), recording.events);
}

TEST(ChunkCodec, TheSameRowsGiveTheSamePayload) {
  const simulator::Recording recording = some_recording(100);
  const std::span<const simulator::ToolSample> samples{recording.samples};
  EXPECT_EQ(payload_from(samples), payload_from(samples));
}

TEST(ChunkCodec, RefusesEveryTruncation) {
  const simulator::Recording recording = some_recording(40);
  const std::vector<std::byte> bytes = small_chunk(recording.samples);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const std::vector<std::byte> cut(bytes.begin(),
                                     bytes.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_FALSE(rows_in(cut, recording.samples.size())) << size;
  }
}

TEST(ChunkCodec, EveryFlippedBitIsRefusedOrChangesNothing) {
  const simulator::Recording recording = some_recording(40);
  const std::vector<std::byte> bytes = small_chunk(recording.samples);
  for (std::size_t bit = 0; bit < bytes.size() * 8; ++bit) {
    std::vector<std::byte> altered = bytes;
    altered[bit / 8] ^= static_cast<std::byte>(1U << (bit % 8));
    const auto rows = rows_in(altered, recording.samples.size());
    if (rows) {
      EXPECT_EQ(*rows, recording.samples) << bit;
    }
  }
}

TEST(ChunkCodec, EveryFlippedBitOfAPayloadIsRefusedOrMeansOtherRows) {
  const simulator::Recording recording = some_recording(20);
  const std::vector<std::byte> payload =
      payload_from(std::span<const simulator::ToolSample>{recording.samples});
  for (std::size_t bit = 0; bit < payload.size() * 8; ++bit) {
    std::vector<std::byte> altered = payload;
    altered[bit / 8] ^= static_cast<std::byte>(1U << (bit % 8));
    std::vector<simulator::ToolSample> rows;
    try {
      append_rows(altered, recording.samples.size(), rows);
      EXPECT_NE(rows, recording.samples) << bit;
    } catch (const DatabaseError&) {
      EXPECT_TRUE(rows.empty());
    }
  }
}

TEST(ChunkCodec, RefusesAFalseRowCountWithoutTakingMemoryForIt) {
  const simulator::Recording recording = some_recording(10);
  const std::vector<std::byte> bytes = small_chunk(recording.samples);
  EXPECT_FALSE(rows_in(bytes, 9));
  EXPECT_FALSE(rows_in(bytes, 11));
  EXPECT_FALSE(rows_in(bytes, rows_per_chunk_max));
  EXPECT_THROW(unpack_payload(bytes, Stream::Sample, std::numeric_limits<std::size_t>::max()),
               DatabaseError);
}

TEST(ChunkCodec, ReadsAnyBytesWithoutCrashing) {
  EXPECT_TRUE(rc::check([](const std::vector<std::uint8_t>& bytes) {
    try {
      read_any_chunk(std::as_bytes(std::span{bytes}));
    } catch (const DatabaseError&) {
    }
  }));
}

}  // namespace

}  // namespace hallux::database
