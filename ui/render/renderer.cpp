#include "ui/render/renderer.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "ui/render/bone_painter.h"
#include "ui/render/frame.h"
#include "ui/render/headless_context.h"
#include "ui/render/overlay_painter.h"
#include "ui/render/saw_painter.h"

namespace hallux::ui {

namespace {

constexpr std::uint64_t kept_pictures = 300;

/// Drawing begins from a state that is said, not from the one that somebody left.
void begin_drawing(const Frame& frame) {
  glBindFramebuffer(GL_FRAMEBUFFER, frame.shapes);
  glViewport(0, 0, frame.target.size.width, frame.target.size.height);
  glScissor(0, 0, frame.target.size.width, frame.target.size.height);
  glEnable(GL_SCISSOR_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  glStencilMask(0xff);
  glDisable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_BACK);
  glFrontFace(GL_CCW);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glClearDepth(1.0);
  glClearStencil(0);
  glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

void end_drawing() {
  glBindVertexArray(0);
  glUseProgram(0);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
}

}  // namespace

RenderQuality live_quality() { return {.supersampling = is_software_renderer() ? 1 : 2}; }

struct Renderer::Parts {
  RenderQuality quality;
  OverlayPainter overlays;
  NoiseTextures noise;
  BonePainter bones{noise};
  SawPainter saw{noise};
  std::optional<PictureBuffers> buffers;
  std::vector<RenderTarget>
      halved;  ///< each half as large as the one before, down to twice the picture's size
  std::uint64_t picture = 0;
  DrawCounts counts;

  void make_room(PixelSize size);
  void draw_all(const Frame& frame);
  void copy_into(const DrawTarget& target);
};

void Renderer::Parts::make_room(PixelSize size) {
  const int scale = quality.supersampling;
  const PixelSize large{at_least_one(size).width * scale, at_least_one(size).height * scale};
  if (buffers && buffers->size() == large) return;
  buffers.reset();
  halved.clear();
  buffers.emplace(large);
  for (int part = scale / 2; part > 1; part /= 2) {
    halved.emplace_back(PixelSize{large.width * part / scale, large.height * part / scale});
  }
}

void Renderer::Parts::draw_all(const Frame& frame) {
  begin_drawing(frame);
  bones.draw_shapes(frame, picture);
  glBindFramebuffer(GL_FRAMEBUFFER, frame.target.framebuffer);
  overlays.draw_ground(frame);
  bones.draw_light(frame);
  saw.draw(frame);
  overlays.draw_chips(frame);
  saw.draw_ghosts(frame);
  overlays.draw_planes(frame);
  saw.draw_seen_through(frame);
  overlays.draw_marks(frame);
  end_drawing();
  counts = {bones.triangle_count() + (frame.scene.saw ? saw.triangle_count() : 0),
            bones.uploaded_bytes()};
}

/// By halves: a linear copy to half the size takes the mean of four pixels, to less it would leave some out.
void Renderer::Parts::copy_into(const DrawTarget& target) {
  DrawTarget from = buffers->picture();
  for (const RenderTarget& half : halved) {
    copy_picture(from, half.target());
    from = half.target();
  }
  copy_picture(from, target);
}

Renderer::Renderer(const RenderQuality& quality) : parts_(std::make_unique<Parts>()) {
  parts_->quality = quality;
}

Renderer::~Renderer() = default;

void Renderer::draw(const Scene& scene, const EyeView& view, const DrawTarget& target) {
  Parts& parts = *parts_;
  ++parts.picture;
  parts.make_room(target.size);
  parts.draw_all(frame_of(scene, view, *parts.buffers, parts.quality.supersampling));
  parts.copy_into(target);
  if (parts.picture > kept_pictures) parts.bones.forget_before(parts.picture - kept_pictures);
}

void Renderer::draw(const Scene& scene, const Camera& camera, const DrawTarget& target) {
  const double aspect = static_cast<double>(std::max(target.size.width, 1)) /
                        static_cast<double>(std::max(target.size.height, 1));
  draw(scene, view_of(camera, Viewer{}, Eye::Middle, aspect), target);
}

void Renderer::forget_bones() noexcept { parts_->bones.forget_before(parts_->picture + 1); }

void Renderer::set_quality(const RenderQuality& quality) noexcept { parts_->quality = quality; }

const RenderQuality& Renderer::quality() const noexcept { return parts_->quality; }

const DrawCounts& Renderer::counts() const noexcept { return parts_->counts; }

}  // namespace hallux::ui
