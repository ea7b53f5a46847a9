/// The attempt's own jobs again, each at the tick whose state it saw. A piece that is parted or
/// taken out is the one that the last job of pieces numbered; but its kerfs may have gone on since,
/// so what of the bone lies in it is asked at the tick of the event.
#include "simulator/history/fragment_spans.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "simulator/jobs/lying_bones.h"
#include "simulator/jobs/recorded_jobs.h"
#include "simulator/record/fragment_poses.h"

namespace hallux::simulator {

namespace {

constexpr double on_surface_mm = 1.0e-3;

/// A fragment as it stands so far; null where nothing is known of it.
struct Standing {
  std::unique_ptr<const WholeBone> whole;
  std::unique_ptr<BoneAtTick> bone;
  std::int64_t from_tick = 0;
  std::size_t taken_before = 0;
  /// When its pieces were asked for last.
  std::int64_t numbered_tick = -1;
};

struct DividedSolid {
  CutSolid rest, parted;
};

CutSolid gathered(const std::vector<CutSolid>& solids) {
  CutSolid all;
  for (const CutSolid& solid : solids) append_solid(all, solid);
  return all;
}

template <typename IsParted>
DividedSolid divided_by(const std::vector<CutSolid>& solids, const IsParted& is_parted) {
  DividedSolid divided;
  for (const CutSolid& solid : solids)
    append_solid(is_parted(solid) ? divided.parted : divided.rest, solid);
  return divided;
}

/// All of a fragment's solids but those that were taken out of it.
std::vector<CutSolid> solids_left(CutBone& bone) {
  std::vector<CutSolid> solids = split_pieces(bone.after_all());
  for (const Bvh* const body : bone.pieces().taken_out())
    std::erase_if(solids, [&](const CutSolid& solid) { return lies_in(solid, *body); });
  return solids;
}

class SpanWriter {
 public:
  explicit SpanWriter(const SpansRequest& request)
      : request_(request), poses_(poses_of(request.bones)) {
    for (const Bone& bone : request.bones)
      begin(CutSolid{uncut_solid(solid_of(bone))}, std::nullopt, 0);
    next_piece_ = poses_.bone_count();
  }

  /// Events of a tick come before the jobs that were asked for in it.
  void follow(const Progress& progress) {
    if (request_.events.empty()) return;
    jobs_ = recorded_jobs(request_.recording, request_.bones.size());
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      report(progress, static_cast<double>(i) / static_cast<double>(jobs_.size()));
      apply_events(jobs_[i].request.tick);
      if (jobs_[i].request.kind == JobKind::Pieces) number_pieces(jobs_[i].request.tick);
    }
    apply_events(never_tick);
  }

  std::vector<SpannedFragment> finish() && {
    for (std::size_t fragment = 0; fragment < standing_.size(); ++fragment)
      close(fragment, never_tick);
    return std::move(made_);
  }

 private:
  /// The next fragment stands from this tick on.
  void begin(CutSolid solid, std::optional<NumberedPieces> pieces, std::int64_t tick) {
    made_.emplace_back();
    standing_.emplace_back();
    stand(standing_.size() - 1, std::move(solid), std::move(pieces), tick);
  }

  void stand(std::size_t fragment, CutSolid solid, std::optional<NumberedPieces> pieces,
             std::int64_t tick) {
    Standing& standing = standing_[fragment];
    standing = {};
    standing.from_tick = standing.numbered_tick = tick;
    standing.taken_before = made_[fragment].taken.size();
    if (solid.mesh.triangles.empty()) return;
    standing.whole = std::make_unique<const WholeBone>(std::move(solid));
    NumberedPieces own =
        pieces ? *std::move(pieces)
               : NumberedPieces(standing.whole->solid, static_cast<std::int32_t>(fragment));
    standing.bone = std::make_unique<BoneAtTick>(*standing.whole, std::move(own), request_.growths,
                                                 kerfs_from(fragment, tick));
  }

  /// Of the fragment, begun at that tick or later.
  std::vector<std::int32_t> kerfs_from(std::size_t fragment, std::int64_t tick) const {
    std::vector<std::int32_t> kerfs;
    for (std::size_t kerf = 0; kerf < request_.growths.size(); ++kerf) {
      const KerfGrowth& growth = request_.growths[kerf];
      const bool is_own = growth.fragment == static_cast<std::int32_t>(fragment);
      if (is_own && growth.frozen_tick >= tick) kerfs.push_back(static_cast<std::int32_t>(kerf));
    }
    return kerfs;
  }

