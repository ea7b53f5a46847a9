#include "scenarios/site/wanted_part.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "tests/scenarios/site/block_site.h"
#include "tests/support/worlds.h"

namespace hallux::scenarios {
namespace {

using simulator::Bvh;
using simulator::PieceBody;
using testing::ElementsAre;
using testing::IsEmpty;
using tests::BlockSite;

/// Lies with its middle there.
PieceBody piece_at(std::int32_t id, const Vec3& middle_mm, const Vec3& size_mm) {
  PieceBody piece;
  piece.id = id;
  piece.inside_mm = middle_mm;
  piece.solid = simulator::uncut_solid(
      tests::moved(tests::solid_block(size_mm), {Quat(1.0, 0.0, 0.0, 0.0), middle_mm}));
  piece.bvh = std::make_unique<const Bvh>(piece.solid.mesh);
  return piece;
}

/// The block with a cut along it that is through: 3.5 mm medial of the plan's face are waste, less
/// the blade's kerf.
class ASawnBlock : public testing::Test {
 protected:
  ASawnBlock() {
    const std::int32_t kerf = saw(0);
    site_.saw(kerf, 0.0, 14.0);
  }
  std::int32_t saw(std::size_t cut) {
    const simulator::CutEvent event = site_.freeze(cut);
    watch_.apply(event, site_.kerfs);
    return event.subject;
  }
  WantedPart wanted(std::vector<const PieceBody*> free, const std::vector<const Bvh*>& out = {}) {
    const std::array wholes{simulator::SolidWithTree{site_.whole, site_.bvh}};
    const std::vector<HeldCut> held = watch_.held(site_.kerfs, wholes);
    const auto step =
        std::ranges::find(site_.scenario.steps, StepKind::Remove, &OperationStep::kind);
    const std::array fragments{FragmentInPieces{wholes.front(), site_.kerfs, std::move(free), out}};
    return wanted_part(*step, site_.plan, held, fragments);
  }

  BlockSite site_{tests::along_scenario(40.0)};
  SiteWatch watch_{site_.scenario, site_.plan};
  /// Medial of the face at z = -4; 0.5 mm of that are the kerf's.
  PieceBody eminence_ = piece_at(1, {16.5, 0.0, -6.0}, {33.0, 13.0, 3.0});
  PieceBody crumb_ = piece_at(2, {10.0, 6.0, -4.8}, {0.4, 0.4, 0.4});
  PieceBody splinter_ = piece_at(3, {10.0, 0.0, -3.0}, {2.0, 2.0, 1.0});
};

TEST_F(ASawnBlock, IsMadeAsThisTestTakesIt) {
  const PlannedCut& cut = site_.plan.cuts.front();
  EXPECT_NEAR(cut.face.normal.z, -1.0, 1.0e-9);
  EXPECT_NEAR(cut.face.offset_mm, 4.0, 1.0e-9);
}

TEST_F(ASawnBlock, WithNothingFreeHasNothingToTakeOut) {
  EXPECT_THAT(wanted({}).pieces, IsEmpty());
  EXPECT_FALSE(wanted({}).is_off);
}

TEST_F(ASawnBlock, TheWasteIsWanted) {
  const WantedPart part = wanted({&eminence_});
  EXPECT_THAT(part.pieces, ElementsAre(1));
  EXPECT_TRUE(part.is_off);
}

TEST_F(ASawnBlock, ACrumbOfTheWasteGoesWithItInEitherOrderAndAloneIsNotThePiece) {
  EXPECT_THAT(wanted({&eminence_, &crumb_}).pieces, ElementsAre(1, 2));
  EXPECT_TRUE(wanted({&crumb_, &eminence_}).is_off);
  EXPECT_FALSE(wanted({&crumb_}).is_off);
}

TEST_F(ASawnBlock, ASplinterOfTheBoneThatStaysIsNeverOfIt) {
  EXPECT_THAT(wanted({&eminence_, &splinter_}).pieces, ElementsAre(1));
  EXPECT_THAT(wanted({&splinter_}).pieces, IsEmpty());
}

TEST_F(ASawnBlock, HalvesAreItTogether) {
  const PieceBody proximal = piece_at(1, {8.0, 0.0, -6.0}, {16.0, 13.0, 3.0});
  const PieceBody distal = piece_at(2, {24.5, 0.0, -6.0}, {17.0, 13.0, 3.0});
  EXPECT_FALSE(wanted({&proximal}).is_off);
  EXPECT_TRUE(wanted({&distal, &proximal}).is_off);
  EXPECT_TRUE(wanted({&proximal}, {distal.bvh.get()}).is_off) << "the other half is out already";
}

TEST_F(ASawnBlock, WhatIsOutIsOff) {
  const WantedPart part = wanted({}, {eminence_.bvh.get()});
  EXPECT_THAT(part.pieces, IsEmpty());
  EXPECT_TRUE(part.is_off);
}

TEST(WantedPart, IsTheWedgeOnceBothItsCutsAreBegun) {
  BlockSite site(tests::wedge_scenario(16.0));
  SiteWatch watch(site.scenario, site.plan);
  const auto step = std::ranges::find(site.scenario.steps, StepKind::Remove, &OperationStep::kind);
  const auto saw = [&](std::size_t cut) {
    simulator::CutEvent done;
    done.kind = simulator::CutEventKind::StepDone;
    done.subject = static_cast<std::int32_t>(cut);
    watch.apply(done, site.kerfs);
    const simulator::CutEvent frozen = site.freeze(cut);
    watch.apply(frozen, site.kerfs);
    site.saw(frozen.subject, 0.0, 13.2);
  };
  saw(0);
  // Near the base of the wedge, which is medial, in the middle of the bone's height.
  const Vec3 entry_mm =
      0.5 * (site.plan.cuts[0].entry_point_in_bone_mm + site.plan.cuts[1].entry_point_in_bone_mm);
  const Vec3 between_mm{entry_mm.x, 0.0, -5.0};
  const PieceBody wedge = piece_at(1, between_mm, {0.6, 12.0, 7.0});
  const auto wanted = [&] {
    const std::array wholes{simulator::SolidWithTree{site.whole, site.bvh}};
    const std::vector<HeldCut> held = watch.held(site.kerfs, wholes);
    const std::array fragments{FragmentInPieces{wholes.front(), site.kerfs, {&wedge}, {}}};
    return wanted_part(*step, site.plan, held, fragments);
  };
  EXPECT_THAT(wanted().pieces, IsEmpty());
  saw(1);
  EXPECT_THAT(wanted().pieces, ElementsAre(1));
}

}  // namespace
}  // namespace hallux::scenarios
