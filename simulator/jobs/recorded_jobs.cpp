#include "simulator/jobs/recorded_jobs.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <span>

namespace hallux::simulator {

namespace {

std::span<const CutEvent> events_at(const Recording& recording, std::int64_t tick) {
  const auto first =
      std::partition_point(recording.events.begin(), recording.events.end(),
                           [tick](const CutEvent& event) { return event.tick < tick; });
  const auto last = std::partition_point(
      first, recording.events.end(), [tick](const CutEvent& event) { return event.tick == tick; });
  return {first, last};
}

bool has_event(std::span<const CutEvent> events, CutEventKind kind, std::int32_t subject) {
  return std::any_of(events.begin(), events.end(), [&](const CutEvent& event) {
    return event.kind == kind && event.subject == subject;
  });
}

bool has_any(std::span<const CutEvent> events, CutEventKind kind) {
  return std::any_of(events.begin(), events.end(),
                     [kind](const CutEvent& event) { return event.kind == kind; });
}

bool has_hinge(std::span<const CutEvent> events) {
  return has_any(events, CutEventKind::HingeClosed) || has_any(events, CutEventKind::HingeRefused);
}

/// Names the jobs of one line of the tape after the other.
class JobNames {
 public:
  JobNames(const Recording& recording, std::size_t bones)
      : recording_(recording), own_pieces_(bones) {
    std::iota(own_pieces_.begin(), own_pieces_.end(), 0);
  }

  void take(const TapeLine& line, std::vector<RecordedJob>& jobs) {
    const std::int64_t tick = line.tick + line.ticks - 1;
    const std::span<const CutEvent> said = events_at(recording_, tick);
    bool has_unnamed_hinge = has_hinge(said);
    std::optional<std::int32_t> unnamed_grip = gripped_by(said);
    for (std::size_t i = 0; i < line.command_count && i < commands_per_tick; ++i) {
      const Command& command = line.commands[i];
      if (command.kind == CommandKind::CloseHinge) hinge_ = command.argument;
      if (command.kind != CommandKind::ApplyJob) continue;
      RecordedJob job{{command.argument, JobKind::Pieces, -1, command.detail}, tick};
      if (const std::optional<std::int32_t> kerf = section_of(command.detail, said)) {
        job.request.kind = JobKind::Section;
        job.request.subject = *kerf;
      } else if (has_unnamed_hinge) {
        job.request.kind = JobKind::Hinge;
        job.request.subject = hinge_;
        has_unnamed_hinge = false;
      } else if (unnamed_grip) {
        job.request.kind = JobKind::Grip;
        job.request.subject = *unnamed_grip;
        unnamed_grip.reset();
      }
      jobs.push_back(job);
    }
  }

 private:
  /// The piece that these events grip, if they do.
  std::optional<std::int32_t> gripped_by(std::span<const CutEvent> said) {
    std::optional<std::int32_t> piece;
    for (const CutEvent& event : said) {
      if (event.kind == CutEventKind::FragmentParted) own_pieces_.push_back(event.subject);
      const auto fragment = static_cast<std::size_t>(event.subject);
      if (event.kind == CutEventKind::Gripped && fragment < own_pieces_.size())
        piece = own_pieces_[fragment];
    }
    return piece;
  }

  /// The kerf that was frozen at that tick and whose section is known by these events, once.
  std::optional<std::int32_t> section_of(std::int64_t tick, std::span<const CutEvent> said) {
    for (const CutEvent& event : events_at(recording_, tick)) {
      if (event.kind != CutEventKind::PlaneFrozen) continue;
      const bool is_known = std::find(known_.begin(), known_.end(), event.subject) != known_.end();
      if (is_known || !has_event(said, CutEventKind::SectionKnown, event.subject)) continue;
      known_.push_back(event.subject);
      return event.subject;
    }
    return std::nullopt;
  }

  const Recording& recording_;
  std::vector<std::int32_t> known_;
  /// Of each fragment, the number that it has as a piece.
  std::vector<std::int32_t> own_pieces_;
  /// Asked for last.
  std::int32_t hinge_ = 0;
};

}  // namespace

std::vector<RecordedJob> recorded_jobs(const Recorded& recorded, std::size_t bones) {
  std::vector<RecordedJob> jobs;
  JobNames names(recorded.outputs, bones);
  recorded.tape.visit([&](const TapeLine& line) {
    if (line.command_count > 0) names.take(line, jobs);
  });
  return jobs;
}

}  // namespace hallux::simulator
