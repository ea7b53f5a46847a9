#include "ui/render/gl/display_buffer.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "simulator/base/random.h"
#include "simulator/mesh/indexed_mesh.h"
#include "tests/benchmarks/display_buffers/placed_buffer.h"
#include "tests/ui/render/graphics.h"

namespace hallux::tests {
namespace {

using benchmarks::PlacedBuffer;
using benchmarks::RemovalPolicy;
using simulator::Triangle;
using ui::DisplayBuffer;

constexpr Triangle blank{0, 0, 0};

Triangle triangle(std::uint32_t first) { return {first, first + 1, first + 2}; }

std::vector<Triangle> triangles(std::uint32_t count) {
  std::vector<Triangle> made;
  for (std::uint32_t i = 0; i < count; ++i) made.push_back(triangle(3 * i + 1));
  return made;
}

/// What is really on the card.
template <typename Buffer>
std::vector<Triangle> on_card(const Buffer& buffer) {
  std::vector<Triangle> read(buffer.size());
  glBindBuffer(GL_COPY_READ_BUFFER, buffer.name());
  glGetBufferSubData(GL_COPY_READ_BUFFER, 0,
                     static_cast<GLsizeiptr>(read.size() * sizeof(Triangle)), read.data());
  return read;
}

template <typename Buffer>
std::vector<Triangle> in_memory(const Buffer& buffer) {
  return {buffer.elements().begin(), buffer.elements().end()};
}

using DisplayBuffers = Graphics;

TEST_F(DisplayBuffers, SendsOnlyWhatChanged) {
  DisplayBuffer<Triangle> buffer(blank, {.join_bytes = 0});
  buffer.append(triangles(1000));
  buffer.upload();
  EXPECT_EQ(buffer.counts().uploaded_bytes, 1000 * sizeof(Triangle));
  buffer.upload();
  EXPECT_EQ(buffer.counts().uploaded_bytes, 1000 * sizeof(Triangle));

  buffer.write(10, triangle(77));
  buffer.write(500, triangle(78));
  buffer.write(501, triangle(79));
  buffer.write(600, buffer.elements()[600]);  // as it was
  const auto before = buffer.counts();
  buffer.upload();
  EXPECT_EQ(buffer.counts().uploaded_bytes - before.uploaded_bytes, 3 * sizeof(Triangle));
  EXPECT_EQ(buffer.counts().uploads - before.uploads, 2U);
  EXPECT_EQ(on_card(buffer), in_memory(buffer));
}

TEST_F(DisplayBuffers, JoinsChangesThatLieNear) {
  DisplayBuffer<Triangle> buffer(blank, {.join_bytes = 10 * sizeof(Triangle)});
  buffer.append(triangles(1000));
  buffer.upload();
  const auto before = buffer.counts();
  buffer.write(20, triangle(1));
  buffer.write(10, triangle(2));
  buffer.write(200, triangle(3));
  buffer.upload();
  EXPECT_EQ(buffer.counts().uploads - before.uploads, 2U);
  EXPECT_EQ(buffer.counts().uploaded_bytes - before.uploaded_bytes, 12 * sizeof(Triangle));
}

TEST_F(DisplayBuffers, SameContentAgainIsNotSent) {
  DisplayBuffer<Triangle> buffer(blank);
  std::vector<Triangle> content = triangles(300);
  buffer.assign(content);
  buffer.upload();
  const auto before = buffer.counts();
  buffer.assign(content);
  buffer.upload();
  EXPECT_EQ(buffer.counts().uploaded_bytes, before.uploaded_bytes);
  content[299] = triangle(5);
  buffer.assign(content);
  buffer.upload();
  EXPECT_EQ(buffer.counts().uploaded_bytes - before.uploaded_bytes, sizeof(Triangle));
}

TEST_F(DisplayBuffers, GrowByTheirFactor) {
  EXPECT_EQ(ui::room_for({.factor = 1.0, .least = 1}, 1000), 1000U);
  EXPECT_EQ(ui::room_for({.factor = 1.03, .least = 1}, 1000), 1030U);
  EXPECT_EQ(ui::room_for({.factor = 2.0, .least = 256}, 10), 256U);

  DisplayBuffer<Triangle> exact(blank, {.growth = {.factor = 1.0, .least = 1}});
  DisplayBuffer<Triangle> roomy(blank, {.growth = {.factor = 1.5, .least = 1}});
  for (std::uint32_t i = 0; i < 100; ++i) {
    const Triangle added = triangle(i);
    exact.append(std::span(&added, 1));
    exact.upload();
    roomy.append(std::span(&added, 1));
    roomy.upload();
  }
  EXPECT_EQ(exact.counts().stores, 100U);  // one more each time
  // 1, 2 (2/1.5: 1), 3: 1 -> 2 -> 3 -> 5 -> 8 ... : each at least 1.5 times what was needed.
  EXPECT_LE(roomy.counts().stores, 12U);
  EXPECT_EQ(on_card(exact), on_card(roomy));
}

TEST_F(DisplayBuffers, OverwrittenTrianglesAreBlankAndComeBack) {
  DisplayBuffer<Triangle> buffer(blank);
  buffer.append(triangles(100));
  const std::vector<std::uint32_t> removed{0, 50, 99};
  buffer.remove(removed);
  buffer.upload();
  EXPECT_EQ(buffer.size(), 100U);
  EXPECT_EQ(on_card(buffer)[50], blank);
  buffer.write(50, triangle(151));
  buffer.upload();
  EXPECT_EQ(on_card(buffer)[50], triangle(151));
}

/// Every policy leaves the same triangles standing, whatever was removed in whatever order.
class Removal : public testing::TestWithParam<RemovalPolicy> {
 protected:
  ui::HeadlessContext context_;
};

TEST_P(Removal, LeavesExactlyWhatWasNotRemoved) {
  Random random(7);
  PlacedBuffer<Triangle> buffer(blank, GetParam());
  std::vector<Triangle> expected;
  std::vector<std::uint32_t> standing;
  std::uint32_t next = 0;
  for (int round = 0; round < 40; ++round) {
    std::vector<Triangle> added;
    added.reserve(20);
    for (int i = 0; i < 20; ++i) {
      added.push_back(triangle(10 * next + 1));
      standing.push_back(next++);
    }
    buffer.append(added);
    std::vector<std::uint32_t> removed;
    for (int i = 0; i < 12; ++i) {
      const auto at =
          static_cast<std::size_t>(random.uniform() * static_cast<double>(standing.size()));
      removed.push_back(standing[at]);
      standing.erase(standing.begin() + static_cast<std::ptrdiff_t>(at));
    }
    buffer.remove(removed);
    buffer.upload();
  }
  expected.reserve(standing.size());
  for (const std::uint32_t element : standing) expected.push_back(triangle(10 * element + 1));
  std::vector<Triangle> seen = on_card(buffer);
  EXPECT_EQ(seen, in_memory(buffer));
  std::erase(seen, blank);
  std::sort(seen.begin(), seen.end());
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(seen, expected);
}

TEST_P(Removal, WritesToWhereAnElementMoved) {
  PlacedBuffer<Triangle> buffer(blank, GetParam());
  buffer.append(triangles(10));
  const std::vector<std::uint32_t> removed{2, 7};
  buffer.remove(removed);
  buffer.write(9, triangle(1000));
  buffer.upload();
  const std::vector<Triangle> seen = on_card(buffer);
  EXPECT_EQ(std::count(seen.begin(), seen.end(), triangle(1000)), 1);
  EXPECT_EQ(std::count(seen.begin(), seen.end(), triangle(3 * 9 + 1)), 0);
}

INSTANTIATE_TEST_SUITE_P(Policies, Removal,
                         testing::Values(RemovalPolicy::Overwrite, RemovalPolicy::MoveLast,
                                         RemovalPolicy::Rebuild));

TEST(ChangedRanges, AreFewHoweverManyPlacesChange) {
  ui::ChangedRanges ranges;
  for (std::size_t i = 0; i < 100'000; ++i)
    ranges.add(100 * (i * 7919 % 100'000), 100 * (i * 7919 % 100'000) + 4);
  std::size_t covered = 0;
  for (const auto& range : ranges.take(0, 100 * 100'000)) covered += range.last - range.first;
  EXPECT_GE(covered, 4U * 100'000);
}

TEST(ChangedRanges, EndWhereTheBytesEnd) {
  ui::ChangedRanges ranges;
  ranges.add(10, 30);
  ranges.add(50, 60);
  const auto taken = ranges.take(0, 20);
  ASSERT_EQ(taken.size(), 1U);
  EXPECT_EQ(taken[0].last, 20U);
  EXPECT_TRUE(ranges.is_empty());
}

}  // namespace
}  // namespace hallux::tests
