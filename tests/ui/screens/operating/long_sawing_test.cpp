// Memory while one operates: minutes of sawing in virtual time, through the loop with its jobs on
// their thread, the recorder, and the thread that makes the window's picture.
//
//     one kerf through the bone, which frees a piece that stays; then strokes into two others in
//     turn, each a little deeper than the one before and out of the bone in between, so that the
//     pieces are worked out again and again
//
// Memory is counted at the beginning of a stroke into the same kerf, where all threads have caught
// up and rest: what malloc has given out and not got back, and the pages that are left once malloc
// has returned what is free. The first counts every block; the second also sees what was reserved
// at the start and is touched later.
#include <gtest/gtest.h>
#include <malloc.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <functional>
#include <thread>

#include "database/recording/recorder.h"
#include "scenarios/simulation_setup.h"
#include "simulator/device/scripted.h"
#include "simulator/loop/attempt_loop.h"
#include "tests/ui/screens/operating/some_operation.h"
#include "ui/screens/operating/operation_work.h"
#include "ui/screens/operating/site/bone_being_cut.h"

namespace hallux::ui {
namespace {

using simulator::HandMotion;
using simulator::JobResult;
using simulator::StepOutput;

constexpr std::int64_t sawn_minutes = 31, minutes_between_looks = 10;
#ifdef HALLUX_LONG_RUNS
constexpr std::int64_t minute_ticks = 60'000, stroke_ticks = 6'000;
constexpr double edge_mm = 0.3;
constexpr std::size_t jobs_at_least = 100;
/// A tree over the bone, 19 MiB, is at hand or not, by which kerf rose last.
constexpr double allowed_in_use_mib = 24.0, allowed_resident_mib = 32.0;
#else
/// The same with minutes of four and a half seconds, on a coarse bone.
constexpr std::int64_t minute_ticks = 4'500, stroke_ticks = 3'000;
constexpr double edge_mm = 1.5;
constexpr std::size_t jobs_at_least = 25;
/// For what kerfs that are opened further take: their tiles, walls and patches. Where every result
/// of a job stays, this run takes 27 MiB.
constexpr double allowed_in_use_mib = 2.0, allowed_resident_mib = 6.0;
#endif

struct MemoryUse {
  double in_use_mib = 0.0, resident_mib = 0.0;
};

MemoryUse memory_use() {
  constexpr double mib = 1024.0 * 1024.0;
  const struct mallinfo2 heap = ::mallinfo2();
  ::malloc_trim(0);
  std::ifstream file("/proc/self/statm");
  double all = 0.0, resident = 0.0;
  file >> all >> resident;
  return {static_cast<double>(heap.uordblks + heap.hblkhd) / mib,
          resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) / mib};
}

/// When no thread takes or gives back anything for a fifth of a second.
MemoryUse memory_at_rest() {
  constexpr int wanted = 20;
  MemoryUse use = memory_use();
  for (int same = 0, looks = 0; same < wanted && looks < 6000; ++looks) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    const MemoryUse now = memory_use();
    same = now.in_use_mib == use.in_use_mib ? same + 1 : 0;
    use = now;
  }
  return use;
}

/// Jobs on their own thread. Virtual time waits for each, so that the same motion asks for the same
/// jobs on a machine that is busy.
class WaitedJobs final : public simulator::JobRunner {
 public:
  WaitedJobs(const simulator::WholeBone& whole, const simulator::SimulationSetup& setup)
      : jobs_({whole, setup.bone.world_from_bone}, setup.tray, setup.bridges) {}

  bool apply(const StepOutput& output) override {
    requests += output.requests.size();
    awaited_ += output.requests.size();
    return jobs_.apply(output);
  }
  bool has_room() const noexcept override { return jobs_.has_room(); }
  std::exception_ptr failure() const noexcept override { return jobs_.failure(); }
  JobResult* take_ready() noexcept override {
    while (awaited_ > 0 && failure() == nullptr) {
      if (JobResult* const result = jobs_.take_ready()) {
        --awaited_;
        return result;
      }
      std::this_thread::sleep_for(std::chrono::microseconds(100));
    }
    return nullptr;
  }

  std::size_t requests = 0;

 private:
  simulator::ThreadedJobs jobs_;
  std::size_t awaited_ = 0;
};

/// Beside the kerf that goes through.
struct Strokes {
  HandMotion motion;
  std::int64_t first_tick = 0, count = 0;

  /// In the air, before a stroke into the first of the two kerfs.
  bool is_between(std::int64_t tick) const noexcept {
    const std::int64_t since = tick - first_tick;
    return since > 0 && since / stroke_ticks % 2 == 0 && since % stroke_ticks < 600;
  }
};

