// A picture in three layers: shapes of what stands still, light on them, and what moves drawn over
// it. The first two are kept from picture to picture and drawn again only where bones changed or
// a tool's shadow went, because a processor that draws cannot afford all of it. With a card
// nothing is kept: it would cost more than it saves. Edges are smooth by drawing more pixels and
// halving them, and by a pass over the stairs that are left: of what stands still only where it was
// drawn again, of what moves where tools are.
#include "ui/render/renderer.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "ui/render/gl/headless_context.h"
#include "ui/render/painters/bone_painter.h"
#include "ui/render/painters/edge_painter.h"
#include "ui/render/painters/frame.h"
#include "ui/render/painters/hand_tool_painter.h"
#include "ui/render/painters/hole_painter.h"
#include "ui/render/painters/implant_painter.h"
#include "ui/render/painters/overlay_painter.h"
#include "ui/render/painters/saw_painter.h"
#include "ui/render/painters/site_painter.h"
#include "ui/render/painters/still_scene.h"
#include "ui/render/painters/surface_painter.h"
#include "ui/render/painters/tool_pixels.h"
#include "ui/render/painters/tool_shadow.h"

namespace hallux::ui {

namespace {

/// How long bones stay with the card that no picture shows, and what a passing one was drawn in.
constexpr std::uint64_t pictures_with_bones = 300, pictures_with_passing_room = 10;

PixelSize enlarged(PixelSize size, int scale) noexcept {
  return {at_least_one(size).width * scale, at_least_one(size).height * scale};
}
/// How edges are smoothed: not at all, what stands still and what moves each for itself, or once
/// all of the picture.
enum class EdgePass : std::uint8_t { None, StillAndMoving, Whole };

bool needs_smooth(EdgePass edges, int scale) noexcept {
  return edges == EdgePass::StillAndMoving || (edges == EdgePass::Whole && scale > 1);
}

}  // namespace

RenderQuality live_quality() {
  const bool is_software = is_software_renderer();
  return {.supersampling = is_software ? 1 : 2, .keeps_still = is_software, .smooths_edges = true};
}

struct KeptPicture::Still {
  StillScene scene;
  std::vector<std::uint64_t> revisions;  ///< one for each bone
  std::optional<ToolShadow> shadow;
};

struct KeptPicture::Parts {
  std::optional<PictureBuffers> buffers;
  std::optional<Still> still;  ///< what the buffers show; none: nothing yet
  /// Each half as large as the one before, down to twice the picture's size.
  std::vector<RenderTarget> halved;

  bool has_room(PixelSize size, int scale, EdgePass edges) const noexcept;
  void make_room(PixelSize size, int scale, EdgePass edges);
  void let_go() noexcept;
};

bool KeptPicture::Parts::has_room(PixelSize size, int scale, EdgePass edges) const noexcept {
  return buffers && buffers->size() == enlarged(size, scale) &&
         buffers->has_smooth() >= needs_smooth(edges, scale);
}

/// A picture of another size begins anew.
void KeptPicture::Parts::make_room(PixelSize size, int scale, EdgePass edges) {
  if (has_room(size, scale, edges)) return;
  const PixelSize large = enlarged(size, scale);
  let_go();
  buffers.emplace(large, needs_smooth(edges, scale));
  for (int part = scale / 2; part > 1; part /= 2) {
    halved.emplace_back(PixelSize{large.width * part / scale, large.height * part / scale});
  }
}

void KeptPicture::Parts::let_go() noexcept {
  still.reset();
  buffers.reset();
  halved.clear();
}

KeptPicture::KeptPicture() : parts_(std::make_unique<Parts>()) {}
KeptPicture::~KeptPicture() = default;
KeptPicture::KeptPicture(KeptPicture&&) noexcept = default;
KeptPicture& KeptPicture::operator=(KeptPicture&&) noexcept = default;

struct Renderer::Parts {
  RenderQuality quality;
  OverlayPainter overlays;
  NoiseTextures noise;
  BonePainter bones{noise};
  PartPainter parts{noise};
  SawPainter saw{noise, parts};
  HandToolPainter hand_tools{parts};
  ImplantPainter implants{parts};
  HolePainter holes;
  SurfacePainter surface;
  SitePainter site;
  EdgePainter edges;
  KeptPicture passing;  ///< for pictures of which nothing is kept
  std::uint64_t picture = 0;
  std::uint64_t passing_picture = 0;  ///< the last of those
  DrawCounts counts;

