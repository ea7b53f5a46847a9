// The bone while it is cut, on a thread that may fall behind and never holds anything up. It takes
// the loop's feed, runs the same jobs at the same places, and hands the window the newest picture.
// A growing kerf is a patch on a mesh that stands still; whatever changes the mesh itself is made
// anew. Where that fails for want of memory, the attempt goes on without a new picture.
#include "ui/screens/operating/site/bone_being_cut.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "scenarios/tray/laid_out_tools.h"
#include "ui/screens/pictures/bone_viewport.h"
#include "ui/screens/pictures/cached_look.h"

namespace hallux::ui {

namespace {

using namespace simulator;

/// A patch for each frame that a display may show.
constexpr std::chrono::milliseconds between_patches{15};
constexpr std::chrono::milliseconds between_sections{50};
/// A plane that moved less, out of itself, has the same section.
constexpr double same_section_mm = 0.1, same_section_rad = 0.0035;

bool is_wanted(const SiteFacts& site, std::int32_t piece) {
  return std::ranges::any_of(site.parts, [&](const scenarios::WantedPart& part) {
    return part.is_off && std::ranges::find(part.pieces, piece) != part.pieces.end();
  });
}

}  // namespace

BonePictures pictures_of(const std::shared_ptr<const PreparedCase>& prepared_case,
                         const std::filesystem::path& data_directory, const Progress& progress) {
  BonePictures pictures;
  const double share = 1.0 / static_cast<double>(prepared_case->bones.size());
  for (std::size_t bone = 0; bone < prepared_case->bones.size(); ++bone) {
    const simulator::WholeBone& whole = *prepared_case->wholes[bone];
    const double from = share * static_cast<double>(bone);
    BonePicture& picture = pictures.emplace_back();
    picture.look = cached_look_of(data_directory, prepared_case->bones[bone],
                                  part_of(progress, from, from + share));
    // The same bone has the same picture, whoever shows it.
    const std::uint64_t id = picture_id("whole " + std::to_string(picture.look.id));
    picture.mesh = std::make_shared<const BoneMesh>(mesh_of(id, whole.solid, picture.look));
    picture.tree = {prepared_case, &whole.tree};
  }
  return pictures;
}

namespace {

std::vector<BoneToCut> bones_to_cut(const PreparedCase& prepared_case) {
  std::vector<BoneToCut> bones;
  for (std::size_t bone = 0; bone < prepared_case.bones.size(); ++bone)
    bones.push_back({*prepared_case.wholes[bone], prepared_case.bones[bone].world_from_bone});
  return bones;
}

}  // namespace

BoneBeingCut::BoneBeingCut(std::string name, const PreparedCase& prepared_case,
                           simulator::AttemptWatch& watch, BonePictures pictures)
    : name_(std::move(name)),
      world_from_bone_(prepared_case.bone().world_from_bone),
      pictures_(std::move(pictures)),
      watch_(watch),
      cut_(bones_to_cut(prepared_case), scenarios::tray_of(prepared_case.scenario),
           scenarios::planned_bridges(prepared_case.plan)),
      survey_(prepared_case) {
  for (const BonePicture& picture : pictures_)
    bodies_.push_back(Body{picture.mesh, picture.tree, &picture.look});
  newest_.bodies = bodies_;
  for (const simulator::Bone& bone : prepared_case.bones)
    newest_.world_from_fragments.push_back(bone.world_from_bone);
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

BoneBeingCut::~BoneBeingCut() = default;

void BoneBeingCut::add_to(Scene& scene) {
  {
    const std::scoped_lock turn(turn_);
    drawn_.bodies = newest_.bodies;
    drawn_.world_from_fragments = newest_.world_from_fragments;
    drawn_.free_pieces = newest_.free_pieces;
    drawn_.metal = newest_.metal;
    drawn_.patched = newest_.patched;
    drawn_site_ = site_;
    if (drawn_.patch_revision != newest_.patch_revision) {
      std::swap(drawn_.patch, newest_.patch);
      drawn_.patch_revision = newest_.patch_revision;
    }
  }
  for (std::size_t fragment = 0; fragment < drawn_.bodies.size(); ++fragment) {
    const std::optional<Body>& body = drawn_.bodies[fragment];
    if (!body) continue;
    BoneInScene& bone = scene.bones.emplace_back();
    bone.mesh = body->mesh.get();
    bone.look = body->look;
    bone.world_from_bone = drawn_.world_from_fragments[fragment];
    if (fragment != drawn_.patched || drawn_.patch_revision == 0) continue;
    bone.patch = &drawn_.patch;
    bone.patch_revision = drawn_.patch_revision;
  }
  add_metal(scene, drawn_.metal, [this](std::int32_t fragment) {
    return drawn_.world_from_fragments[static_cast<std::size_t>(fragment)];
  });
}

std::vector<BoneSurface> BoneBeingCut::surfaces() const {
  std::vector<BoneSurface> surfaces;
  for (std::size_t fragment = 0; fragment < drawn_.bodies.size(); ++fragment) {
    if (const std::optional<Body>& body = drawn_.bodies[fragment])
      surfaces.push_back({*body->tree, drawn_.world_from_fragments[fragment]});
  }
  return surfaces;
}

std::optional<FragmentSurface> BoneBeingCut::fragment(std::int32_t number) const {
  const auto fragment = static_cast<std::size_t>(number);
  if (fragment >= drawn_.bodies.size() || !drawn_.bodies[fragment]) return std::nullopt;
  const Body& body = *drawn_.bodies[fragment];
  return FragmentSurface{body.mesh.get(), body.tree.get(), drawn_.world_from_fragments[fragment]};
}

void BoneBeingCut::add_free_pieces(Scene& scene) const {
  for (const PieceMesh& piece : drawn_.free_pieces) {
    if (drawn_site_ == nullptr || !is_wanted(*drawn_site_, piece.id)) continue;
    const auto fragment = static_cast<std::size_t>(piece.fragment);
    scene.free_pieces.push_back({piece.mesh.get(), drawn_.world_from_fragments[fragment]});
  }
}

std::shared_ptr<const KerfSection> BoneBeingCut::section() {
  const std::scoped_lock turn(turn_);
  return section_;
}

std::shared_ptr<const SiteFacts> BoneBeingCut::site() {
  const std::scoped_lock turn(turn_);
  return site_;
}

std::vector<CutEvent> BoneBeingCut::take_events() {
  const std::scoped_lock turn(turn_);
  return std::exchange(events_, {});
}

/// Without a picture the attempt goes on: then the feed is only kept from filling.
void BoneBeingCut::run(const std::stop_token& stop) {
  try {
    show_feed(stop);
  } catch (const std::exception&) {
    has_failed_.store(true, std::memory_order_release);
  }
  GeometryFeed dropped;
  while (!stop.stop_requested() && !watch_.closed.load(std::memory_order_acquire)) {
    while (watch_.feed.pop(dropped)) continue;
    std::this_thread::sleep_for(between_patches);
  }
}

void BoneBeingCut::show_feed(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    const bool is_closed = watch_.closed.load(std::memory_order_acquire);
    if (take_feed()) is_up_to_date_.store(false, std::memory_order_release);
    bring_up_to_date();
    renew_section();
    renew_site();
    if (!cut_.is_due()) is_up_to_date_.store(true, std::memory_order_release);
    if (is_closed && watch_.feed.size() == 0) return;
    std::this_thread::sleep_for(between_patches);
  }
}

/// True where there was anything that may change the bone.
bool BoneBeingCut::take_feed() {
  GeometryFeed feed;
  const std::size_t waiting = watch_.feed.size();
  for (std::size_t i = 0; i < waiting && watch_.feed.pop(feed); ++i) {
    std::visit([this](const auto& value) { cut_.apply(value); }, feed);
    if (const auto* event = std::get_if<CutEvent>(&feed)) note(*event);
    if (const auto* request = std::get_if<simulator::JobRequest>(&feed)) survey_.apply(*request);
    if (const auto* sample = std::get_if<ToolSample>(&feed)) {
      world_from_tool_ = transform_from(sample->world_from_tool);
      survey_.apply(*sample);
    }
  }
  return cut_.is_due();
}

void BoneBeingCut::note(const CutEvent& event) {
  survey_.apply(event, cut_);
  const std::scoped_lock turn(turn_);
  events_.push_back(event);
}

/// Places come first: nothing is shown of a fragment that lies nowhere yet.
void BoneBeingCut::bring_up_to_date() {
  bodies_.resize(static_cast<std::size_t>(cut_.fragment_count()));
  show_places();
  if (std::optional<PatchBase> base = cut_.take_base()) show_base(std::move(*base));
  // A frame whose outline is not simple shows the patch before it.
  if (cut_.build_patch(patch_)) show_patch();
  for (const DueFragment& due : cut_.take_due()) show_fragment(due);
  if (const auto pieces = cut_.take_free_pieces()) show_free_pieces(*pieces);
}

void BoneBeingCut::show_base(PatchBase base) {
  const auto fragment = static_cast<std::size_t>(base.fragment);
  if (!base.is_uncut()) {
    bodies_[fragment] = lit_body(base.solid, std::move(base.tree), look_of(base.fragment));
    return;
  }
  const BonePicture& picture = pictures_[fragment];
  bodies_[fragment] = Body{picture.mesh, picture.tree, &picture.look};
}

const BoneLook& BoneBeingCut::look_of(std::int32_t fragment) const noexcept {
  return pictures_[static_cast<std::size_t>(cut_.kerfs().fragments()[fragment].bone)].look;
}

/// Patch and base come together.
void BoneBeingCut::show_patch() {
  const std::scoped_lock turn(turn_);
  newest_.bodies = bodies_;
  newest_.patched = static_cast<std::size_t>(cut_.fragment_at_hand());
  std::swap(newest_.patch, patch_);
  newest_.patch_revision = next_revision_++;
}

void BoneBeingCut::show_fragment(const DueFragment& due) {
  const auto fragment = static_cast<std::size_t>(due.fragment);
  bodies_[fragment].reset();
  if (!due.solid.mesh.triangles.empty()) {
    bodies_[fragment] =
        lit_body(due.solid, std::make_shared<const Bvh>(due.solid.mesh), look_of(due.fragment));
  }
  const std::scoped_lock turn(turn_);
  newest_.bodies = bodies_;
  if (newest_.patched == fragment) newest_.patch_revision = 0;
}

void BoneBeingCut::show_free_pieces(const std::vector<FreedPiece>& pieces) {
  std::vector<PieceMesh> meshes;
  meshes.reserve(pieces.size());
  for (const FreedPiece& piece : pieces) {
    meshes.push_back({piece.id, piece.fragment,
                      std::make_shared<const BoneMesh>(
                          mesh_of(next_mesh_id(), piece.solid, look_of(piece.fragment)))});
  }
  const std::scoped_lock turn(turn_);
  newest_.free_pieces = std::move(meshes);
}

/// Where the fragments lie, and the metal in them.
void BoneBeingCut::show_places() {
  std::vector<RigidTransform> places;
  std::vector<FragmentSkin> skins;
  for (std::size_t fragment = 0; fragment < bodies_.size(); ++fragment) {
    places.push_back(cut_.world_from_fragment(static_cast<std::int32_t>(fragment)));
    const std::optional<Body>& body = bodies_[fragment];
    skins.push_back(body ? FragmentSkin{&body->mesh->solid.mesh, body->tree.get(), body->mesh->id}
                         : FragmentSkin{});
  }
  MetalShown metal = metal_.renew(cut_, skins);
  const std::scoped_lock turn(turn_);
  newest_.world_from_fragments = std::move(places);
  newest_.metal = std::move(metal);
}

/// Of several bones the nearest to the tool: the other may be the one that is to be sawn next.
std::int32_t BoneBeingCut::fragment_to_section() const {
  std::int32_t nearest = cut_.fragment_at_hand();
  if (cut_.kerfs().fragments().bone_count() == 1) return nearest;
  double least_mm = std::numeric_limits<double>::infinity();
  for (std::int32_t fragment = 0; fragment < cut_.fragment_count(); ++fragment) {
    const std::optional<Body>& body = bodies_[static_cast<std::size_t>(fragment)];
    if (!body) continue;
    const Vec3 tip_mm = transform_point(inverse(cut_.world_from_fragment(fragment)),
                                        world_from_tool_->translation_mm);
    const auto near = body->tree->nearest(tip_mm, least_mm);
    if (!near) continue;
    least_mm = near->distance_mm;
    nearest = fragment;
  }
  return nearest;
}

/// In the kerf's plane while the blade lies in it, else in the blade's own, where nothing is open.
void BoneBeingCut::renew_section() {
  if (!world_from_tool_) return;
  const std::int32_t fragment = fragment_to_section();
  const std::optional<Body>& body = bodies_[static_cast<std::size_t>(fragment)];
  if (!body) return;
  const RigidTransform fragment_from_tool =
      inverse(cut_.world_from_fragment(fragment)) * *world_from_tool_;
  std::optional<KerfPlane> kerf = cut_.plane_at_hand();
  if (fragment != cut_.fragment_at_hand()) kerf.reset();
  const bool is_in_kerf = kerf && is_in_plane(kerf->bone_from_kerf, fragment_from_tool);
  const RigidTransform plane = is_in_kerf ? kerf->bone_from_kerf : fragment_from_tool;
  const std::uint64_t opened = is_in_kerf ? next_revision_ : 0;
  if (!section_clock_.is_due(plane, opened, std::chrono::steady_clock::now())) return;
  const KerfOpening opening = is_in_kerf ? *cut_.kerf_at_hand() : KerfOpening{{plane}, {}};
  KerfSection section = kerf_section(body->mesh->solid, *body->tree, opening);
  const FragmentPose& lies = cut_.kerfs().fragments()[fragment];
  if (lies.is_moved || lies.bone != 0)
    section.bone_from_plane =
        inverse(world_from_bone_) * cut_.world_from_fragment(fragment) * section.bone_from_plane;
  auto made = std::make_shared<const KerfSection>(std::move(section));
  const std::scoped_lock turn(turn_);
  section_ = std::move(made);
}

void BoneBeingCut::renew_site() {
  if (!world_from_tool_) return;
  std::optional<SiteFacts> facts = survey_.renew(cut_, std::chrono::steady_clock::now());
  if (!facts) return;
  auto site = std::make_shared<const SiteFacts>(std::move(*facts));
  const std::scoped_lock turn(turn_);
  site_ = std::move(site);
}

bool SectionClock::is_due(const RigidTransform& bone_from_plane, std::uint64_t opened, Time now) {
  if (bone_from_plane_ && now - last_ < between_sections) return false;
  if (bone_from_plane_ && opened == opened_) {
    const RigidTransform moved = inverse(*bone_from_plane_) * bone_from_plane;
    const Vec3 normal = moved.rotation * Vec3(0.0, 0.0, 1.0);
    if (std::abs(moved.translation_mm.z) < same_section_mm &&
        glm::length(Vec2(normal.x, normal.y)) < same_section_rad)
      return false;
  }
  bone_from_plane_ = bone_from_plane;
  opened_ = opened;
  last_ = now;
  return true;
}

std::uint64_t BoneBeingCut::next_mesh_id() { return picture_id(name_ + std::to_string(meshes_++)); }

BoneBeingCut::Body BoneBeingCut::lit_body(const CutSolid& solid, std::shared_ptr<const Bvh> tree,
                                          const BoneLook& look) {
  BoneMesh mesh = mesh_of(next_mesh_id(), solid, look);
  const Occluder own{tree.get(), {}};
  light_cut_faces(mesh, std::span(&own, 1));
  return {std::make_shared<const BoneMesh>(std::move(mesh)), std::move(tree), &look};
}

}  // namespace hallux::ui
