/// A kerf grows on a bone whose other kerfs stand still: so an attempt falls into stretches, one
/// mesh each, and any moment is a stretch and a threshold of its field. Pieces and hinge are
/// computed again by the attempt's own jobs, each at the tick whose state it saw; what was taken
/// out is drawn no more by the triangles that lie on its body.
#include "simulator/history/bone_history.h"

#include <algorithm>

#include "simulator/jobs/recorded_jobs.h"

namespace hallux::simulator {

namespace {

constexpr double on_surface_mm = 1.0e-3;
/// Of the whole work; the rest is pieces and hinge.
constexpr double stretches_share = 0.9;

/// Where the growth passes from one kerf to another.
struct Turn {
  std::int64_t tick = 0;
  std::int32_t kerf = -1;
};

/// At each tick the blade is in one kerf.
std::vector<Turn> turns_of(const std::vector<KerfGrowth>& kerfs) {
  std::vector<Turn> grown;
  for (std::size_t kerf = 0; kerf < kerfs.size(); ++kerf) {
    for (const std::int32_t tick : kerfs[kerf].ticks)
      grown.push_back({tick, static_cast<std::int32_t>(kerf)});
  }
  std::sort(grown.begin(), grown.end(),
            [](const Turn& a, const Turn& b) { return a.tick < b.tick; });
  const auto end = std::unique(grown.begin(), grown.end(),
                               [](const Turn& a, const Turn& b) { return a.kerf == b.kerf; });
  grown.erase(end, grown.end());
  if (grown.empty()) grown.push_back({0, -1});
  grown.front().tick = 0;
  return grown;
}

/// The bone after its kerfs as they stood at one tick after the other.
class BoneAtTick {
 public:
  BoneAtTick(const Bone& bone, const std::vector<KerfGrowth>& kerfs)
      : kerfs_(kerfs), bone_(solid_of(bone)), grown_(kerfs.size(), 0) {
    for (std::size_t kerf = 0; kerf < kerfs.size(); ++kerf) put(kerf, {});
  }

  CutBone& move_to(std::int64_t tick) {
    for (std::size_t kerf = 0; kerf < kerfs_.size(); ++kerf) {
      const std::size_t grown = kerfs_[kerf].grown_at(tick);
      if (grown_[kerf] == grown) continue;
      grown_[kerf] = grown;
      put(kerf, grown == 0 ? RegionOutline{} : outline_at(kerfs_[kerf].opened, tick));
    }
    return bone_;
  }

 private:
  void put(std::size_t kerf, RegionOutline region) {
    const auto number = static_cast<std::int32_t>(kerf);
    const OpenedField& opened = kerfs_[kerf].opened;
    bone_.put_kerf(number, {number, opened.plane, opened.grid, std::move(region)});
  }

  const std::vector<KerfGrowth>& kerfs_;
  CutBone bone_;
  std::vector<std::size_t> grown_;
};

BoneStretch stretch_from(BoneAtTick& bone, const std::vector<KerfGrowth>& kerfs, const Turn& turn) {
  BoneStretch stretch;
  stretch.from_tick = turn.tick;
  stretch.growing = turn.kerf;
  stretch.solid = bone.move_to(turn.tick).all_but(turn.kerf);
  if (turn.kerf < 0) return stretch;
  const OpenedField& opened = kerfs[static_cast<std::size_t>(turn.kerf)].opened;
  const Bvh bvh(stretch.solid.mesh);
  stretch.contact = std::make_unique<const SlabSlice>(
      slice_slab(stretch.solid, bvh, opened.plane, turn.kerf, opened.grid));
  return stretch;
}

std::vector<std::uint32_t> triangles_on(const IndexedMesh& mesh, const Bvh& body) {
  std::vector<std::uint32_t> found;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (lies_on(body, middle_of(corners_of(mesh, i))))
      found.push_back(static_cast<std::uint32_t>(i));
  }
  return found;
}

/// Pieces and hinge as the attempt had them: its jobs again, each at the tick whose state it saw.
class PiecesAgain {
 public:
  PiecesAgain(const HistoryRequest& request, BoneHistory& history)
      : request_(request), history_(history), bone_(request.bone, history.kerfs) {}

