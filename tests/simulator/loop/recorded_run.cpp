#include "tests/simulator/loop/recorded_run.h"

#include <chrono>
#include <thread>

#include "simulator/base/progress.h"
#include "simulator/record/drain.h"
#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::tests {

using simulator::AttemptChannels;
using simulator::Bone;
using simulator::CommandKind;
using simulator::HandMotion;
using simulator::Recording;
using simulator::TapeLine;

namespace {

void empty_rings(AttemptChannels& channels, Recording& recording) {
  for (;;) {
    // Asked before the rings: what was pushed before closing is then still taken.
    const bool is_closed = channels.closed.load(std::memory_order_acquire);
    const bool took_any = drain(channels, recording);
    if (is_closed && !took_any) return;
    if (!took_any) std::this_thread::sleep_for(std::chrono::microseconds{200});
  }
}

}  // namespace

Bone loop_block() { return cancellous_bone(solid_block({20.0, 2.4, 6.0})); }

HandMotion sawing_motion(const Bone& bone, std::int64_t last_tick) {
  const auto world_from_handle = [&](double y_mm) {
    return bone.world_from_bone * blade_down({5.0, y_mm, 0.2}, 0.05);
  };
  HandMotion motion;
  motion.keys = {{0, world_from_handle(2.0), saw_runs},
                 {last_tick / 10, world_from_handle(-8.0), saw_runs},
                 {last_tick * 9 / 10, world_from_handle(-9.0), saw_runs},
                 {last_tick, world_from_handle(5.0), saw_runs}};
  motion.commands = {{0, {CommandKind::Start, 0, 0}}, {last_tick, {CommandKind::Finish, 0, 0}}};
  return motion;
}

simulator::AttemptSetup setup_for(const Bone& bone, const HandMotion& motion,
                                  std::int64_t last_tick) {
  return {.simulation = {bone}, .commands = motion.commands, .last_tick = last_tick};
}

RecordedRun record(const simulator::AttemptSetup& setup, simulator::HapticDevice& device,
                   std::size_t ring_capacity, const Progress& progress) {
  AttemptChannels channels(ring_capacity);
  return record(setup, device, channels, progress);
}

RecordedRun record(const simulator::AttemptSetup& setup, simulator::HapticDevice& device,
                   AttemptChannels& channels, const Progress& progress) {
  RecordedRun run;
  std::jthread recorder([&] { empty_rings(channels, run.recording); });
  run.statistics = run_attempt(setup, device, channels, progress);
  recorder.join();
  return run;
}

Digest digest_of_tape(const Recording& recording) noexcept {
  Digester digester;
  for (const TapeLine& line : recording.tape) {
    for (const std::int64_t value : columns_of(line)) digester.add_int(value);
  }
  return digester.finish();
}

}  // namespace hallux::tests
