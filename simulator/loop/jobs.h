/// Where jobs run: at once on the caller's thread (virtual time, replay), or on a worker beside the
/// haptic thread. Inside this corner only.
///
/// Both apply the same outputs in the same order, so the same request gives the same result; only
/// the tick at which it is ready differs, and that tick is recorded. What the step gives back goes
/// the way of its outputs and is freed where jobs run.
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <exception>
#include <memory>
#include <optional>
#include <span>
#include <thread>
#include <variant>
#include <vector>

#include "simulator/contact/tissue.h"
#include "simulator/jobs/geometry_job.h"
#include "simulator/loop/lent_results.h"
#include "simulator/record/ring.h"
#include "simulator/step/simulation.h"

namespace hallux::simulator {

/// The tissues of an operation's bones, which the step asks.
class TissueMaps {
 public:
  explicit TissueMaps(std::span<const Bone* const> bones);

  std::span<const TissueMap* const> all() const noexcept { return maps_; }

 private:
  std::deque<TissueMap> made_;
  std::vector<const TissueMap*> maps_;
};

/// Their solids and trees, which the jobs cut.
class WholeBones {
 public:
  /// had  by bone, where somebody has the first ones already; borrowed
  explicit WholeBones(const SimulationSetup& setup, std::span<const WholeBone* const> had = {});

  std::span<const BoneToCut> all() const noexcept { return bones_; }

 private:
  std::vector<std::unique_ptr<const WholeBone>> own_;
  std::vector<BoneToCut> bones_;
};

class JobRunner {
 public:
  virtual ~JobRunner() = default;
  /// Takes over what a step gave out, and results that it gave back; false where there was no room
  /// left.
  /// errors  std::bad_alloc where jobs run at once; none on the threaded runner, which allocates
  ///         nothing here
  /// thread  haptic
  virtual bool apply(const StepOutput& output) = 0;
  /// What a job on another thread threw, or nothing; no job runs after it.
  virtual std::exception_ptr failure() const noexcept { return nullptr; }
  /// Whether a second's outputs still find room; without it the attempt must pause.
  /// thread  haptic
  virtual bool has_room() const noexcept = 0;
  /// The next result that is ready, or null. Lives until the step gives it back, at most as long as
  /// the runner.
  virtual JobResult* take_ready() noexcept = 0;
};

/// Runs each job when it is asked for; ready at the next tick.
class ImmediateJobs final : public JobRunner {
 public:
  ImmediateJobs(const Bone& bone, const Tray& tray, const PlannedBridges& bridges = {})
      : geometry_(bone, tray, bridges) {}
  /// Borrows the bones' solids and their trees.
  ImmediateJobs(std::span<const BoneToCut> bones, const Tray& tray,
                const PlannedBridges& bridges = {})
      : geometry_(bones, tray, bridges) {}

  bool apply(const StepOutput& output) override;
  bool has_room() const noexcept override { return true; }
  JobResult* take_ready() noexcept override;
  /// The result of that job, or null where none of that number is ready; each is taken once.
  JobResult* take(std::int32_t job) noexcept;
  const AttemptGeometry& geometry() const noexcept { return geometry_; }
  /// Results that the step has not given back.
  std::size_t kept_count() const noexcept { return results_.count(); }

 private:
  AttemptGeometry geometry_;
  LentResults results_;
  std::deque<JobResult*> ready_;
};

/// Runs jobs on a thread of its own, in the order of their requests.
class ThreadedJobs final : public JobRunner {
 public:
  /// Borrows the bones' solids and their trees.
  ThreadedJobs(std::span<const BoneToCut> bones, const Tray& tray,
               const PlannedBridges& bridges = {});
  ThreadedJobs(const BoneToCut& bone, const Tray& tray, const PlannedBridges& bridges = {})
      : ThreadedJobs(std::span(&bone, 1), tray, bridges) {}
  ~ThreadedJobs() override;

  bool apply(const StepOutput& output) override;
  bool has_room() const noexcept override;
  std::exception_ptr failure() const noexcept override;
  JobResult* take_ready() noexcept override;

 private:
  using Feed = std::variant<ToolSample, CutEvent, JobRequest, const JobResult*>;
  void work(const std::stop_token& stop);
  void apply(const Feed& feed, const std::stop_token& stop);

  /// Worker's.
  AttemptGeometry geometry_;
  /// Worker's.
  LentResults results_;
  Ring<Feed> feed_;
  Ring<JobResult*> ready_;
  /// Written before has_failed_ is set.
  std::exception_ptr thrown_;
  std::atomic<bool> has_failed_{false};
  std::jthread worker_;
};

}  // namespace hallux::simulator
