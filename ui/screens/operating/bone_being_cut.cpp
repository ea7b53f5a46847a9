// The bone while it is cut, on a thread that may fall behind and never holds anything up. It takes
// the loop's feed, runs the same jobs at the same places, and hands the window the newest picture.
// A growing kerf is a patch on a mesh that stands still; whatever changes the mesh itself is made
// anew. Where that fails for want of memory, the attempt goes on without a new picture.
#include "ui/screens/operating/bone_being_cut.h"

#include <chrono>
#include <utility>

#include "scenarios/planned_bridge.h"
#include "ui/screens/pictures/bone_viewport.h"
#include "ui/screens/pictures/cached_look.h"

namespace hallux::ui {

namespace {

using namespace simulator;

/// A patch for each frame that a display may show.
constexpr std::chrono::milliseconds between_patches{15};
/// Where only the whole mesh can show what is cut.
constexpr std::int64_t ticks_between_solids = 500;

}  // namespace

BonePicture picture_of(const Bone& bone, const std::filesystem::path& data_directory,
                       const Progress& progress) {
  BonePicture picture;
  picture.look = cached_look_of(data_directory, bone, progress);
  // The same bone has the same picture, whoever shows it.
  const std::uint64_t id = picture_id("whole " + std::to_string(picture.look.id));
  picture.mesh =
      std::make_shared<const BoneMesh>(mesh_of(id, uncut_solid(solid_of(bone)), picture.look));
  return picture;
}

/// What a patch is built with; the mesh it lies on stays while it is at hand.
struct BoneBeingCut::KerfAtHand {
  KerfAtHand(std::shared_ptr<const BoneMesh> on, const Bvh& bvh, const KerfSet& kerfs,
             std::int32_t number)
      : kerf(number),
        mesh(std::move(on)),
        growing({mesh->solid, bvh}, kerfs.plane(number), number, kerfs.field(number).grid()) {}

