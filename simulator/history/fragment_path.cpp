#include "simulator/history/fragment_path.h"

#include <algorithm>

#include "simulator/record/fragment_poses.h"

namespace hallux::simulator {

namespace {

bool is_of_fragments(CutEventKind kind) noexcept {
  switch (kind) {
    case CutEventKind::FragmentParted:
    case CutEventKind::HingeClosed:
    case CutEventKind::Gripped:
    case CutEventKind::Released:
    case CutEventKind::PieceRemoved:
      return true;
    default:
      return false;
  }
}

/// Follows events and samples in the order of their ticks, an event before the sample of its tick.
class PathWriter {
 public:
  PathWriter(const std::vector<ToolSample>& samples, const FragmentPoses& lying)
      : samples_(samples), poses_(lying) {
    for (std::int32_t bone = 0; bone < poses_.bone_count(); ++bone) {
      made_.origins.push_back({bone, bone, -1, 0});
      made_.paths.emplace_back();
    }
  }

  void apply(const CutEvent& event) {
    if (!poses_.apply(event)) return;
    switch (event.kind) {
      case CutEventKind::FragmentParted:
        part(event);
        break;
      case CutEventKind::HingeClosed:
        if (poses_.count() > poses_.bone_count())
          made_.paths.back().leave_at(event.tick, event.pose);
        break;
      case CutEventKind::Gripped:
        grip(event);
        break;
      case CutEventKind::Released:
        follow_samples(event.tick);
        held_ = -1;
        path(event.subject).leave_at(event.tick, event.pose);
        break;
      default:
        break;
    }
  }
  FragmentPaths finish() && {
    follow_samples(samples_.empty() ? 0 : samples_.back().tick + 1);
    return std::move(made_);
  }

 private:
  FragmentPath& path(std::int32_t fragment) noexcept {
    return made_.paths[static_cast<std::size_t>(fragment)];
  }
  void part(const CutEvent& event) {
    const FragmentPose& parted = poses_[poses_.count() - 1];
    made_.origins.push_back({parted.bone, event.subject, parted.parent, event.tick});
    FragmentPath own;
    own.leave_at(event.tick, path(parted.parent).left_last());
    made_.paths.push_back(std::move(own));
  }
  void grip(const CutEvent& event) {
    if (event.subject < 0 || event.subject >= poses_.count()) return;
    held_ = event.subject;
    held_from_tick_ = event.tick;
  }
  /// While a piece is held, the tool of the record is the piece.
  void follow_samples(std::int64_t until_tick) {
    if (held_ < 0) return;
    auto sample = std::partition_point(
        samples_.begin(), samples_.end(),
        [this](const ToolSample& each) { return each.tick < held_from_tick_; });
    for (; sample != samples_.end() && sample->tick < until_tick; ++sample)
      path(held_).lead_to(sample->tick, sample->world_from_tool);
  }

  const std::vector<ToolSample>& samples_;
  FragmentPoses poses_;
  FragmentPaths made_;
  std::int32_t held_ = -1;
  std::int64_t held_from_tick_ = 0;
};

}  // namespace

void FragmentPath::add(const Step& step) {
  if (!steps_.empty() && steps_.back().tick == step.tick) {
    steps_.back() = step;
    return;
  }
  const bool is_same = !steps_.empty() && steps_.back().is_in_world == step.is_in_world &&
                       steps_.back().pose == step.pose;
  if (!is_same) steps_.push_back(step);
}

std::size_t FragmentPath::step_at(std::int64_t tick) const noexcept {
  const auto next =
      std::upper_bound(steps_.begin(), steps_.end(), tick,
                       [](std::int64_t wanted, const Step& step) { return wanted < step.tick; });
  return static_cast<std::size_t>(next - steps_.begin());
}

RigidTransform FragmentPath::world_from_fragment(
    std::int64_t tick, const RigidTransform& world_from_bone) const noexcept {
  const std::size_t step = step_at(tick);
  if (step == 0) return world_from_bone;
  const Step& now = steps_[step - 1];
  const RigidTransform pose = transform_from(now.pose);
  return now.is_in_world ? pose : world_from_bone * pose;
}

QuantisedPose FragmentPath::left_last() const noexcept {
  const auto found = std::find_if(steps_.rbegin(), steps_.rend(),
                                  [](const Step& step) { return !step.is_in_world; });
  return found == steps_.rend() ? QuantisedPose{} : found->pose;
}

std::vector<CutEvent> fragment_events(const Recording& recording) {
  std::vector<CutEvent> events;
  std::int64_t parted_tick = -1;
  for (const CutEvent& event : recording.events) {
    if (!is_of_fragments(event.kind)) continue;
    if (event.kind == CutEventKind::FragmentParted) parted_tick = event.tick;
    if (event.kind == CutEventKind::HingeClosed && parted_tick != event.tick) {
      CutEvent parted;
      parted.tick = event.tick;
      parted.kind = CutEventKind::FragmentParted;
      events.push_back(parted);
    }
    events.push_back(event);
  }
  return events;
}

FragmentPaths fragment_paths(const std::vector<CutEvent>& events,
                             const std::vector<ToolSample>& samples, const FragmentPoses& lying) {
  PathWriter writer(samples, lying);
  for (const CutEvent& event : events) writer.apply(event);
  return std::move(writer).finish();
}

}  // namespace hallux::simulator
