/// An attempt that somebody operates live: loop and recorder run beside the window until it is
/// finished or given up.
///
///     window  --commands, device target-->  thread of the attempt: loop at 1 kHz, then sealing
///             --what is on the screen----------->  |  rings
///             <--newest view, feed--------            |
///                                                recorder's thread -> database
///
/// What was recorded is kept, however it ends: finished it is sealed; abandoned it is marked as
/// interrupted, with an act; cut off with its window or stopped by a failure it stays as it is and
/// is found interrupted. A full disk stops nothing: the operation pauses and goes on by itself when
/// there is room (view().is_storage_full); also the sealing waits for it.
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "database/desks/trainee_desk.h"
#include "simulator/bone/whole_bone.h"
#include "ui/jobs/attempt_jobs.h"
#include "ui/jobs/commanded_loop.h"
#include "ui/jobs/noted_views.h"

namespace hallux::ui {

/// What is operated on, and what for.
struct PreparedCase {
  scenarios::Scenario scenario;
  /// Of the patient, the operated one first.
  std::vector<simulator::Bone> bones;
  /// Each part in the frame of its bone; and all in that of the first.
  scenarios::Plan plan, plan_in_first;
  /// By bone, for all who cut them.
  std::vector<std::unique_ptr<const simulator::WholeBone>> wholes;

  const simulator::Bone& bone() const noexcept { return bones.front(); }
};

/// Reads nothing and stores nothing: the plan is laid on the bones.
/// errors  ScenarioError
PreparedCase prepare_case(scenarios::Scenario scenario, std::vector<simulator::Bone> bones);
PreparedCase prepare_case(scenarios::Scenario scenario, simulator::Bone bone);
/// The scenario's patient is made before.
/// errors  ScenarioError, MeshError; Cancelled
PreparedCase prepare_case(const scenarios::Scenario& scenario, const StageProgress& progress);

/// What a trainee begins, at their own desk and with their own hand.
struct LiveBegin {
  database::ScenarioVersionId scenario;
  database::PersonId person;
  database::AttemptKind kind = database::AttemptKind::Practice;
  simulator::Guidance guidance = simulator::Guidance::None;
  /// What an arm is made to feel; another than the simulated one in practice only.
  simulator::ForceLaw force_law = simulator::ForceLaw::Simulated;
  std::string stereo_mode = "mono";
  /// As the device's description says it.
  std::string device_class = {};
  /// The kind's id, of the other hand; empty: none.
  std::string second_device = {};
};

/// Stores the patient and begins the attempt.
/// needs   an assessment feels the simulated force
/// errors  DatabaseError: Refused; BadInput where the scenario is not published; Full, ReadOnly ...
database::WriterLease begin_live(database::Database& database, database::TraineeDesk& desk,
                                 const LiveBegin& begin, const simulator::Bones& bones);

/// Device newtons per simulated newton where that device operates on it; nothing where the device
/// pushes nobody back.
std::optional<double> force_scale_of(const simulator::HapticDevice& device,
                                     const PreparedCase& prepared_case,
                                     simulator::Guidance guidance);

class LiveAttempt final : public CommandedLoop {
 public:
  /// Longer than this no attempt runs: the loop then ends it as finished.
  static constexpr std::int64_t ticks_at_most = 60 * 60 * 1000;

  /// Starts loop and recorder, with the clock running.
  /// begun   as it was begun
  /// needs   `prepared_case` outlives it
  LiveAttempt(std::shared_ptr<const PreparedCase> prepared_case, const database::Database& database,
              database::WriterLease lease, std::unique_ptr<simulator::HapticDevice> device,
              LiveBegin begun);
  /// Stops it where it still runs; what was recorded is committed.
  ~LiveAttempt() override;
  LiveAttempt(const LiveAttempt&) = delete;
  LiveAttempt& operator=(const LiveAttempt&) = delete;

  const database::AttemptId& attempt() const noexcept { return attempt_; }
  const PreparedCase& prepared_case() const noexcept { return *prepared_case_; }
  simulator::HapticDevice& device() noexcept { return *device_; }

  void abandon() override;
  bool is_storage_full() const noexcept override {
    return channels_.storage_full.load(std::memory_order_relaxed);
  }
  const LiveEnd* end() const noexcept override {
    return is_over_.load(std::memory_order_acquire) ? &end_ : nullptr;
  }

  const std::filesystem::path& directory() const noexcept { return directory_; }
  /// Of the database's log now.
  std::uintmax_t log_bytes() const noexcept;

  /// What is on the screen in this frame, drawn from the sample of that tick: kept beside the
  /// recording where it changed, so that a replay shows what was seen.
  /// thread  window
  void note_view(const simulator::ShownView& view, std::int64_t tick) noexcept {
    noted_views_.note(view, tick);
  }

 private:
  bool is_left() const noexcept;
  void run(database::Database database, database::WriterLease lease) noexcept;
  void operate(const database::Database& database, database::WriterLease lease);
  void fail(LiveFailure failure, const char* reason) noexcept;

  std::shared_ptr<const PreparedCase> prepared_case_;
  LiveBegin begun_;
  std::unique_ptr<simulator::HapticDevice> device_;
  simulator::AttemptChannels channels_;
  NotedViews noted_views_{channels_.display_facts};
  database::AttemptId attempt_;
  /// That is recorded into.
  std::filesystem::path directory_;
  /// The thread's until is_over_.
  LiveEnd end_;
  std::atomic<bool> is_stopping_{false}, is_abandoned_{false}, is_over_{false};
  /// Last: joined before any of it goes.
  std::jthread thread_;
};

}  // namespace hallux::ui
