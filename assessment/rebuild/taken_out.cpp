// The kernel took a piece as its last job of pieces knew it: as the kerfs stood at the tick of that
// job's request. Mostly nothing was sawn since, and the pieces that the whole recording leaves are
// those; else the recording is rebuilt up to that tick.
#include "assessment/rebuild/taken_out.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "assessment/rebuild/recording_begin.h"
#include "simulator/jobs/recorded_jobs.h"

namespace hallux::assessment {

namespace {

using simulator::Bvh;
using simulator::CutEvent;
using simulator::CutEventKind;
using simulator::Recording;

/// The tick whose kerfs the last job of pieces before a removal saw; the removal's own without one.
std::int64_t seen_tick(const std::vector<simulator::RecordedJob>& jobs, std::int64_t removal_tick) {
  std::int64_t seen = -1;
  for (const simulator::RecordedJob& job : jobs) {
    if (job.request.kind == simulator::JobKind::Pieces && job.applied_tick <= removal_tick)
      seen = job.request.tick;
  }
  return seen >= 0 ? seen : removal_tick;
}

std::int64_t volume_thousandths(const Recording& recording, std::int32_t piece) {
  for (const CutEvent& event : recording.events) {
    if (event.kind == CutEventKind::PieceFreed && event.subject == piece) return event.value;
  }
  return 0;
}

/// The first piece of a bone is its largest: the bone, which nobody takes out.
std::unique_ptr<const Bvh> body_at(const RebuiltBone& rebuilt, const Vec3& inside_mm,
                                   std::size_t bone) {
  bool is_bone_itself = true;
  for (std::size_t piece = 0; piece < rebuilt.pieces.size(); ++piece) {
    if (rebuilt.piece_bones[piece] != bone || std::exchange(is_bone_itself, false)) continue;
    auto body = std::make_unique<const Bvh>(rebuilt.pieces[piece].mesh);
    if (body->contains(inside_mm)) return body;
  }
  return nullptr;
}

/// The piece of nearly that volume.
std::unique_ptr<const Bvh> body_of_volume(const RebuiltBone& rebuilt, std::int64_t thousandths) {
  std::optional<std::size_t> nearest;
  double least_mm3 = std::numeric_limits<double>::infinity();
  for (std::size_t piece = 1; piece < rebuilt.pieces.size(); ++piece) {
    const double off_mm3 =
        std::abs(rebuilt.piece_volumes_mm3[piece] - 1.0e-3 * static_cast<double>(thousandths));
    if (off_mm3 >= least_mm3) continue;
    least_mm3 = off_mm3;
    nearest = piece;
  }
  if (!nearest) return nullptr;
  return std::make_unique<const Bvh>(rebuilt.pieces[*nearest].mesh);
}

std::unique_ptr<const Bvh> body_of(const RebuiltBone& rebuilt, const Recording& recording,
                                   const CutEvent& removal, std::size_t bone) {
  if (recording.engine >= first_engine_with_places)
    return body_at(rebuilt, transform_from(removal.pose).translation_mm, bone);
  return body_of_volume(rebuilt, volume_thousandths(recording, removal.subject));
}

bool is_removal(const CutEvent& event) noexcept { return event.kind == CutEventKind::PieceRemoved; }

}  // namespace

std::size_t bone_of_piece(const Recording& recording, std::size_t event,
                          const simulator::FragmentPoses& fragments) noexcept {
  const std::int32_t piece = recording.events[event].subject;
  for (std::size_t i = 0; i < event; ++i) {
    const CutEvent& before = recording.events[i];
    const bool is_told = before.subject == piece && (before.kind == CutEventKind::PieceOfFragment ||
                                                     before.kind == CutEventKind::FragmentParted);
    if (is_told && before.value >= 0 && before.value < fragments.count())
      return static_cast<std::size_t>(fragments[static_cast<std::int32_t>(before.value)].bone);
  }
  return 0;
}

std::vector<TakenOut> pieces_taken_out(const RebuiltBone& rebuilt, simulator::Bones bones,
                                       const simulator::Recorded& recorded,
                                       const Progress& progress) {
  const Recording& recording = recorded.outputs;
  std::vector<TakenOut> taken;
  // The tape is long: it is looked at where it can tell something.
  if (std::ranges::none_of(recording.events, is_removal)) return taken;
  const std::vector<simulator::RecordedJob> jobs = recorded_jobs(recorded, bones.size());
  for (std::size_t i = 0; i < recording.events.size(); ++i) {
    const CutEvent& event = recording.events[i];
    if (!is_removal(event)) continue;
    const std::int64_t seen = seen_tick(jobs, event.tick);
    const std::size_t bone = bone_of_piece(recording, i, rebuilt.fields.fragments());
    std::unique_ptr<const Bvh> body;
    if (is_sawn_between(recording, seen, recording.samples.back().tick)) {
      const RebuiltBone then =
          rebuild(bones, rebuilt.fields.tray(), begin_of(recording, seen), progress);
      body = body_of(then, recording, event, bone);
    } else {
      body = body_of(rebuilt, recording, event, bone);
    }
    if (body != nullptr) taken.push_back({event.tick, bone, std::move(body)});
  }
  return taken;
}

}  // namespace hallux::assessment