  KeptPicture::Still still_of(const Frame& frame) const;
  PixelBox changed_pixels(const Frame& frame, const KeptPicture::Parts& kept,
                          const KeptPicture::Still& now) const;
  void draw(const Scene& scene, const EyeView& view, const DrawTarget& target, KeptPicture& kept,
            double detail, EdgePass pass);
  void draw_all(const Frame& frame, KeptPicture::Parts& kept, EdgePass pass);
  void draw_shapes(const Frame& frame, const PictureBuffers& buffers, const PixelBox& part);
  void draw_still(const Frame& frame, const PictureBuffers& buffers,
                  std::span<const PixelBox> boxes);
  void smooth_still(const Frame& frame, const PictureBuffers& buffers,
                    std::span<const PixelBox> boxes);
  void draw_moving(const Frame& frame);
  void deliver(const Frame& frame, const KeptPicture::Parts& drawn, const DrawTarget& target,
               EdgePass pass);
};

KeptPicture::Still Renderer::Parts::still_of(const Frame& frame) const {
  return {still_scene(frame.scene, frame.view, frame.pixel_scale), bones.revisions(frame.scene),
          tool_shadow(frame.scene, frame.key_light)};
}

/// Where the buffers do not show what stands still now.
PixelBox Renderer::Parts::changed_pixels(const Frame& frame, const KeptPicture::Parts& kept,
                                         const KeptPicture::Still& now) const {
  if (!kept.still || kept.still->scene != now.scene) return all_of(frame.target.size);
  const auto changed = bones.changed_since(frame.scene, kept.still->revisions);
  if (!changed) return all_of(frame.target.size);
  return ui::changed_pixels(now.scene, *changed, frame.target.size);
}

namespace {

/// Where light is to be laid anew, `changed` included. Without a tool another shader lays it:
/// then everywhere.
std::vector<PixelBox> relit_pixels(const Frame& frame, const PixelBox& changed, const auto& before,
                                   const auto& now) {
  if (!before || before->shadow.has_value() != now.shadow.has_value()) {
    return {all_of(frame.target.size)};
  }
  if (changed == all_of(frame.target.size)) return {changed};
  PixelTiles tiles{frame.target.size};
  if (before->shadow != now.shadow) {
    const std::array shadows{*before->shadow, *now.shadow};
    tiles = shaded_pixels(frame.scene, shadows, frame.view, frame.target.size);
  }
  tiles.add(changed);
  return tiles.boxes();
}

}  // namespace

void Renderer::Parts::draw_all(const Frame& frame, KeptPicture::Parts& kept, EdgePass pass) {
  bones.show(frame.scene, picture);
  begin_drawing(frame.target.size);
  KeptPicture::Still now = still_of(frame);
  const PixelBox changed = changed_pixels(frame, kept, now);
  const std::vector<PixelBox> relit = relit_pixels(frame, changed, kept.still, now);
  kept.still.reset();  // until all of it is drawn
  if (!changed.is_empty()) draw_shapes(frame, *kept.buffers, changed);
  if (!relit.empty()) draw_still(frame, *kept.buffers, relit);
  if (pass == EdgePass::StillAndMoving) {
    if (!relit.empty()) smooth_still(frame, *kept.buffers, relit);
    kept.buffers->copy_smooth_to_picture();
  } else {
    kept.buffers->copy_still_to_picture();
  }
  kept.still = std::move(now);
  draw_moving(frame);
  end_drawing();
  counts = {bones.triangle_count() + saw.triangle_count(frame.scene) +
                hand_tools.triangle_count(frame.scene) + implants.triangle_count(frame.scene),
            pixel_count(changed), pixel_count(relit), bones.uploaded_bytes()};
}

void Renderer::Parts::draw_shapes(const Frame& frame, const PictureBuffers& buffers,
                                  const PixelBox& part) {
  set_scissor(part);
  glBindFramebuffer(GL_FRAMEBUFFER, buffers.shapes());
  glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  // At the bones' rims textures are read as coarsely as places change towards the ground: that must
  // not be an older picture's.
  constexpr std::array<float, 4> nowhere{};
  glClearBufferfv(GL_COLOR, 0, nowhere.data());
  bones.draw_shapes(frame, part);
}

void Renderer::Parts::draw_still(const Frame& frame, const PictureBuffers& buffers,
                                 std::span<const PixelBox> boxes) {
  set_scissor(all_of(frame.target.size));
  glBindFramebuffer(GL_FRAMEBUFFER, buffers.still().framebuffer);
  overlays.draw_ground(frame, boxes);
  bones.draw_light(frame, boxes);
}

void Renderer::Parts::smooth_still(const Frame& frame, const PictureBuffers& buffers,
                                   std::span<const PixelBox> boxes) {
  edges.smooth(buffers.still_texture(), buffers.smooth(), within_reach(boxes, frame.target.size));
  begin_drawing(frame.target.size);
}

void Renderer::Parts::draw_moving(const Frame& frame) {
  glEnable(GL_SCISSOR_TEST);
  set_scissor(all_of(frame.target.size));
  holes.draw(frame);
  surface.draw_lines(frame);
  surface.draw_halo(frame);
  site.draw_held(frame);
  implants.draw_planned(frame);
  implants.draw_standing(frame);
  saw.draw(frame);
  hand_tools.draw(frame);
  overlays.draw_chips(frame);
  saw.draw_ghosts(frame);
  hand_tools.draw_blur(frame);
  site.draw_zones(frame);
  overlays.draw_planes(frame);
  bones.draw_outlines(frame);
  saw.draw_seen_through(frame);
  hand_tools.draw_seen_through(frame);
  overlays.draw_marks(frame);
}

namespace {

/// By halves: a linear copy to half the size takes the mean of four pixels, to less it would leave
/// some out.
void copy_by_halves(DrawTarget from, const std::vector<RenderTarget>& halved,
                    const DrawTarget& target) {
  for (const RenderTarget& half : halved) {
    copy_picture(from, half.target());
    from = half.target();
  }
  copy_picture(from, target);
}

}  // namespace

void Renderer::Parts::deliver(const Frame& frame, const KeptPicture::Parts& drawn,
                              const DrawTarget& target, EdgePass pass) {
  const PictureBuffers& buffers = *drawn.buffers;
  const std::array whole{all_of(buffers.size())};
  if (pass == EdgePass::Whole && buffers.has_smooth()) {
    edges.smooth(buffers.picture_texture(), buffers.smooth(), whole);
    return copy_by_halves(buffers.smooth(), drawn.halved, target);
  }
  if (pass == EdgePass::Whole) return edges.smooth(buffers.picture_texture(), target, whole);
  copy_by_halves(buffers.picture(), drawn.halved, target);
  if (pass == EdgePass::None || target.size != buffers.size()) return;
  const auto boxes = tool_pixels(frame.scene, frame.view, buffers.size()).boxes();
  if (boxes.empty()) return;
  edges.smooth_moving(buffers.picture_texture(), buffers.smooth_texture(), target, boxes);
}

void Renderer::Parts::draw(const Scene& scene, const EyeView& view, const DrawTarget& target,
                           KeptPicture& kept, double detail, EdgePass pass) {
  ++picture;
  KeptPicture::Parts& room = *kept.parts_;
  // Where one picture gives way to another, there is never room for both.
  if (&kept != &passing && !room.has_room(target.size, quality.supersampling, pass))
    passing.parts_->let_go();
  room.make_room(target.size, quality.supersampling, pass);
  const Frame frame = frame_of(scene, view, *room.buffers, quality.supersampling * detail);
  draw_all(frame, room, pass);
  deliver(frame, room, target, pass);
  if (&kept == &passing) passing_picture = picture;
  if (picture == passing_picture + pictures_with_passing_room) passing.parts_->let_go();
  if (picture > pictures_with_bones) bones.forget_before(picture - pictures_with_bones);
}

Renderer::Renderer(const RenderQuality& quality) : parts_(std::make_unique<Parts>()) {
  parts_->quality = quality;
}

Renderer::~Renderer() = default;

void Renderer::draw(const Scene& scene, const EyeView& view, const DrawTarget& target) {
  draw(scene, view, target, parts_->passing);
}

void Renderer::draw(const Scene& scene, const EyeView& view, const DrawTarget& target,
                    KeptPicture& kept, double detail) {
  Parts& parts = *parts_;
  const bool is_passing = &kept == &parts.passing || !parts.quality.keeps_still;
  if (is_passing) parts.passing.parts_->still.reset();
  const EdgePass pass = !parts.quality.smooths_edges ? EdgePass::None
                        : is_passing                 ? EdgePass::Whole
                                                     : EdgePass::StillAndMoving;
  parts.draw(scene, view, target, is_passing ? parts.passing : kept, detail, pass);
}

void Renderer::draw(const Scene& scene, const Camera& camera, const DrawTarget& target) {
  const double aspect = static_cast<double>(std::max(target.size.width, 1)) /
                        static_cast<double>(std::max(target.size.height, 1));
  draw(scene, view_of(camera, Viewer{}, Eye::Middle, aspect), target);
}

void Renderer::draw_sample(const Scene& scene, const EyeView& view, const DrawTarget& target,
                           KeptPicture& kept) {
  KeptPicture& room = parts_->quality.keeps_still ? kept : parts_->passing;
  room.parts_->still.reset();
  parts_->draw(scene, view, target, room, 1.0, EdgePass::None);
  room.parts_->still.reset();
}

void Renderer::draw_sample(const Scene& scene, const EyeView& view, const DrawTarget& target) {
  draw_sample(scene, view, target, parts_->passing);
}

void Renderer::forget_passing() noexcept { parts_->passing.parts_->let_go(); }

void Renderer::forget_bones() noexcept {
  parts_->bones.forget_before(parts_->picture + 1);
  forget_passing();
}

void Renderer::set_quality(const RenderQuality& quality) noexcept { parts_->quality = quality; }

const RenderQuality& Renderer::quality() const noexcept { return parts_->quality; }

const DrawCounts& Renderer::counts() const noexcept { return parts_->counts; }

}  // namespace hallux::ui