  /// Keeps what the fragment was so far.
  void close(std::size_t fragment, std::int64_t tick) {
    Standing& standing = standing_[fragment];
    if (standing.bone == nullptr) return;
    std::vector<std::int32_t> kerfs = standing.bone->kerfs();
    std::erase_if(kerfs, [&](std::int32_t kerf) {
      return request_.growths[static_cast<std::size_t>(kerf)].frozen_tick >= tick;
    });
    standing.bone.reset();
    made_[fragment].spans.push_back({standing.from_tick, tick, std::move(standing.whole),
                                     std::move(kerfs), standing.taken_before});
  }

  void apply_events(std::int64_t until_tick) {
    const std::vector<CutEvent>& events = request_.events;
    for (; next_event_ < events.size() && events[next_event_].tick <= until_tick; ++next_event_) {
      const CutEvent& event = events[next_event_];
      if (event.kind == CutEventKind::PieceRemoved) take_out(event);
      if (event.kind == CutEventKind::FragmentParted && poses_.apply(event))
        part(event, closing_hinge());
    }
  }

  /// That closes as the event at hand parts its half.
  std::optional<std::size_t> closing_hinge() const {
    const std::vector<CutEvent>& events = request_.events;
    const std::int64_t tick = events[next_event_].tick;
    for (std::size_t i = next_event_ + 1; i < events.size() && events[i].tick == tick; ++i) {
      if (events[i].kind != CutEventKind::HingeClosed) continue;
      if (events[i].subject >= 0) return static_cast<std::size_t>(events[i].subject);
      const auto job = std::find_if(jobs_.begin(), jobs_.end(), [tick](const RecordedJob& each) {
        return each.applied_tick == tick && each.request.kind == JobKind::Hinge;
      });
      const std::int32_t number = job == jobs_.end() ? 0 : job->request.subject;
      return static_cast<std::size_t>(std::max(0, number));
    }
    return std::nullopt;
  }

  void part(const CutEvent& event, const std::optional<std::size_t>& hinge) {
    const auto parent = static_cast<std::size_t>(event.value);
    DividedSolid divided;
    if (standing_[parent].bone != nullptr) {
      CutBone& bone = standing_[parent].bone->move_to(event.tick);
      divided = hinge ? divided_at(*hinge, bone) : divided_from(event, bone);
    }
    const std::int32_t piece = event.subject < 0 ? next_piece_ : event.subject;
    next_piece_ = std::max(next_piece_, piece + 1);
    // What nothing is known of stays where it was.
    if (divided.parted.mesh.triangles.empty()) return begin({}, std::nullopt, event.tick);
    const NumberedPieces before = std::move(standing_[parent].bone->bone()).release_pieces();
    close(parent, event.tick);
    NumberedPieces left = before.of_part(divided.rest, before.main());
    NumberedPieces own = before.of_part(divided.parted, piece);
    stand(parent, std::move(divided.rest), std::move(left), event.tick);
    begin(std::move(divided.parted), std::move(own), event.tick);
  }

  DividedSolid divided_at(std::size_t hinge, CutBone& bone) const {
    if (hinge >= request_.bridges.size()) return {};
    ClosedHinge closed = close_bridge(bone, gathered(solids_left(bone)), request_.bridges[hinge]);
    if (closed.outcome != HingeOutcome::Closed) return {};
    return {std::move(closed.fixed), std::move(closed.moved)};
  }

  DividedSolid divided_from(const CutEvent& event, CutBone& bone) const {
    const std::vector<CutSolid> solids = solids_left(bone);
    const std::vector<PieceBody>& pieces = bone.pieces().pieces();
    const auto known = std::find_if(pieces.begin(), pieces.end(), [&](const PieceBody& piece) {
      return piece.id == event.subject;
    });
    if (known != pieces.end()) {
      const Bvh body(known->solid.mesh);
      return divided_by(solids, [&](const CutSolid& solid) { return lies_in(solid, body); });
    }
    const std::optional<Vec3> place_mm = place_of(event);
    return divided_by(solids, [&](const CutSolid& solid) {
      return place_mm && Bvh(solid.mesh).contains(*place_mm);
    });
  }

