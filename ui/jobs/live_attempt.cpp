#include "ui/jobs/live_attempt.h"

#include <exception>
#include <new>
#include <utility>

#include "database/store/log_size.h"
#include "scenarios/simulation_setup.h"
#include "scenarios/site/plan_in_first.h"

namespace hallux::ui {

PreparedCase prepare_case(scenarios::Scenario scenario, std::vector<simulator::Bone> bones) {
  PreparedCase prepared_case{std::move(scenario), std::move(bones), {}, {}, {}};
  prepared_case.plan = plan_on(prepared_case.scenario, prepared_case.bones);
  prepared_case.plan_in_first = scenarios::plan_in_first(prepared_case.plan, prepared_case.bones);
  for (const simulator::Bone& bone : prepared_case.bones)
    prepared_case.wholes.push_back(
        std::make_unique<const simulator::WholeBone>(simulator::solid_of(bone)));
  return prepared_case;
}

PreparedCase prepare_case(scenarios::Scenario scenario, simulator::Bone bone) {
  std::vector<simulator::Bone> bones;
  bones.push_back(std::move(bone));
  return prepare_case(std::move(scenario), std::move(bones));
}

PreparedCase prepare_case(const scenarios::Scenario& scenario, const StageProgress& progress) {
  return prepare_case(scenario, patient_of(scenario, progress));
}

database::WriterLease begin_live(database::Database& database, database::TraineeDesk& desk,
                                 const LiveBegin& begin, const simulator::Bones& bones) {
  CHECK(begin.kind == database::AttemptKind::Practice ||
        begin.force_law == simulator::ForceLaw::Simulated);
  database::NewAttempt begun;
  begun.scenario = begin.scenario;
  begun.person = begin.person;
  begun.kind = begin.kind;
  begun.guidance = begin.guidance;
  begun.device_class = begin.device_class;
  begun.pacing = "real_time";
  begun.stereo_mode = begin.stereo_mode;
  put_patient(database, bones, begun);
  return desk.begin_attempt(begun);
}

std::optional<double> force_scale_of(const simulator::HapticDevice& device,
                                     const PreparedCase& prepared_case,
                                     simulator::Guidance guidance) {
  const simulator::DeviceDescription description = device.description();
  if (!description.limits) return std::nullopt;
  return force_scale_on(
      *description.limits,
      description.motion_scale * simulation_setup(prepared_case.scenario, prepared_case.bones,
                                                  prepared_case.plan, guidance)
                                     .contact.coupling_newton_per_mm);
}

LiveAttempt::LiveAttempt(std::shared_ptr<const PreparedCase> prepared_case,
                         const database::Database& database, database::WriterLease lease,
                         std::unique_ptr<simulator::HapticDevice> device, LiveBegin begun)
    : CommandedLoop(force_scale_of(*device, *prepared_case, begun.guidance)),
      prepared_case_(std::move(prepared_case)),
      begun_(std::move(begun)),
      device_(std::move(device)),
      attempt_(lease.attempt()),
      directory_(database.directory()) {
  say({simulator::CommandKind::Start, 0, 0});
  thread_ = std::jthread([this, own = database.open_again(), lease = std::move(lease)]() mutable {
    run(std::move(own), std::move(lease));
  });
}

namespace {

/// The lease is back: whoever opens the file marks what was not sealed.
void mark_interrupted(const database::Database& database) noexcept {
  try {
    static_cast<void>(database::Database::open(database.directory()));
  } catch (const std::exception&) {
    // A full disk cannot be marked on either; the next start does it.
  }
}

}  // namespace

LiveAttempt::~LiveAttempt() {
  is_stopping_.store(true, std::memory_order_relaxed);
  channels_.gives_up.store(true, std::memory_order_relaxed);
}

std::uintmax_t LiveAttempt::log_bytes() const noexcept { return database::log_bytes(directory_); }

void LiveAttempt::abandon() {
  is_abandoned_.store(true, std::memory_order_release);
  channels_.gives_up.store(true, std::memory_order_relaxed);
  say({simulator::CommandKind::Abandon, 0, 0});
}

/// While the loop waits for a full disk it hears no command, so who abandons then is heard here.
bool LiveAttempt::is_left() const noexcept {
  const bool is_deaf = channels_.storage_full.load(std::memory_order_relaxed);
  return is_stopping_.load(std::memory_order_relaxed) ||
         (is_deaf && is_abandoned_.load(std::memory_order_relaxed));
}

void LiveAttempt::run(database::Database database, database::WriterLease lease) noexcept {
  try {
    end_.file = database.file();
    operate(database, std::move(lease));
  } catch (const database::DatabaseError& error) {
    const bool is_full = error.kind() == database::DatabaseErrorKind::Full;
    fail(is_full ? LiveFailure::DiskFull : LiveFailure::Other, error.what());
  } catch (const std::bad_alloc& error) {
    fail(LiveFailure::MemoryFull, error.what());
  } catch (const std::exception& error) {
    fail(LiveFailure::Other, error.what());
  }
  if (!end_.is_sealed) mark_interrupted(database);
  watch().closed.store(true, std::memory_order_release);
  is_over_.store(true, std::memory_order_release);
}

/// Where even the words find no memory, the kind of failure is left.
void LiveAttempt::fail(LiveFailure failure, const char* reason) noexcept {
  end_.failure = failure;
  try {
    end_.reason = reason;
  } catch (const std::bad_alloc&) {
    end_.failure = LiveFailure::MemoryFull;
  }
}

void LiveAttempt::operate(const database::Database& database, database::WriterLease lease) {
  database::Recorder recorder(database, std::move(lease), channels_,
                              database::FullDisk::IsWaitedFor);
  simulator::AttemptSetup setup{simulation_setup(prepared_case_->scenario, prepared_case_->bones,
                                                 prepared_case_->plan, begun_.guidance)};
  setup.pacing = simulator::Pacing::RealTime;
  setup.force_law = begun_.force_law;
  setup.last_tick = ticks_at_most;
  setup.watch = &watch();
  for (const auto& whole : prepared_case_->wholes) setup.wholes.push_back(whole.get());
  end_.loop = run_attempt(setup, *device_, channels_, [this](double) { return !is_left(); });
  end_.end = end_.loop.end;
  end_.recorder = recorder.drain();
  const bool is_finished = end_.end == simulator::AttemptEnd::Finished ||
                           end_.end == simulator::AttemptEnd::ReachedLastTick;
  if (is_abandoned_.load(std::memory_order_acquire)) {
    end_.recorder = recorder.abandon();
    return;
  }
  if (!is_finished) return;
  Quality quality = quality_of(end_.loop, end_.recorder);
  quality.device = device_->facts();
  quality.second_device = begun_.second_device;
  end_.recorder = recorder.finish(quality_json(quality));
  end_.is_sealed = true;
}

}  // namespace hallux::ui
