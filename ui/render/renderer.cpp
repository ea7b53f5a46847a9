#include "ui/render/renderer.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <optional>

#include "ui/render/bone_painter.h"
#include "ui/render/frame.h"
#include "ui/render/headless_context.h"
#include "ui/render/overlay_painter.h"
#include "ui/render/saw_painter.h"

namespace hallux::ui {

namespace {

constexpr std::uint64_t kept_pictures = 300;

/// Drawing begins from a state that is said, not from the one that somebody left.
void begin_drawing(const DrawTarget& target) {
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
  glViewport(target.left, target.bottom, target.size.width, target.size.height);
  glScissor(target.left, target.bottom, target.size.width, target.size.height);
  glEnable(GL_SCISSOR_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_BACK);
  glFrontFace(GL_CCW);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glClear(GL_DEPTH_BUFFER_BIT);
}

void end_drawing() {
  glBindVertexArray(0);
  glUseProgram(0);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
}

}  // namespace

RenderQuality live_quality() {
  return is_software_renderer() ? RenderQuality{} : RenderQuality{.samples = 4};
}

struct Renderer::Parts {
  RenderQuality quality;
  OverlayPainter overlays;
  BonePainter bones;
  SawPainter saw;
  std::optional<SampledTarget> sampled;
  std::optional<RenderTarget> larger;
  std::uint64_t picture = 0;
  DrawCounts counts;

  void draw_all(const Frame& frame);
  void draw_sampled(const Scene& scene, const EyeView& view, const DrawTarget& target);
};

void Renderer::Parts::draw_all(const Frame& frame) {
  begin_drawing(frame.target);
  overlays.draw_ground(frame);
  bones.draw(frame, picture);
  saw.draw(frame);
  overlays.draw_chips(frame);
  saw.draw_ghosts(frame);
  overlays.draw_planes(frame);
  overlays.draw_marks(frame);
  end_drawing();
  counts = {bones.triangle_count() + (frame.scene.saw ? saw.triangle_count() : 0),
            bones.uploaded_bytes()};
}

/// Larger and with samples; then the samples become pixels, then pixels become fewer.
void Renderer::Parts::draw_sampled(const Scene& scene, const EyeView& view,
                                   const DrawTarget& target) {
  const int scale = quality.supersampling, samples = std::max(quality.samples, 1);
  const PixelSize size{std::max(target.size.width, 1) * scale,
                       std::max(target.size.height, 1) * scale};
  if (!sampled || !(sampled->size() == size) || sampled->samples() != samples) {
    sampled.reset();
    sampled.emplace(size, samples);
  }
  draw_all(frame_of(scene, view, sampled->target(), scale));
  if (scale == 1) {
    sampled->copy_into(target);
    return;
  }
  if (!larger || !(larger->size() == size)) {
    larger.reset();
    larger.emplace(size);
  }
  sampled->copy_into(larger->target());
  larger->copy_into(target);
}

Renderer::Renderer(const RenderQuality& quality) : parts_(std::make_unique<Parts>()) {
  parts_->quality = quality;
}

Renderer::~Renderer() = default;

void Renderer::draw(const Scene& scene, const EyeView& view, const DrawTarget& target) {
  Parts& parts = *parts_;
  ++parts.picture;
  if (parts.quality.samples > 0 || parts.quality.supersampling > 1) {
    parts.draw_sampled(scene, view, target);
  } else {
    parts.draw_all(frame_of(scene, view, target, 1.0));
  }
  if (parts.picture > kept_pictures) parts.bones.forget_before(parts.picture - kept_pictures);
}

void Renderer::draw(const Scene& scene, const Camera& camera, const DrawTarget& target) {
  const double aspect = static_cast<double>(std::max(target.size.width, 1)) /
                        static_cast<double>(std::max(target.size.height, 1));
  draw(scene, view_of(camera, Viewer{}, Eye::Middle, aspect), target);
}

void Renderer::forget_bones() noexcept { parts_->bones.forget_before(parts_->picture + 1); }

void Renderer::set_quality(const RenderQuality& quality) noexcept {
  parts_->quality = quality;
  parts_->sampled.reset();
  parts_->larger.reset();
}

const RenderQuality& Renderer::quality() const noexcept { return parts_->quality; }

const DrawCounts& Renderer::counts() const noexcept { return parts_->counts; }

}  // namespace hallux::ui
