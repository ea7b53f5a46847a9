#include "scenarios/hands/motion_writer.h"

#include <algorithm>
#include <cmath>

#include "simulator/base/elementary.h"
#include "simulator/base/units.h"

namespace hallux::scenarios {

namespace {

constexpr std::int64_t key_ticks = 20;  ///< a key every 20 ms carries the wander

std::int64_t key_count(double way_mm, double speed_mm_s) {
  const double keys = std::ceil(way_mm / speed_mm_s / step_s / static_cast<double>(key_ticks));
  return std::max<std::int64_t>(1, static_cast<std::int64_t>(keys));
}

}  // namespace

Wander::Wander(Random random) {
  for (Wave& wave : waves_) {
    wave.rate_rad_s = 2.0 * pi * random.uniform(0.15, 0.9);
    wave.phase_rad = 2.0 * pi * random.uniform();
  }
}

double Wander::at(double time_s) const {
  double sum = 0.0;
  for (const Wave& wave : waves_) {
    const double angle_rad = wave.rate_rad_s * time_s + wave.phase_rad;
    sum += elementary::sin(angle_rad);
  }
  return sum / 3.0;
}

MotionWriter::MotionWriter(const RigidTransform& world_from_blade, const HandSkill& skill,
                           std::uint64_t seed)
    : world_from_blade_(world_from_blade),
      skill_(skill),
      out_(Random(seed, "wander.out")),
      tilt_x_(Random(seed, "wander.tilt_x")),
      tilt_y_(Random(seed, "wander.tilt_y")) {}

void MotionWriter::place(double feed_mm, double along_mm) {
  feed_mm_ = feed_mm;
  along_mm_ = along_mm;
  write_key();
}

void MotionWriter::turn_to(const RigidTransform& world_from_blade, double feed_mm, double along_mm,
                           double speed_mm_s) {
  const Vec3 from_mm = pose().translation_mm;
  world_from_blade_ = world_from_blade;
  feed_mm_ = feed_mm;
  along_mm_ = along_mm;
  wander_ = 0.0;
  set_jitter(0.0, 0.0);
  const Vec3 way = pose().translation_mm - from_mm;
  // One straight way: the device goes along it at the speed that the two keys' ticks give.
  tick_ += key_ticks * key_count(std::sqrt(glm::dot(way, way)), speed_mm_s);
  write_key();
}

void MotionWriter::go_to(double feed_mm, double along_mm, double speed_mm_s, double wander_from,
                         double wander_to) {
  const double way_mm = std::max(std::abs(feed_mm - feed_mm_), std::abs(along_mm - along_mm_));
  const std::int64_t keys = key_count(way_mm, speed_mm_s);
  const double from_feed_mm = feed_mm_, from_along_mm = along_mm_;
  for (std::int64_t i = 1; i <= keys; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(keys);
    feed_mm_ = from_feed_mm + share * (feed_mm - from_feed_mm);
    along_mm_ = from_along_mm + share * (along_mm - from_along_mm);
    wander_ = wander_from + share * (wander_to - wander_from);
    tick_ += key_ticks;
    write_key();
  }
}

void MotionWriter::push_through(const std::vector<FeedMoment>& moments,
                                double coupling_newton_per_mm) {
  const double duration_s = moments.back().time_s;
  const auto keys = static_cast<std::int64_t>(duration_s / step_s) / key_ticks + 1;
  std::size_t next = 0;
  double lead_mm = 0.0;
  for (std::int64_t i = 1; i <= keys; ++i) {
    const double time_s = second_from_tick(i * key_ticks);
    while (next + 1 < moments.size() && moments[next + 1].time_s <= time_s) ++next;
    const double wanted_mm = moments[next].push_newton / coupling_newton_per_mm;
    const double most_mm = lean_mm_s * second_from_tick(key_ticks);
    lead_mm += std::clamp(wanted_mm - lead_mm, -most_mm, most_mm);
    feed_mm_ = moments[next].feed_mm + lead_mm;
    // A hand starts its kerf with care: it wanders once the blade is held by the bone.
    wander_ =
        std::clamp(0.4 * (time_s - 2.0), 0.0, std::min(1.0, 0.3 + 0.5 * (duration_s - time_s)));
    tick_ += key_ticks;
    write_key();
  }
}

void MotionWriter::wait(double time_s) {
  const auto keys = static_cast<std::int64_t>(time_s / step_s) / key_ticks;
  for (std::int64_t i = 0; i < keys; ++i) {
    tick_ += key_ticks;
    write_key();
  }
}

void MotionWriter::set_jitter(double out_mm, double tilt_rad) {
  jitter_mm_ = out_mm;
  jitter_rad_ = tilt_rad;
}

void MotionWriter::say(simulator::CommandKind kind, std::int32_t argument) {
  motion_.commands.push_back({tick_, {kind, argument, 0}});
}

RigidTransform MotionWriter::pose() const {
  const double time_s = second_from_tick(tick_);
  const double tilt_x = jitter_rad_ + wander_ * skill_.wander_rad * tilt_x_.at(time_s);
  const double tilt_y = wander_ * skill_.wander_rad * tilt_y_.at(time_s);
  const double out_mm = jitter_mm_ + wander_ * skill_.wander_mm * out_.at(time_s);
  const RigidTransform blade_from_handle{normalised(Quat{1.0, 0.5 * tilt_x, 0.5 * tilt_y, 0.0}),
                                         Vec3{feed_mm_, along_mm_, out_mm}};
  return world_from_blade_ * blade_from_handle;
}

void MotionWriter::write_key() {
  const std::uint32_t saw = saw_runs_ ? static_cast<std::uint32_t>(simulator::Switch::SawRuns) : 0U;
  motion_.keys.push_back({tick_, pose(), saw});
}

}  // namespace hallux::scenarios
