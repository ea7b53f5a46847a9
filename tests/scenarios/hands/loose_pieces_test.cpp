#include "scenarios/hands/loose_pieces.h"

#include <gtest/gtest.h>

#include <array>

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

const simulator::FragmentPoses one_bone{RigidTransform{}};

AimedCut face(const Vec3& normal, double offset_mm) {
  AimedCut cut;
  cut.face = {normal, offset_mm};
  return cut;
}

TEST(LoosePieces, OnTheWastesSideAreTakenTheNewestFirst) {
  const std::vector<AimedCut> cuts{face({0.0, 0.0, -1.0}, 1.0)};
  LoosePieces loose;
  loose.observe(freed(1, {5.0, 0.0, -4.0}), one_bone);
  loose.observe(freed(2, {5.0, 0.0, 4.0}), one_bone);
  loose.observe(freed(3, {25.0, 0.0, -2.0}), one_bone);
  EXPECT_EQ(loose.take_waste(cuts), 3);
  EXPECT_EQ(loose.take_waste(cuts), 1);
  EXPECT_EQ(loose.take_waste(cuts), std::nullopt) << "the second is bone that stays";
}

TEST(LoosePieces, AreNotTakenTwice) {
  const std::vector<AimedCut> cuts{face({0.0, 0.0, -1.0}, 1.0)};
  LoosePieces loose;
  loose.observe(freed(1, {5.0, 0.0, -4.0}), one_bone);
  loose.observe(freed(2, {25.0, 0.0, -2.0}), one_bone);
  loose.observe(removed(2), one_bone);
  EXPECT_EQ(loose.take_waste(cuts), 1);
  EXPECT_EQ(loose.take_waste(cuts), std::nullopt);
}

TEST(LoosePieces, OfAWedgeLieBetweenItsFaces) {
  const std::vector<AimedCut> cuts{face({1.0, 0.0, 0.0}, 6.0), face({-1.0, 0.0, 0.0}, -9.0)};
  LoosePieces loose;
  loose.observe(freed(1, {20.0, 0.0, 0.0}), one_bone);
  loose.observe(freed(2, {7.5, 0.0, 0.0}), one_bone);
  EXPECT_EQ(loose.take_waste(cuts), 2);
  EXPECT_EQ(loose.take_waste(cuts), std::nullopt) << "the half beyond the wedge stays";
}

TEST(LoosePieces, BeyondItsRoomAreNotSeen) {
  LoosePieces loose;
  for (std::int32_t piece = 1; piece <= 10; ++piece) loose.observe(freed(piece, {}), one_bone);
  std::size_t taken = 0;
  while (loose.take_waste({})) ++taken;
  EXPECT_EQ(taken, LoosePieces::most);
}

/// Of two bones, whose frames coincide.
TEST(LoosePieces, OfAnotherBoneAreNoWasteAndLieNowhereNear) {
  const std::array<RigidTransform, 2> lying{};
  const simulator::FragmentPoses two_bones(lying);
  const std::vector<AimedCut> cuts{face({0.0, 0.0, -1.0}, 1.0)};
  LoosePieces loose;
  CutEvent of_second;
  of_second.kind = CutEventKind::PieceOfFragment;
  of_second.subject = 2;
  of_second.value = 1;
  loose.observe(freed(3, {6.0, 0.0, -4.0}), two_bones);
  loose.observe(of_second, two_bones);
  loose.observe(freed(2, {5.0, 0.0, -4.0}), two_bones);
  EXPECT_EQ(loose.nearest({5.0, 0.0, -4.0}, 0), 3);
  EXPECT_EQ(loose.nearest({6.0, 0.0, -4.0}, 1), 2);
  EXPECT_EQ(loose.take_waste(cuts), 3);
  EXPECT_EQ(loose.take_waste(cuts), std::nullopt);
}

}  // namespace
}  // namespace hallux::scenarios
