/// Sweeps of a straight thrust, written into a folder of the test's own.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "ui/jobs/kerf_frames.h"

namespace hallux::tests {

/// A blade 13 mm wide and 40 mm deep that goes straight from 20 mm before `tip_mm` to it.
struct Thrust {
  Vec3 tip_mm{0.0, 0.0, 0.0};
  /// Unit.
  Vec3 direction{0.0, 1.0, 0.0};
  int poses = 2;
};

class SweepFiles : public testing::Test {
 protected:
  SweepFiles() {
    std::string name = (std::filesystem::temp_directory_path() / "hallux-sweeps-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~SweepFiles() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  std::filesystem::path sweep(const Thrust& thrust) {
    nlohmann::json poses = nlohmann::json::array();
    for (int i = 0; i < thrust.poses; ++i) {
      const double back_mm = 20.0 * (1.0 - static_cast<double>(i) / (thrust.poses - 1));
      const Vec3 tip_mm = thrust.tip_mm - back_mm * thrust.direction;
      poses.push_back(
          {{"tip", {tip_mm.x, tip_mm.y, tip_mm.z}},
           {"direction", {thrust.direction.x, thrust.direction.y, thrust.direction.z}}});
    }
    std::filesystem::path file = folder_ / ("sweep-" + std::to_string(++file_count_) + ".json");
    std::ofstream(file) << nlohmann::json{{"blade", {{"width_mm", 13.0}, {"depth_mm", 40.0}}},
                                          {"poses", poses}};
    return file;
  }

  std::filesystem::path folder_;
  int file_count_ = 0;
};

}  // namespace hallux::tests
