#include "simulator/jobs/live_cut.h"

#include <utility>

namespace hallux::simulator {

namespace {

/// Where only the whole can show what is cut.
constexpr std::int64_t ticks_between_wholes = 500;

}  // namespace

LiveCut::LiveCut(const BoneToCut& bone, const Tray& tray, const PlannedBridges& bridges)
    : geometry_(bone, tray, bridges) {}

void LiveCut::apply(const ToolSample& sample) {
  tick_ = sample.tick;
  geometry_.apply(sample);
  if (sample.kerf < 0 || !has(sample.status, ToolStatus::SawOn)) return;
  kerf_ = sample.kerf;
  has_grown_ = true;
}

void LiveCut::apply(const CutEvent& event) {
  geometry_.apply(event);
  if (event.kind == CutEventKind::PieceRemoved) {
    growing_.reset();
    is_whole_due_ = true;
    std::erase_if(free_pieces_, [&](const FreedPiece& piece) { return piece.id == event.subject; });
    are_free_pieces_due_ = true;
  }
  if (event.kind == CutEventKind::HingeClosed && closed_hinge() != nullptr) {
    growing_.reset();
    is_whole_due_ = has_grown_ = false;
    free_pieces_.clear();
    are_free_pieces_due_ = true;
  }
}

void LiveCut::apply(const JobRequest& request) {
  if (request.kind == JobKind::Section) return;
  std::unique_ptr<JobResult> result = geometry_.run(request);
  if (request.kind == JobKind::Pieces) {
    free_pieces_.clear();
    for (const PieceBody& piece : geometry_.pieces()) {
      if (piece.id != 0) free_pieces_.push_back({piece.id, piece.solid});
    }
    are_free_pieces_due_ = true;
  }
  if (request.kind == JobKind::Hinge) hinge_ = std::move(result);
}

std::optional<std::vector<FreedPiece>> LiveCut::take_free_pieces() {
  if (!std::exchange(are_free_pieces_due_, false)) return std::nullopt;
  return free_pieces_;
}

std::optional<KerfOpening> LiveCut::kerf_at_hand() const {
  if (kerf_ < 0) return std::nullopt;
  const KerfSet& kerfs = geometry_.kerfs();
  const bool is_shown = growing_ != nullptr && kerf_at_hand_ == kerf_ && !has_grown_;
  return KerfOpening{kerfs.plane(kerf_),
                     loops_of(is_shown ? growing_->region() : outline_of(kerfs.field(kerf_)))};
}

KerfOpening LiveCut::opening_of(std::int32_t kerf) const {
  const KerfSet& kerfs = geometry_.kerfs();
  return {kerfs.plane(kerf), loops_of(outline_of(kerfs.field(kerf)))};
}

std::optional<PatchBase> LiveCut::take_base() {
  if (!has_grown_ || (growing_ != nullptr && kerf_at_hand_ == kerf_)) return std::nullopt;
  growing_.reset();
  if (geometry_.is_only_kerf(kerf_)) {
    grow_on(geometry_.whole());
    return PatchBase();
  }
  std::optional<CutSolid> solid = geometry_.solid_without(kerf_);
  if (!solid) return std::nullopt;
  auto tree = std::make_unique<const Bvh>(solid->mesh);
  grow_on({*solid, *tree});
  return PatchBase{std::move(*solid), std::move(tree)};
}

void LiveCut::grow_on(const SolidWithTree& base) {
  const KerfSet& kerfs = geometry_.kerfs();
  growing_ =
      std::make_unique<GrowingKerf>(base, kerfs.plane(kerf_), kerf_, kerfs.field(kerf_).grid());
  kerf_at_hand_ = kerf_;
}

bool LiveCut::build_patch(SolidPatch& patch) {
  if (!has_grown_ || growing_ == nullptr) return false;
  has_grown_ = false;
  return growing_->build(geometry_.kerfs().field(kerf_at_hand_), patch);
}

std::optional<CutSolid> LiveCut::take_whole() {
  if (has_grown_ && growing_ == nullptr && tick_ >= whole_tick_ + ticks_between_wholes) {
    is_whole_due_ = true;
  }
  if (!is_whole_due_) return std::nullopt;
  is_whole_due_ = has_grown_ = false;
  whole_tick_ = tick_;
  return geometry_.solid_without(-1);
}

std::optional<KerfPlane> LiveCut::plane_at_hand() const {
  if (kerf_ < 0) return std::nullopt;
  return geometry_.kerfs().plane(kerf_);
}

const ClosedHinge* LiveCut::closed_hinge() const noexcept {
  const bool has_closed = hinge_ != nullptr && hinge_->hinge.outcome == HingeOutcome::Closed;
  return has_closed ? &hinge_->hinge : nullptr;
}

}  // namespace hallux::simulator