/// All lie in the cut's plane or beside it on the waste's side.
Strokes strokes(const PreparedCase& prepared_case) {
  const scenarios::PlannedCut& cut = prepared_case.plan.cuts.front();
  const Vec3 normal = cut.face.normal;
  Vec3 feed = cut.exit_point_in_bone_mm - cut.entry_point_in_bone_mm;
  feed -= glm::dot(feed, normal) * normal;
  const double length_mm = length_of(feed);
  feed /= length_mm;
  const Quat rotation = rotation_from_axes(feed, glm::cross(normal, feed));
  Strokes made;
  const auto go_to = [&](std::int64_t tick, double beside_mm, double deep_mm,
                         double along_teeth_mm = 0.0) {
    const Vec3 tip_mm = cut.entry_point_in_bone_mm + beside_mm * normal + deep_mm * feed +
                        along_teeth_mm * glm::cross(normal, feed);
    made.motion.keys.push_back(
        {tick, prepared_case.bone().world_from_bone * RigidTransform{rotation, tip_mm},
         bit(simulator::Switch::SawRuns)});
  };
  constexpr double outermost_mm = 4.0;
  for (const double along_teeth_mm : {-3.5, 3.5}) {
    go_to(made.first_tick, outermost_mm, -6.0, along_teeth_mm);
    go_to(made.first_tick + 14000, outermost_mm, length_mm + 3.0, along_teeth_mm);
    go_to(made.first_tick + 20500, outermost_mm, length_mm + 3.0, along_teeth_mm);
    made.first_tick += 21500;
  }
  made.count = (sawn_minutes * minute_ticks - made.first_tick) / stroke_ticks;
  for (std::int64_t stroke = 0; stroke < made.count; ++stroke) {
    const std::int64_t tick = made.first_tick + stroke * stroke_ticks;
    const double beside_mm = 0.5 + 1.2 * static_cast<double>(stroke % 2);
    const double done = static_cast<double>(stroke) / static_cast<double>(made.count);
    const double deep_mm = 2.0 + 0.6 * length_mm * done;
    go_to(tick, beside_mm, -6.0);
    go_to(tick + 500, beside_mm, -1.0);
    go_to(tick + stroke_ticks - 1000, beside_mm, deep_mm);
    go_to(tick + stroke_ticks - 600, beside_mm, deep_mm);
    go_to(tick + stroke_ticks - 200, beside_mm, -6.0);
  }
  made.motion.commands = {{0, {simulator::CommandKind::Start, 0, 0}}};
  return made;
}

/// An attempt of Ada's that nobody looks at.
class LongSawing : public testing::Test {
 protected:
  database::WriterLease begin() {
    return signed_in_->in_turn([&](database::Session& session, database::Database& database) {
      database::TraineeDesk desk = *session.trainee();
      LiveBegin what;
      what.scenario = course_.version();
      what.person = signed_in_->person().id;
      return begin_live(database, desk, what, prepared_case_->bones);
    });
  }
  void follow(BoneBeingCut& shown) {
    scene_.bones.clear();
    shown.add_to(scene_);
    for (const simulator::CutEvent& event : shown.take_events()) {
      kerfs_ += event.kind == simulator::CutEventKind::PlaneFrozen ? 1 : 0;
      pieces_ += event.kind == simulator::CutEventKind::PieceFreed ? 1 : 0;
    }
  }
  /// All that the loop gave out has arrived.
  void catch_up(BoneBeingCut& shown) {
    const auto has_arrived = [&] {
      follow(shown);
      return watch_.feed.size() == 0 && channels_.samples.size() == 0 && shown.is_up_to_date();
    };
    ASSERT_TRUE(soon(has_arrived));
    ASSERT_FALSE(shown.has_failed());
  }

  OperableCourse course_{"silver", edge_mm};
  const std::shared_ptr<SignedInSession> signed_in_ = course_.visit_of_ada();
  const std::shared_ptr<const PreparedCase> prepared_case_ = course_.prepared_case(*signed_in_);
  simulator::AttemptChannels channels_;
  simulator::AttemptWatch watch_;
  Scene scene_;
  int kerfs_ = 0, pieces_ = 0;
};

TEST_F(LongSawing, TakesNoMoreMemoryTheLongerItLasts) {
  // As the program does, and one heap: pages that threads leave behind would hide what is in use.
  ::mallopt(M_ARENA_MAX, 1);
  ::mallopt(M_MMAP_THRESHOLD, 1 << 20);
  const simulator::SimulationSetup simulated =
      simulation_setup(prepared_case_->scenario, prepared_case_->bones, prepared_case_->plan,
                       simulator::Guidance::None);
  WaitedJobs jobs(*prepared_case_->wholes.front(), simulated);
  simulator::AttemptSetup setup{simulated};
  setup.watch = &watch_;
  setup.job_runner = &jobs;
  const Strokes sawn = strokes(*prepared_case_);
  setup.commands = sawn.motion.commands;
  setup.last_tick = sawn_minutes * minute_ticks;
  simulator::ScriptedDevice device(sawn.motion);
  database::Recorder recorder(course_.course().database(), begin(), channels_);
  BoneBeingCut shown(recorder.attempt().text, *prepared_case_, watch_,
                     pictures_of(prepared_case_, course_.course().database().directory()));

  std::vector<MemoryUse> looks;
  const auto progress = [&](double fraction) {
    follow(shown);
    const auto tick = static_cast<std::int64_t>(fraction * static_cast<double>(setup.last_tick));
    const auto minute = static_cast<std::int64_t>(looks.size() + 1) * minutes_between_looks;
    if (tick < minute * minute_ticks || !sawn.is_between(tick)) return true;
    catch_up(shown);
    looks.push_back(memory_at_rest());
    std::printf("minute %d: %.1f MiB in use, %.1f resident; %zu jobs, %d kerfs, %d pieces\n",
                static_cast<int>(minute), looks.back().in_use_mib, looks.back().resident_mib,
                jobs.requests, kerfs_, pieces_);
    return !HasFatalFailure();
  };
  const simulator::LoopStatistics loop = run_attempt(setup, device, channels_, progress);
  recorder.drain();

  EXPECT_EQ(loop.end, simulator::AttemptEnd::ReachedLastTick);
  EXPECT_EQ(kerfs_, 3);
  EXPECT_EQ(pieces_, 1);
  EXPECT_GE(jobs.requests, jobs_at_least);
  ASSERT_EQ(looks.size(), 3U);
  EXPECT_LE(looks.back().in_use_mib, looks.front().in_use_mib + allowed_in_use_mib);
#ifndef __SANITIZE_THREAD__  // what it notes of each address is resident, too
  EXPECT_LE(looks.back().resident_mib, looks.front().resident_mib + allowed_resident_mib);
#endif
}

}  // namespace
}  // namespace hallux::ui
