#include "scenarios/hands/loose_pieces.h"

#include <gtest/gtest.h>

namespace hallux::scenarios {
namespace {

using simulator::CutEvent;
using simulator::CutEventKind;

/// A piece around that place.
CutEvent freed(std::int32_t piece, const Vec3& inside_mm) {
  CutEvent event;
  event.kind = CutEventKind::PieceFreed;
  event.subject = piece;
  event.pose = simulator::quantise({Quat(1.0, 0.0, 0.0, 0.0), inside_mm});
  return event;
}

CutEvent removed(std::int32_t piece) {
  CutEvent event;
  event.kind = CutEventKind::PieceRemoved;
  event.subject = piece;
  return event;
}

AimedCut face(const Vec3& normal, double offset_mm) {
  AimedCut cut;
  cut.face = {normal, offset_mm};
  return cut;
}

TEST(LoosePieces, OnTheWastesSideAreTakenTheNewestFirst) {
  const std::vector<AimedCut> cuts{face({0.0, 0.0, -1.0}, 1.0)};
  LoosePieces loose;
  loose.observe(freed(1, {5.0, 0.0, -4.0}));
  loose.observe(freed(2, {5.0, 0.0, 4.0}));
  loose.observe(freed(3, {25.0, 0.0, -2.0}));
  EXPECT_EQ(loose.take_waste(cuts), 3);
  EXPECT_EQ(loose.take_waste(cuts), 1);
  EXPECT_EQ(loose.take_waste(cuts), std::nullopt) << "the second is bone that stays";
}

TEST(LoosePieces, AreNotTakenTwice) {
  const std::vector<AimedCut> cuts{face({0.0, 0.0, -1.0}, 1.0)};
  LoosePieces loose;
  loose.observe(freed(1, {5.0, 0.0, -4.0}));
  loose.observe(freed(2, {25.0, 0.0, -2.0}));
  loose.observe(removed(2));
  EXPECT_EQ(loose.take_waste(cuts), 1);
  EXPECT_EQ(loose.take_waste(cuts), std::nullopt);
}

TEST(LoosePieces, OfAWedgeLieBetweenItsFaces) {
  const std::vector<AimedCut> cuts{face({1.0, 0.0, 0.0}, 6.0), face({-1.0, 0.0, 0.0}, -9.0)};
  LoosePieces loose;
  loose.observe(freed(1, {20.0, 0.0, 0.0}));
  loose.observe(freed(2, {7.5, 0.0, 0.0}));
  EXPECT_EQ(loose.take_waste(cuts), 2);
  EXPECT_EQ(loose.take_waste(cuts), std::nullopt) << "the half beyond the wedge stays";
}

TEST(LoosePieces, BeyondItsRoomAreNotSeen) {
  LoosePieces loose;
  for (std::int32_t piece = 1; piece <= 10; ++piece) loose.observe(freed(piece, {}));
  std::size_t taken = 0;
  while (loose.take_waste({})) ++taken;
  EXPECT_EQ(taken, LoosePieces::most);
}

}  // namespace
}  // namespace hallux::scenarios
