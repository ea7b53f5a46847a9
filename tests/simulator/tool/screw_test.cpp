#include "simulator/tool/screw.h"

#include <gtest/gtest.h>

namespace hallux::simulator {
namespace {

TEST(Screw, OfTheTrayIsMade) {
  EXPECT_TRUE(is_made(Screw{}));
  for (const Screw& screw : cortical_screws)
    EXPECT_TRUE(is_made(screw)) << screw.thread_diameter_mm;
}

TEST(Screw, BesideWhatIsMadeIsNone) {
  EXPECT_FALSE(is_made(Screw{.pitch_mm = 0.0}));
  EXPECT_FALSE(is_made(Screw{.length_mm = 100.0}));
  EXPECT_FALSE(is_made(Screw{.head_height_mm = 6.0}));
}

TEST(Screw, WhosePartsDoNotFitIsNone) {
  EXPECT_FALSE(is_made(Screw{.shaft_diameter_mm = 2.1}));
  EXPECT_FALSE(is_made(Screw{.pilot_diameter_mm = 2.7}));
  EXPECT_FALSE(is_made(Screw{.glide_diameter_mm = 2.6}));
  EXPECT_FALSE(is_made(Screw{.head_diameter_mm = 2.6}));
}

}  // namespace
}  // namespace hallux::simulator