  /// A removal of a tick comes before the jobs that were asked for in it.
  void run() {
    std::vector<CutEvent> removals;
    bool has_closed = false;
    for (const CutEvent& event : request_.recording.events) {
      if (event.kind == CutEventKind::PieceRemoved) removals.push_back(event);
      has_closed = has_closed || event.kind == CutEventKind::HingeClosed;
    }
    if (removals.empty() && !has_closed) return;
    auto removal = removals.begin();
    for (const RecordedJob& job : recorded_jobs(request_.recording)) {
      for (; removal != removals.end() && removal->tick <= job.request.tick; ++removal) {
        take_out(*removal);
      }
      if (job.request.kind == JobKind::Pieces) bone_.move_to(job.request.tick).number_pieces();
      if (job.request.kind == JobKind::Hinge) close(job);
    }
    for (; removal != removals.end(); ++removal) take_out(*removal);
  }

 private:
  /// What lies in the body now is drawn no more: its kerfs may have gone on since it was numbered.
  void take_out(const CutEvent& removal) {
    CutBone& bone = bone_.move_to(removal.tick);
    const Bvh* const body = bone.take_out(removal.subject);
    if (body == nullptr) return;
    CutSolid lying;
    for (const CutSolid& piece : split_pieces(bone.after_all())) {
      if (lies_in(piece, *body)) append_solid(lying, piece);
    }
    history_.taken.push_back({removal.tick, std::make_unique<const Bvh>(lying.mesh)});
  }

  void close(const RecordedJob& job) {
    const auto& events = request_.recording.events;
    const auto event = std::find_if(events.begin(), events.end(), [&](const CutEvent& each) {
      return each.tick == job.applied_tick && each.kind == CutEventKind::HingeClosed;
    });
    const auto number = static_cast<std::size_t>(std::max(0, job.request.subject));
    if (event == events.end() || number >= request_.bridges.size()) return;
    ClosedHinge hinge = close_bridge(bone_.move_to(job.request.tick), request_.bridges[number]);
    if (hinge.outcome != HingeOutcome::Closed) return;
    // The pose is the recorded one: that is where the half came to lie.
    history_.closed = {event->tick, std::move(hinge.fixed), std::move(hinge.moved),
                       transform_from(event->pose)};
  }

  const HistoryRequest& request_;
  BoneHistory& history_;
  BoneAtTick bone_;
};

void mark_taken(BoneHistory& history) {
  for (std::size_t i = 0; i < history.stretches.size(); ++i) {
    BoneStretch& stretch = history.stretches[i];
    const bool is_last = i + 1 == history.stretches.size();
    for (const TakenPiece& taken : history.taken) {
      const bool is_seen = is_last || history.stretches[i + 1].from_tick > taken.tick;
      stretch.of_piece.push_back(is_seen ? triangles_on(stretch.solid.mesh, *taken.body)
                                         : std::vector<std::uint32_t>());
    }
  }
}

}  // namespace

bool lies_on(const Bvh& body, const Vec3& point_mm) {
  return body.nearest(point_mm, on_surface_mm).has_value();
}

std::size_t KerfGrowth::grown_at(std::int64_t tick) const noexcept {
  const auto next = std::upper_bound(ticks.begin(), ticks.end(), tick);
  return static_cast<std::size_t>(next - ticks.begin());
}

std::size_t BoneHistory::stretch_at(std::int64_t tick) const noexcept {
  std::size_t found = 0;
  for (std::size_t i = 1; i < stretches.size(); ++i)
    if (stretches[i].from_tick <= tick) found = i;
  return found;
}

std::shared_ptr<const BoneHistory> build_history(HistoryRequest request, const Progress& progress) {
  auto history = std::make_shared<BoneHistory>();
  for (OpenedField& opened : request.opened) {
    std::vector<std::int32_t> ticks = opened.ticks();
    history->kerfs.push_back({std::move(opened), std::move(ticks)});
  }
  const std::vector<Turn> turns = turns_of(history->kerfs);
  BoneAtTick bone(request.bone, history->kerfs);
  for (const Turn& turn : turns) {
    const auto done = static_cast<double>(history->stretches.size());
    report(progress, stretches_share * done / static_cast<double>(turns.size()));
    history->stretches.push_back(stretch_from(bone, history->kerfs, turn));
  }
  report(progress, stretches_share);
  PiecesAgain(request, *history).run();
  mark_taken(*history);
  report(progress, 1.0);
  return history;
}

}  // namespace hallux::simulator