  std::int32_t kerf;
  std::shared_ptr<const BoneMesh> mesh;
  GrowingKerf growing;
};

BoneBeingCut::BoneBeingCut(LiveAttempt& attempt, BonePicture picture)
    : name_(attempt.attempt().text),
      world_from_bone_(attempt.prepared_case().bone.world_from_bone),
      picture_(std::move(picture)),
      watch_(attempt.watch()),
      geometry_(attempt.prepared_case().bone, attempt.prepared_case().scenario.saw.blade,
                scenarios::planned_bridge(attempt.prepared_case().plan)) {
  newest_.bodies = {{picture_.mesh, world_from_bone_}};
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

BoneBeingCut::~BoneBeingCut() = default;

void BoneBeingCut::add_to(Scene& scene) {
  {
    const std::scoped_lock turn(turn_);
    drawn_.bodies = newest_.bodies;
    if (drawn_.patch_revision != newest_.patch_revision) {
      std::swap(drawn_.patch, newest_.patch);
      drawn_.patch_revision = newest_.patch_revision;
    }
  }
  for (const Body& body : drawn_.bodies) {
    BoneInScene bone;
    bone.mesh = body.mesh.get();
    bone.look = &picture_.look;
    bone.world_from_bone = body.world_from_body;
    if (&body == &drawn_.bodies.front() && drawn_.patch_revision != 0) {
      bone.patch = &drawn_.patch;
      bone.patch_revision = drawn_.patch_revision;
    }
    scene.bones.push_back(bone);
  }
}

std::vector<CutEvent> BoneBeingCut::take_events() {
  const std::scoped_lock turn(turn_);
  return std::exchange(events_, {});
}

/// Without a picture the attempt goes on: then the feed is only kept from filling.
void BoneBeingCut::run(const std::stop_token& stop) {
  try {
    follow(stop);
  } catch (const std::exception&) {
    has_failed_.store(true, std::memory_order_release);
  }
  GeometryFeed unseen;
  while (!stop.stop_requested() && !watch_.closed.load(std::memory_order_acquire)) {
    while (watch_.feed.pop(unseen)) continue;
    std::this_thread::sleep_for(between_patches);
  }
}

void BoneBeingCut::follow(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    const bool is_closed = watch_.closed.load(std::memory_order_acquire);
    if (take_feed()) is_up_to_date_.store(false, std::memory_order_release);
    bring_up_to_date();
    if (!has_grown_ && !is_solid_due_) is_up_to_date_.store(true, std::memory_order_release);
    if (is_closed && watch_.feed.size() == 0) return;
    std::this_thread::sleep_for(between_patches);
  }
}

/// True where there was anything that may change the bone.
bool BoneBeingCut::take_feed() {
  GeometryFeed feed;
  const std::size_t waiting = watch_.feed.size();
  for (std::size_t i = 0; i < waiting && watch_.feed.pop(feed); ++i) {
    std::visit([this](const auto& value) { take(value); }, feed);
  }
  return has_grown_ || is_solid_due_;
}

void BoneBeingCut::take(const ToolSample& sample) {
  tick_ = sample.tick;
  geometry_.follow(sample);
  if (sample.kerf < 0 || !has(sample.status, ToolStatus::SawOn)) return;
  kerf_ = sample.kerf;
  has_grown_ = true;
}

void BoneBeingCut::take(const CutEvent& event) {
  geometry_.follow(event);
  if (event.kind == CutEventKind::PieceRemoved) {
    at_hand_.reset();
    is_solid_due_ = true;
  }
  if (event.kind == CutEventKind::HingeClosed) show_hinge(transform_from(event.pose));
  const std::scoped_lock turn(turn_);
  events_.push_back(event);
}

/// The same jobs at the same places as the loop's own: so pieces have the same numbers here.
void BoneBeingCut::take(const JobRequest& request) {
  if (request.kind == JobKind::Section) return;
  std::unique_ptr<const JobResult> result = geometry_.run(request);
  if (request.kind == JobKind::Hinge) hinge_ = std::move(result);
}

void BoneBeingCut::bring_up_to_date() {
  if (has_grown_ && (at_hand_ == nullptr || at_hand_->kerf != kerf_)) begin_kerf(kerf_);
  if (has_grown_ && at_hand_ != nullptr) show_patch();
  if (has_grown_ && at_hand_ == nullptr && tick_ >= solid_tick_ + ticks_between_solids) {
    is_solid_due_ = true;
  }
  if (!is_solid_due_) return;
  if (const std::optional<CutSolid> solid = geometry_.solid_without(-1)) show_solid(*solid);
  is_solid_due_ = has_grown_ = false;
  solid_tick_ = tick_;
}

void BoneBeingCut::begin_kerf(std::int32_t kerf) {
  at_hand_.reset();
  const std::optional<CutSolid> base = geometry_.solid_without(kerf);
  if (!base) return;
  auto mesh = geometry_.is_only_kerf(kerf) ? picture_.mesh : lit_mesh(*base);
  const Bvh bvh(mesh->solid.mesh);
  at_hand_ = std::make_unique<KerfAtHand>(std::move(mesh), bvh, geometry_.kerfs(), kerf);
}

/// A frame whose outline is not simple shows the patch before it.
void BoneBeingCut::show_patch() {
  has_grown_ = false;
  if (!at_hand_->growing.follow(geometry_.kerfs().field(at_hand_->kerf), patch_)) return;
  const std::scoped_lock turn(turn_);
  newest_.bodies = {{at_hand_->mesh, world_from_bone_}};
  std::swap(newest_.patch, patch_);
  newest_.patch_revision = next_revision_++;
}

void BoneBeingCut::show_solid(const CutSolid& solid) {
  publish({{lit_mesh(solid), world_from_bone_}});
}

void BoneBeingCut::show_hinge(const RigidTransform& bone_from_moved) {
  if (hinge_ == nullptr || hinge_->hinge.outcome != HingeOutcome::Closed) return;
  at_hand_.reset();
  is_solid_due_ = has_grown_ = false;
  publish({{lit_mesh(hinge_->hinge.fixed), world_from_bone_},
           {lit_mesh(hinge_->hinge.moved), world_from_bone_ * bone_from_moved}});
}

std::shared_ptr<const BoneMesh> BoneBeingCut::lit_mesh(const CutSolid& solid) {
  return std::make_shared<const BoneMesh>(
      lit_mesh_of(picture_id(name_ + std::to_string(meshes_++)), solid, picture_.look));
}

void BoneBeingCut::publish(std::vector<Body> bodies) {
  const std::scoped_lock turn(turn_);
  newest_.bodies = std::move(bodies);
  newest_.patch_revision = 0;
}

}  // namespace hallux::ui
