#include "simulator/step/piece_book.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

FoundPiece piece(std::int32_t id, bool is_new) {
  FoundPiece found;
  found.id = id;
  found.is_new = is_new;
  found.body = std::make_unique<const Bvh>(tests::solid_block({1.0, 1.0, 1.0}));
  return found;
}

/// The bone, which is old, and pieces 1 to `count` that came free.
std::vector<FoundPiece> bone_and_pieces(std::int32_t count) {
  std::vector<FoundPiece> pieces;
  pieces.push_back(piece(0, false));
  for (std::int32_t id = 1; id <= count; ++id) pieces.push_back(piece(id, true));
  return pieces;
}

TEST(PieceBook, AnnouncesWhatCameFreeOneByOne) {
  std::vector<FoundPiece> pieces = bone_and_pieces(2);
  PieceBook book;
  EXPECT_TRUE(book.is_all_announced());
  EXPECT_EQ(book.announce_next().piece, nullptr);
  book.learn(pieces);
  EXPECT_FALSE(book.is_all_announced());
  EXPECT_EQ(book.announce_next().piece, &pieces[1]);
  EXPECT_EQ(book.announce_next().piece, &pieces[2]);
  EXPECT_TRUE(book.is_all_announced());
  EXPECT_EQ(book.announce_next().piece, nullptr);
}

TEST(PieceBook, TakesEachPieceOutOnce) {
  std::vector<FoundPiece> pieces = bone_and_pieces(2);
  PieceBook book;
  book.learn(pieces);
  EXPECT_EQ(book.take_out(2), &pieces[2]);
  EXPECT_EQ(book.take_out(2), nullptr);
  EXPECT_EQ(book.take_out(1), &pieces[1]);
  ASSERT_EQ(book.removed().size(), 2U);
  EXPECT_EQ(book.removed()[0], pieces[2].body.get());
}

TEST(PieceBook, NeverTakesOutTheBoneNorWhatItDoesNotKnow) {
  std::vector<FoundPiece> pieces = bone_and_pieces(1);
  PieceBook book;
  EXPECT_EQ(book.take_out(1), nullptr);
  EXPECT_EQ(book.take_out(piece_freed_last), nullptr);
  book.learn(pieces);
  EXPECT_EQ(book.take_out(0), nullptr);
  EXPECT_EQ(book.take_out(7), nullptr);
  EXPECT_EQ(book.take_out(-5), nullptr);
  EXPECT_TRUE(book.removed().empty());
}

TEST(PieceBook, ThePieceFreedLastIsTheOneAnnouncedLast) {
  std::vector<FoundPiece> pieces = bone_and_pieces(2);
  PieceBook book;
  book.learn(pieces);
  while (book.announce_next().piece != nullptr) continue;
  EXPECT_EQ(book.take_out(piece_freed_last), &pieces[2]);
}

TEST(PieceBook, TakesOutAsManyAsItHasRoomFor) {
  constexpr auto limit = static_cast<std::int32_t>(removed_piece_limit);
  std::vector<FoundPiece> pieces = bone_and_pieces(limit + 1);
  PieceBook book;
  book.learn(pieces);
  for (std::int32_t id = 1; id <= limit; ++id)
    EXPECT_EQ(book.take_out(id), &pieces[static_cast<std::size_t>(id)]);
  EXPECT_EQ(book.take_out(limit + 1), nullptr);
}

TEST(PieceBook, RemembersTheLastWishUntilItIsTaken) {
  PieceBook book;
  EXPECT_EQ(book.take_wanted(), 0);
  book.want(3);
  book.want(piece_freed_last);
  EXPECT_EQ(book.take_wanted(), piece_freed_last);
  EXPECT_EQ(book.take_wanted(), 0);
}

TEST(PieceBook, TellsOfEachCoveredSectionOnce) {
  PieceBook book;
  book.cover_section(3);
  book.cover_section(1);
  EXPECT_EQ(book.announce_next_section(), 1);
  book.cover_section(1);
  EXPECT_EQ(book.announce_next_section(), 3);
  EXPECT_EQ(book.announce_next_section(), -1);
}

}  // namespace
}  // namespace hallux::simulator
