#include "ui/render/display_buffer.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "simulator/base/random.h"
#include "ui/render/headless_context.h"

namespace hallux::tests {
namespace {

using namespace ui;
using Words = std::vector<std::uint32_t>;

constexpr std::uint32_t blank = 0xffffffffU;

Words numbers(std::size_t count, std::uint32_t first = 0) {
  Words words(count);
  std::iota(words.begin(), words.end(), first);
  return words;
}

/// What the card holds.
Words on_card(const DisplayBuffer<std::uint32_t>& buffer) {
  Words words(buffer.size());
  glBindBuffer(GL_COPY_READ_BUFFER, buffer.name());
  glGetBufferSubData(GL_COPY_READ_BUFFER, 0,
                     static_cast<GLsizeiptr>(words.size() * sizeof(std::uint32_t)), words.data());
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  return words;
}

Words in_memory(const DisplayBuffer<std::uint32_t>& buffer) {
  return {buffer.elements().begin(), buffer.elements().end()};
}

Words standing(Words words) {
  std::erase(words, blank);
  std::sort(words.begin(), words.end());
  return words;
}

TEST(DisplayBuffer, SendsWhatChangedAndNothingElse) {
  const HeadlessContext context;
  BufferPolicy policy;
  policy.join_bytes = 0;
  DisplayBuffer<std::uint32_t> buffer(blank, policy);
  buffer.append(numbers(1000));
  buffer.upload();
  const std::uint64_t whole = buffer.counts().uploaded_bytes;
  EXPECT_EQ(whole, 4000u);
  buffer.upload();
  EXPECT_EQ(buffer.counts().uploaded_bytes, whole);
  buffer.write(17, 4711);
  buffer.write(900, 4712);
  buffer.upload();
  EXPECT_EQ(buffer.counts().uploaded_bytes, whole + 8);
  EXPECT_EQ(on_card(buffer), in_memory(buffer));
}

TEST(DisplayBuffer, EqualElementsAreNotSentAgain) {
  const HeadlessContext context;
  DisplayBuffer<std::uint32_t> buffer(blank);
  const Words words = numbers(5000);
  buffer.assign(words);
  buffer.upload();
  const std::uint64_t sent = buffer.counts().uploaded_bytes;
  buffer.assign(words);
  buffer.upload();
  EXPECT_EQ(buffer.counts().uploaded_bytes, sent);
}

TEST(DisplayBuffer, EveryWayOfGrowingHoldsEverything) {
  const HeadlessContext context;
  for (const double factor : {1.0, 1.5, 2.0}) {
    for (const Refill refill : {Refill::FromMemory, Refill::OnCard}) {
      BufferPolicy policy;
      policy.growth = {factor, 16, refill};
      DisplayBuffer<std::uint32_t> buffer(blank, policy);
      for (std::uint32_t step = 0; step < 40; ++step) {
        buffer.append(numbers(1 + step * 7, 1000 * step));
        buffer.upload();
        ASSERT_EQ(on_card(buffer), in_memory(buffer)) << factor;
        ASSERT_GE(buffer.room(), buffer.size());
      }
    }
  }
}

TEST(DisplayBuffer, EveryWayOfRemovingLeavesTheOthersStanding) {
  const HeadlessContext context;
  for (const RemovalPolicy removal :
       {RemovalPolicy::Overwrite, RemovalPolicy::MoveLast, RemovalPolicy::Rebuild}) {
    Random random(7);
    BufferPolicy policy;
    policy.removal = removal;
    DisplayBuffer<std::uint32_t> buffer(blank, policy);
    Words left = numbers(2000);
    buffer.append(left);
    buffer.upload();
    while (left.size() > 100) {
      Words removed;
      for (std::size_t i = 0; i < 90; ++i) {
        const std::size_t at = random.bits() % left.size();
        removed.push_back(left[at]);
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
      }
      buffer.remove(removed);
      buffer.upload();
      ASSERT_EQ(on_card(buffer), in_memory(buffer));
      ASSERT_EQ(standing(in_memory(buffer)), left);
    }
  }
}

TEST(DisplayBuffer, WhatWasOverwrittenComesBack) {
  const HeadlessContext context;
  DisplayBuffer<std::uint32_t> buffer(blank);
  buffer.append(numbers(300));
  buffer.remove(Words{5, 6, 7});
  buffer.upload();
  EXPECT_EQ(on_card(buffer)[6], blank);
  buffer.write(6, 6);
  buffer.upload();
  EXPECT_EQ(on_card(buffer)[6], 6u);
  EXPECT_EQ(on_card(buffer)[5], blank);
}

TEST(ChangedRanges, AreSortedJoinedAndCutAtTheEnd) {
  ChangedRanges ranges;
  ranges.add(40, 50);
  ranges.add(0, 10);
  ranges.add(12, 20);
  ranges.add(90, 120);
  const std::vector<ChangedRanges::Range> taken = ranges.take(4, 100);
  ASSERT_EQ(taken.size(), 3u);
  EXPECT_EQ(taken[0].first, 0u);
  EXPECT_EQ(taken[0].last, 20u);
  EXPECT_EQ(taken[2].last, 100u);
  EXPECT_TRUE(ranges.is_empty());
}

}  // namespace
}  // namespace hallux::tests
