#include "simulator/jobs/live_cut.h"

#include <utility>

namespace hallux::simulator {

namespace {

/// Where only the whole can show what is cut.
constexpr std::int64_t ticks_between_wholes = 500;

}  // namespace

LiveCut::LiveCut(const Bone& bone, const Blade& blade, std::optional<PlannedBridge> bridge)
    : geometry_(bone, blade, bridge) {}

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
  }
  if (event.kind == CutEventKind::HingeClosed && closed_hinge() != nullptr) {
    growing_.reset();
    is_whole_due_ = has_grown_ = false;
  }
}

void LiveCut::apply(const JobRequest& request) {
  if (request.kind == JobKind::Section) return;
  std::unique_ptr<const JobResult> result = geometry_.run(request);
  if (request.kind == JobKind::Hinge) hinge_ = std::move(result);
}

std::optional<PatchBase> LiveCut::take_base() {
  if (!has_grown_ || (growing_ != nullptr && kerf_at_hand_ == kerf_)) return std::nullopt;
  growing_.reset();
  std::optional<CutSolid> base = geometry_.solid_without(kerf_);
  if (!base) return std::nullopt;
  const Bvh bvh(base->mesh);
  const KerfSet& kerfs = geometry_.kerfs();
  growing_ = std::make_unique<GrowingKerf>(SolidWithTree{*base, bvh}, kerfs.plane(kerf_), kerf_,
                                           kerfs.field(kerf_).grid());
  kerf_at_hand_ = kerf_;
  return PatchBase{std::move(*base), geometry_.is_only_kerf(kerf_)};
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

const ClosedHinge* LiveCut::closed_hinge() const noexcept {
  const bool has_closed = hinge_ != nullptr && hinge_->hinge.outcome == HingeOutcome::Closed;
  return has_closed ? &hinge_->hinge : nullptr;
}

}  // namespace hallux::simulator
