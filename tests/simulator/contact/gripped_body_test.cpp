/// A piece in the forceps above a block: what it meets by points that are not among the foremost.
#include "simulator/contact/gripped_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

constexpr double edge_mm = 20.0;
/// Below the rim of the piece, or above the block.
constexpr double tip_mm = 0.4;

/// Along the rim of a square of 20 mm, at that height.
std::vector<Vec3> rim(std::size_t count, double y_mm) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double along_mm =
        4.0 * edge_mm * static_cast<double>(i) / static_cast<double>(count) - 2.0 * edge_mm;
    const double on_side_mm = std::fmod(along_mm + 2.0 * edge_mm, edge_mm) - 0.5 * edge_mm;
    const double other_mm = along_mm < 0.0 ? -0.5 * edge_mm : 0.5 * edge_mm;
    const bool is_along_x = std::fabs(along_mm) > edge_mm;
    points.emplace_back(is_along_x ? on_side_mm : other_mm, y_mm,
                        is_along_x ? other_mm : on_side_mm);
  }
  return points;
}

/// The block below y = 0, and the piece above it, held at its rim from 1 mm above.
class PieceAboveBlock : public testing::Test {
 protected:
  PieceAboveBlock() {
    gripped_->surface = &piece_;
    gripped_->wound_from_piece = {Quat{1.0, 0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
    gripped_->handle_from_piece = gripped_->wound_from_piece;
    gripped_->centroid_mm = {0.0, 5.0, 0.0};
  }

  void begin(std::vector<Vec3> own_mm, std::vector<Vec3> met_mm) {
    own_mm_ = std::move(own_mm);
    met_mm_ = std::move(met_mm);
    gripped_->points_mm = own_mm_;
    gripped_->others.push({&block_, met_mm_, {}, {}});
    choose_points(*gripped_);
  }
  /// Down by 2 mm in half a second, and held there; the height of the piece.
  double height_when_pressed_mm() {
    for (int tick = 0; tick < 700; ++tick) {
      const double down_mm = std::min(2.0, 0.004 * tick);
      move_gripped(*gripped_, {Quat{1.0, 0.0, 0.0, 0.0}, {0.0, -down_mm, 0.0}}, std::nullopt, {});
    }
    return gripped_->wound_from_piece.translation_mm.y;
  }

  Bvh block_{tests::moved(tests::solid_block({edge_mm, 10.0, edge_mm}),
                          {Quat{1.0, 0.0, 0.0, 0.0}, {0.0, -5.0, 0.0}})};
  Bvh piece_{tests::moved(tests::solid_block({edge_mm, 10.0, edge_mm}),
                          {Quat{1.0, 0.0, 0.0, 0.0}, {0.0, 5.0, 0.0}})};
  std::vector<Vec3> own_mm_, met_mm_;
  std::unique_ptr<GrippedBody> gripped_ = std::make_unique<GrippedBody>();
};

TEST_F(PieceAboveBlock, RestsOnItsForemostPoints) {
  begin(rim(64, 0.0), {});
  EXPECT_NEAR(height_when_pressed_mm(), 0.005, 0.003);
}

TEST_F(PieceAboveBlock, RestsOnATipThatIsTheLastOfItsPoints) {
  std::vector<Vec3> own = rim(gripped_point_limit - 1, 0.0);
  own.emplace_back(0.3, -tip_mm, 0.2);
  begin(std::move(own), {});
  EXPECT_NEAR(height_when_pressed_mm(), tip_mm, 0.01);
}

TEST_F(PieceAboveBlock, RestsOnATipOfTheBlockThatIsTheLastOfItsPoints) {
  std::vector<Vec3> met = rim(gripped_point_limit - 1, -3.0);
  met.emplace_back(0.3, tip_mm, 0.2);
  begin(rim(64, 0.0), std::move(met));
  EXPECT_NEAR(height_when_pressed_mm(), tip_mm, 0.01);
}

TEST(AskedPoints, FindEveryPointInTurnAndGiveItTheSlotOfTheFurthest) {
  AskedPoints asked(gripped_point_limit);
  ASSERT_TRUE(asked.has_more());
  std::vector<bool> is_found(gripped_point_limit, false);
  for (std::size_t i = 0; i < gripped_point_limit; ++i) is_found[asked.next()] = true;
  EXPECT_EQ(std::count(is_found.begin(), is_found.end(), true),
            static_cast<std::ptrdiff_t>(gripped_point_limit));
  const auto away = [](std::size_t point) { return point == 7 ? 5.0 : 1.0; };
  EXPECT_EQ(asked.take_in(200, away), 7U);
  EXPECT_EQ(asked.slots()[7], 200U);
  EXPECT_EQ(asked.take_in(200, away), asked.slots().size()) << "it has one";
}

TEST(AskedPoints, OfFewAllHaveASlot) {
  const AskedPoints asked(5);
  EXPECT_EQ(asked.slots().size(), 5U);
  EXPECT_FALSE(asked.has_more());
  EXPECT_FALSE(AskedPoints{}.has_more());
}

}  // namespace
}  // namespace hallux::simulator
