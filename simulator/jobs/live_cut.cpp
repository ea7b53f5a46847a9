#include "simulator/jobs/live_cut.h"

#include <algorithm>
#include <utility>

#include "simulator/base/check.h"

namespace hallux::simulator {

namespace {

/// Where only the whole can show what is cut.
constexpr std::int64_t ticks_between_wholes = 500;

}  // namespace

LiveCut::LiveCut(std::span<const BoneToCut> bones, const Tray& tray, const PlannedBridges& bridges)
    : geometry_(bones, tray, bridges), bores_(tray), implants_(tray) {}

void LiveCut::apply(const ToolSample& sample) {
  tick_ = sample.tick;
  geometry_.apply(sample);
  bores_.apply(sample, kerfs().fragments());
  if (gripped_ >= 0) world_from_gripped_ = transform_from(sample.world_from_tool);
  if (sample.kerf < 0 || !has(sample.status, ToolStatus::SawOn)) return;
  kerf_ = sample.kerf;
  has_grown_ = true;
  for (const std::int32_t kerf : kerfs().one_cut_with(kerf_)) {
    const std::int32_t fragment = kerfs().fragment_of(kerf);
    if (fragment != fragment_at_hand()) due(fragment) = std::max(due(fragment), Due::Soon);
  }
}

void LiveCut::apply(const CutEvent& event) {
  const std::int32_t taken_from =
      event.kind == CutEventKind::PieceRemoved ? geometry_.fragment_of_piece(event.subject) : -1;
  geometry_.apply(event);
  CHECK(bores_.apply(event, kerfs().fragments()));
  CHECK(implants_.apply(event, kerfs().fragments()));
  switch (event.kind) {
    case CutEventKind::PieceRemoved:
      stop_growing();
      if (taken_from >= 0) due(taken_from) = Due::Now;
      renew_free_pieces();
      break;
    case CutEventKind::FragmentParted:
      stop_growing();
      due(static_cast<std::int32_t>(event.value)) = Due::Now;
      due(fragment_count() - 1) = Due::Now;
      has_grown_ = false;
      renew_free_pieces();
      break;
    case CutEventKind::Gripped:
      gripped_ = event.subject;
      world_from_gripped_ = kerfs().fragments()[gripped_].world_from_fragment;
      break;
    case CutEventKind::Released:
      gripped_ = -1;
      break;
    default:
      break;
  }
}

void LiveCut::apply(const JobRequest& request) {
  if (request.kind == JobKind::Section || request.kind == JobKind::Grip) return;
  const std::unique_ptr<JobResult> result = geometry_.run(request);
  if (request.kind == JobKind::Pieces) renew_free_pieces();
}

void LiveCut::renew_free_pieces() {
  free_pieces_.clear();
  for (std::int32_t fragment = 0; fragment < fragment_count(); ++fragment) {
    if (is_out(fragment)) continue;
    for (const PieceBody& piece : pieces(fragment)) {
      if (piece.id != own_piece(fragment))
        free_pieces_.push_back({piece.id, fragment, piece.solid});
    }
  }
  are_free_pieces_due_ = true;
}

bool LiveCut::is_due() const noexcept {
  return has_grown_ || std::ranges::any_of(due_, [](Due due) { return due != Due::No; });
}

std::optional<std::vector<FreedPiece>> LiveCut::take_free_pieces() {
  if (!std::exchange(are_free_pieces_due_, false)) return std::nullopt;
  return free_pieces_;
}

std::optional<KerfOpening> LiveCut::kerf_at_hand() const {
  if (kerf_ < 0) return std::nullopt;
  const bool is_shown = growing_ != nullptr && kerf_at_hand_ == kerf_ && !has_grown_;
  return KerfOpening{kerfs().plane(kerf_),
                     loops_of(is_shown ? growing_->region() : outline_of(kerfs().field(kerf_)))};
}

std::int32_t LiveCut::fragment_at_hand() const noexcept {
  return kerf_ < 0 ? 0 : kerfs().fragment_of(kerf_);
}

KerfOpening LiveCut::opening_of(std::int32_t kerf) const {
  return {kerfs().plane(kerf), loops_of(outline_of(kerfs().field(kerf)))};
}

std::optional<PatchBase> LiveCut::take_base() {
  if (!has_grown_ || (growing_ != nullptr && kerf_at_hand_ == kerf_)) return std::nullopt;
  const std::int32_t fragment = fragment_at_hand();
  // The patch that another fragment had is part of its mesh from now on.
  if (growing_ != nullptr && kerfs().fragment_of(kerf_at_hand_) != fragment) stop_growing();
  growing_.reset();
  if (geometry_.is_only_kerf(kerf_)) {
    grow_on(geometry_.whole(fragment));
    return PatchBase{fragment, {}, nullptr};
  }
  if (is_out(fragment)) return std::nullopt;
  std::optional<CutSolid> solid = geometry_.solid_without(fragment, kerf_);
  if (!solid) return std::nullopt;
  auto tree = std::make_unique<const Bvh>(solid->mesh);
  grow_on({*solid, *tree});
  return PatchBase{fragment, std::move(*solid), std::move(tree)};
}

void LiveCut::grow_on(const SolidWithTree& base) {
  growing_ =
      std::make_unique<GrowingKerf>(base, kerfs().plane(kerf_), kerf_, kerfs().field(kerf_).grid());
  kerf_at_hand_ = kerf_;
}

void LiveCut::stop_growing() noexcept {
  if (growing_ != nullptr) due(kerfs().fragment_of(kerf_at_hand_)) = Due::Now;
  growing_.reset();
}

bool LiveCut::build_patch(SolidPatch& patch) {
  if (!has_grown_ || growing_ == nullptr) return false;
  has_grown_ = false;
  return growing_->build(kerfs().field(kerf_at_hand_), patch);
}

std::vector<DueFragment> LiveCut::take_due() {
  if (has_grown_ && growing_ == nullptr) {
    due(fragment_at_hand()) = std::max(due(fragment_at_hand()), Due::Soon);
    has_grown_ = false;
  }
  const bool is_soon = tick_ >= whole_tick_ + ticks_between_wholes;
  std::vector<DueFragment> taken;
  for (std::int32_t fragment = 0; fragment < fragment_count(); ++fragment) {
    if (due(fragment) == Due::No || (due(fragment) == Due::Soon && !is_soon)) continue;
    due(fragment) = Due::No;
    whole_tick_ = tick_;
    std::optional<CutSolid> solid =
        is_out(fragment) ? CutSolid() : geometry_.solid_without(fragment, -1);
    if (solid) taken.push_back({fragment, std::move(*solid)});
  }
  return taken;
}

std::optional<KerfPlane> LiveCut::plane_at_hand() const {
  if (kerf_ < 0) return std::nullopt;
  return kerfs().plane(kerf_);
}

RigidTransform LiveCut::world_from_fragment(std::int32_t fragment) const noexcept {
  return fragment == gripped_ ? world_from_gripped_
                              : kerfs().fragments()[fragment].world_from_fragment;
}

}  // namespace hallux::simulator
