#include "database/recording/chunk_codec.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <zstd.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "database/recording/column_coding.h"
#include "tests/database/recording/any_chunk.h"
#include "tests/database/some_database.h"

namespace hallux::database {

namespace {

/// Chunk bytes as programs wrote them before there was format 2.
std::vector<std::byte> format_one(std::span<const std::byte> payload) {
  std::vector<std::byte> bytes(1 + ZSTD_compressBound(payload.size()));
  bytes[0] = std::byte{1};
  bytes.resize(
      1 + ZSTD_compress(bytes.data() + 1, bytes.size() - 1, payload.data(), payload.size(), 3));
  return bytes;
}

template <typename Row>
std::vector<Row> rows_of(Stream stream, std::span<const std::byte> bytes, std::size_t row_count,
                         const Columns* tape = nullptr) {
  Columns columns;
  ChunkUnpacker{}.unpack(bytes, {stream, row_count}, tape, columns);
  std::vector<Row> rows;
  append_rows(columns, rows);
  return rows;
}

std::vector<std::byte> packed(const Columns& columns, const Columns* tape = nullptr) {
  std::vector<std::byte> buffer;
  return ChunkPacker{}.pack(columns, payload_in(buffer, columns), tape);
}

/// Through both formats.
template <typename Row>
std::vector<Row> through_bytes(Stream stream, const std::vector<Row>& rows) {
  const Columns columns = columns_from(std::span<const Row>{rows});
  std::vector<std::byte> buffer;
  const auto before = rows_of<Row>(stream, format_one(payload_in(buffer, columns)), rows.size());
  EXPECT_EQ(before, rows);
  return rows_of<Row>(stream, packed(columns), rows.size());
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

/// A tape and samples that ran beside it, as one window holds them.
struct SmallWindow {
  explicit SmallWindow(std::int64_t ticks) : recording(some_recording(ticks)) {
    for (auto& sample : recording.samples) sample.world_from_tool.translation_um[2] += 7;
  }
  Columns tape() const { return columns_from(std::span{recording.tape}); }
  std::vector<std::byte> chunk_of_samples() const {
    const Columns beside = tape();
    return packed(columns_from(std::span{recording.samples}), &beside);
  }
  std::vector<std::byte> old_chunk_of_samples() const {
    std::vector<std::byte> buffer;
    return format_one(payload_in(buffer, columns_from(std::span{recording.samples})));
  }
  simulator::Recording recording;
};

/// The rows in `bytes`; nothing where the reader says that they are damaged.
std::optional<std::vector<simulator::ToolSample>> rows_in(const std::vector<std::byte>& bytes,
                                                          std::size_t row_count,
                                                          const Columns& tape) {
  try {
    return rows_of<simulator::ToolSample>(Stream::Sample, bytes, row_count, &tape);
  } catch (const DatabaseError& error) {
    EXPECT_EQ(error.kind(), DatabaseErrorKind::Damaged);
    return std::nullopt;
  }
}

std::optional<Columns> numbers_in(std::span<const std::byte> coded, const Columns& like,
                                  const Columns* tape) {
  Columns columns{like.column_count(), like.row_count()};
  try {
    read_coded(coded, tape, columns);
  } catch (const DatabaseError&) {
    return std::nullopt;
  }
  return columns;
}

bool is_same(const Columns& a, const Columns& b) {
  std::vector<std::byte> of_a;
  std::vector<std::byte> of_b;
  return std::ranges::equal(payload_in(of_a, a), payload_in(of_b, b));
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

TEST(ChunkCodec, GivesBackColumnsOfAnyNumbersBesideAnyTape) {
  EXPECT_TRUE(rc::check([] {
    const auto rows = *rc::gen::inRange<std::size_t>(1, 40);
    const auto order = *rc::gen::inRange<unsigned>(0, 64);
    Columns columns{simulator::sample_columns, rows};
    Columns tape{simulator::tape_columns, rows};
    const auto fill = [order](Columns& into) {
      for (std::size_t i = 0; i < into.column_count(); ++i) {
        for (auto& value : into.column(i)) value = *rc::gen::arbitrary<std::int64_t>() >> order;
      }
    };
    fill(columns);
    fill(tape);
    std::vector<std::byte> coded;
    append_coded(coded, columns, &tape);
    const auto back = numbers_in(coded, columns, &tape);
    RC_ASSERT(back.has_value());
    RC_ASSERT(is_same(*back, columns));
  }));
}

TEST(ChunkCodec, SamplesThatFollowTheirTapeTakeFewBytes) {
  SmallWindow window{500};
  for (auto& sample : window.recording.samples) sample.force_mn = {};
  EXPECT_LT(window.chunk_of_samples().size(), 160U);
}

TEST(ChunkCodec, SamplesThatFollowTheirTapeAreRefusedWithoutIt) {
  const SmallWindow window{60};
  const std::vector<std::byte> bytes = window.chunk_of_samples();
  EXPECT_EQ(rows_in(bytes, 60, window.tape()), window.recording.samples);
  const SmallWindow shorter{59};
  EXPECT_FALSE(rows_in(bytes, 60, shorter.tape()));
  EXPECT_THROW(rows_of<simulator::ToolSample>(Stream::Sample, bytes, 60), DatabaseError);
}

TEST(ChunkCodec, TheSameRowsGiveTheSamePayload) {
  const simulator::Recording recording = some_recording(100);
  const Columns columns = columns_from(std::span{recording.samples});
  EXPECT_TRUE(is_same(columns, columns_from(std::span{recording.samples})));
}

TEST(ChunkCodec, RefusesEveryTruncation) {
  const SmallWindow window{40};
  for (const auto& bytes : {window.chunk_of_samples(), window.old_chunk_of_samples()}) {
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      const std::vector<std::byte> cut(bytes.begin(),
                                       bytes.begin() + static_cast<std::ptrdiff_t>(size));
      EXPECT_FALSE(rows_in(cut, window.recording.samples.size(), window.tape())) << size;
    }
  }
}

TEST(ChunkCodec, EveryFlippedBitIsRefusedOrChangesNothing) {
  const SmallWindow window{40};
  const Columns tape = window.tape();
  const std::vector<std::byte> bytes = window.chunk_of_samples();
  for (std::size_t bit = 0; bit < bytes.size() * 8; ++bit) {
    std::vector<std::byte> altered = bytes;
    altered[bit / 8] ^= static_cast<std::byte>(1U << (bit % 8));
    const auto rows = rows_in(altered, window.recording.samples.size(), tape);
    if (rows) {
      EXPECT_EQ(*rows, window.recording.samples) << bit;
    }
  }
}

TEST(ChunkCodec, EveryFlippedBitOfAPayloadIsRefusedOrMeansOtherRows) {
  const simulator::Recording recording = some_recording(20);
  const Columns columns = columns_from(std::span{recording.samples});
  std::vector<std::byte> buffer;
  const std::span<const std::byte> payload = payload_in(buffer, columns);
  for (std::size_t bit = 0; bit < payload.size() * 8; ++bit) {
    std::vector<std::byte> altered(payload.begin(), payload.end());
    altered[bit / 8] ^= static_cast<std::byte>(1U << (bit % 8));
    Columns read{columns.column_count(), columns.row_count()};
    try {
      read_payload(altered, read);
      EXPECT_FALSE(is_same(read, columns)) << bit;
    } catch (const DatabaseError& error) {
      EXPECT_EQ(error.kind(), DatabaseErrorKind::Damaged);
    }
  }
}

TEST(ChunkCodec, CodedColumnsCutShortAreRefused) {
  const SmallWindow window{30};
  const Columns tape = window.tape();
  const Columns columns = columns_from(std::span{window.recording.samples});
  std::vector<std::byte> coded;
  append_coded(coded, columns, &tape);
  for (std::size_t size = 0; size < coded.size(); ++size) {
    EXPECT_FALSE(numbers_in(std::span{coded}.first(size), columns, &tape)) << size;
  }
  coded.push_back(std::byte{0});
  EXPECT_FALSE(numbers_in(coded, columns, &tape));
}

TEST(ChunkCodec, ANumberThatDoesNotFitItsColumnIsRefused) {
  const simulator::Recording recording = some_recording(3);
  Columns columns = columns_from(std::span{recording.samples});
  columns.column(1)[2] = std::int64_t{1} << 40U;
  std::vector<simulator::ToolSample> rows;
  EXPECT_THROW(append_rows(columns, rows), DatabaseError);
  EXPECT_TRUE(rows.empty());
}

TEST(ChunkCodec, RefusesAFalseRowCountWithoutTakingMemoryForIt) {
  const SmallWindow window{10};
  const Columns tape = window.tape();
  for (const auto& bytes : {window.chunk_of_samples(), window.old_chunk_of_samples()}) {
    EXPECT_FALSE(rows_in(bytes, 0, tape));
    EXPECT_FALSE(rows_in(bytes, 9, tape));
    EXPECT_FALSE(rows_in(bytes, 11, tape));
    EXPECT_FALSE(rows_in(bytes, rows_per_chunk_max, tape));
    EXPECT_FALSE(rows_in(bytes, std::numeric_limits<std::size_t>::max(), tape));
  }
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
