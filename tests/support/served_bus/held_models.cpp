#include "tests/support/served_bus/held_models.h"

#include <algorithm>
#include <cmath>

#include "simulator/base/units.h"
#include "tests/support/served_bus/falcon_counts.h"

namespace hallux::tests {

namespace {

using simulator::arm_motors;
using simulator::ArmCounts;
using simulator::ArmGeometry;

/// The force whose work on each way is that of the torque beside it.
Vec3 force_of(const std::array<Vec3, 3>& ways, const Vec3& works) {
  const Vec3 weighted = works.x * glm::cross(ways[1], ways[2]) +
                        works.y * glm::cross(ways[2], ways[0]) +
                        works.z * glm::cross(ways[0], ways[1]);
  return weighted / glm::dot(ways[0], glm::cross(ways[1], ways[2]));
}

/// How the grip goes for a count of each motor's encoder [mm].
std::array<Vec3, 3> ways_of(const ArmGeometry& geometry, const ArmCounts& counts) {
  constexpr std::int32_t step = 4;
  std::array<Vec3, 3> ways{};
  for (std::size_t joint = 0; joint < arm_motors; ++joint) {
    ArmCounts after = counts, before = counts;
    after[joint] += step;
    before[joint] -= step;
    ways[joint] =
        (grip_pose(geometry, after).translation_mm - grip_pose(geometry, before).translation_mm) /
        (2.0 * step);
  }
  return ways;
}

Vec3 falcon_force(const FalconModel& falcon, const HeldGrip& grip, double counts_per_newton_metre) {
  const Vec3 grip_mm = simulator::falcon_middle_mm + grip.arm.place_mm;
  const simulator::CrankRates rates =
      simulator::crank_rates(grip_mm, simulator::crank_angles(grip_mm).value());
  Vec3 force_newton{0.0, 0.0, 0.0};
  for (std::size_t leg = 0; leg < simulator::falcon_legs; ++leg) {
    force_newton -= 1000.0 * falcon.motors()[leg] / counts_per_newton_metre * rates[leg];
  }
  return force_newton;
}

ArmCounts counts_of(const ArmModel& board) {
  ArmCounts counts{};
  std::copy(board.encoders.begin(), board.encoders.end(), counts.begin());
  return counts;
}

Vec3 arm_force(const ArmModel& board, const ArmGeometry& geometry) {
  Vec3 works{0.0, 0.0, 0.0};
  for (std::size_t joint = 0; joint < arm_motors; ++joint) {
    const double turn_rad = 2.0 * pi / geometry.counts_per_turn[joint];
    works[static_cast<glm::length_t>(joint)] =
        0.001 * board.currents_ma[joint] * geometry.torque_newton_mm_per_ampere[joint] * turn_rad;
  }
  return force_of(ways_of(geometry, counts_of(board)), works);
}

/// Leads the encoders to where the grip is.
void follow(ArmModel& board, const ArmGeometry& geometry, const Vec3& grip_mm) {
  for (int tries = 0; tries < 3; ++tries) {
    const ArmCounts counts = counts_of(board);
    const std::array<Vec3, 3> ways = ways_of(geometry, counts);
    const Vec3 missing_mm = grip_mm - grip_pose(geometry, counts).translation_mm;
    const double volume = glm::dot(ways[0], glm::cross(ways[1], ways[2]));
    const Vec3 steps = Vec3(glm::dot(missing_mm, glm::cross(ways[1], ways[2])),
                            glm::dot(missing_mm, glm::cross(ways[2], ways[0])),
                            glm::dot(missing_mm, glm::cross(ways[0], ways[1]))) /
                       volume;
    for (std::size_t joint = 0; joint < arm_motors; ++joint) {
      board.encoders[joint] = static_cast<std::int16_t>(
          board.encoders[joint] + std::lround(steps[static_cast<glm::length_t>(joint)]));
    }
  }
}

}  // namespace

void HeldGrip::pass(const Vec3& force_newton) {
  send_force(arm, force_newton);
  advance(arm, traits, hand);
  least_of_motors_millijoule = std::min(least_of_motors_millijoule, -arm.work.of_motors_millijoule);
}

void hold(FalconModel& falcon, HeldGrip& grip, double counts_per_newton_metre) {
  falcon.run();
  falcon.is_homed = true;
  falcon.on_packet = [&grip, counts_per_newton_metre](FalconModel& held) {
    grip.pass(falcon_force(held, grip, counts_per_newton_metre));
    held.encoders =
        falcon_counts_at(simulator::falcon_middle_mm + read_encoders(grip.arm, grip.traits));
  };
}

void hold(ArmModel& board, HeldGrip& grip, const ArmGeometry& geometry) {
  board.encoders = {0, 3000, 6000, 0, 0, 0};
  const Vec3 middle_mm = grip_pose(geometry, counts_of(board)).translation_mm;
  board.on_report = [&grip, &geometry, middle_mm](ArmModel& held) {
    grip.pass(arm_force(held, geometry));
    follow(held, geometry, middle_mm + read_encoders(grip.arm, grip.traits));
  };
}

}  // namespace hallux::tests