  /// A point inside the piece, as it was told last.
  std::optional<Vec3> place_of(const CutEvent& parted) const {
    std::optional<Vec3> place_mm;
    for (const CutEvent& event : request_.recording.events) {
      if (event.tick > parted.tick) break;
      if (event.kind == CutEventKind::PieceFreed && event.subject == parted.subject)
        place_mm = transform_from(event.pose).translation_mm;
    }
    return place_mm;
  }

  void number_pieces(std::int64_t tick) {
    const std::size_t fragment = asked_fragment(tick);
    Standing& standing = standing_[fragment];
    standing.numbered_tick = tick;
    if (standing.bone != nullptr) standing.bone->move_to(tick).number_pieces(next_piece_);
  }

  /// A job is for one fragment, of those in which a blade opened bone since they were asked for:
  /// the one in which it was last, else that of the first such kerf.
  std::size_t asked_fragment(std::int64_t tick) const {
    if (standing_.size() == 1) return 0;
    std::optional<std::size_t> first;
    const std::int32_t sawn = kerf_sawn_last(tick);
    for (std::size_t kerf = 0; kerf < request_.growths.size(); ++kerf) {
      const KerfGrowth& growth = request_.growths[kerf];
      const auto fragment = static_cast<std::size_t>(growth.fragment);
      if (fragment >= standing_.size()) continue;
      if (growth.grown_at(tick) == growth.grown_at(standing_[fragment].numbered_tick)) continue;
      if (static_cast<std::int32_t>(kerf) == sawn) return fragment;
      if (!first) first = fragment;
    }
    return first.value_or(0);
  }

  std::int32_t kerf_sawn_last(std::int64_t tick) const {
    const std::vector<ToolSample>& samples = request_.recording.samples;
    auto sample =
        std::partition_point(samples.begin(), samples.end(),
                             [tick](const ToolSample& each) { return each.tick <= tick; });
    while (sample != samples.begin()) {
      --sample;
      if (sample->kerf >= 0 && has(sample->status, ToolStatus::SawOn)) return sample->kerf;
    }
    return -1;
  }

  void take_out(const CutEvent& removal) {
    for (std::size_t fragment = 0; fragment < standing_.size(); ++fragment) {
      if (standing_[fragment].bone == nullptr) continue;
      if (made_[fragment].out_tick == never_tick && take_out_of(fragment, removal)) return;
    }
  }

  bool take_out_of(std::size_t fragment, const CutEvent& removal) {
    CutBone& bone = standing_[fragment].bone->move_to(removal.tick);
    if (bone.pieces().main() == removal.subject) {
      made_[fragment].out_tick = removal.tick;
      return true;
    }
    const Bvh* const body = bone.take_out(removal.subject);
    if (body == nullptr) return false;
    CutSolid lying;
    for (const CutSolid& piece : split_pieces(bone.after_all())) {
      if (lies_in(piece, *body)) append_solid(lying, piece);
    }
    made_[fragment].taken.emplace_back(removal.tick, lying.mesh);
    return true;
  }

  const SpansRequest& request_;
  FragmentPoses poses_;
  std::vector<RecordedJob> jobs_;
  std::size_t next_event_ = 0;
  std::int32_t next_piece_ = 1;
  /// By fragment.
  std::vector<Standing> standing_;
  std::vector<SpannedFragment> made_;
};

}  // namespace

TakenPiece::TakenPiece(std::int64_t taken_tick, const IndexedMesh& piece)
    : tick(taken_tick), body(std::make_unique<const Bvh>(piece)) {
  if (piece.points_mm.empty()) return;
  low_mm = high_mm = piece.points_mm.front();
  for (const Vec3& point_mm : piece.points_mm) {
    low_mm = glm::min(low_mm, point_mm);
    high_mm = glm::max(high_mm, point_mm);
  }
  low_mm -= Vec3(on_surface_mm);
  high_mm += Vec3(on_surface_mm);
}

bool TakenPiece::has(const Vec3& middle_mm) const noexcept {
  const Vec3 inner_mm = glm::clamp(middle_mm, low_mm, high_mm);
  return inner_mm == middle_mm &&
         body->signed_distance_mm(middle_mm, on_surface_mm) < on_surface_mm;
}

std::vector<SpannedFragment> fragment_spans(const SpansRequest& request, const Progress& progress) {
  SpanWriter writer(request);
  writer.follow(progress);
  return std::move(writer).finish();
}

}  // namespace hallux::simulator
