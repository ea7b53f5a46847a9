// Two eyes into one picture. Side by side halves the width; an anaglyph mixes both pictures by
// fixed matrices in one pass. On a processor the eyes are drawn with fewer pixels, while something
// moves with fewer still, and enlarged here: panels and text never are.
#include "ui/render/stereo.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <string>

#include "simulator/base/check.h"
#include "ui/render/gl/headless_context.h"

namespace hallux::ui {

namespace {

void bind_picture(int unit, unsigned texture) {
  glActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
  glBindTexture(GL_TEXTURE_2D, texture);
}

void resize_to(std::optional<RenderTarget>& target, PixelSize size) {
  if (target && target->size() == size) return;
  target.reset();
  target.emplace(size);
}

int scaled(int side, double share) { return std::max(static_cast<int>(side * share), 1); }

/// As constants: llvmpipe takes a quarter longer where they are uniforms.
std::string written(const std::string& name, const Matrix4& matrix) {
  std::string numbers;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      numbers += (numbers.empty() ? "" : ", ") + std::to_string(matrix[column][row]);
    }
  }
  return "const mat3 " + name + " = mat3(" + numbers + ");\n";
}

std::string written_matrices() {
  const AnaglyphMatrices matrices = anaglyph_matrices();
  return written("left_to_shown", matrices.shown_from_left) +
         written("right_to_shown", matrices.shown_from_right);
}

void make_transparent(const RenderTarget& target) {
  const BoundFramebuffer bound(target.target().framebuffer);
  glDisable(GL_SCISSOR_TEST);
  glClearColor(0.0F, 0.0F, 0.0F, 0.0F);
  glClear(GL_COLOR_BUFFER_BIT);
}

}  // namespace

AnaglyphMatrices anaglyph_matrices() noexcept {
  AnaglyphMatrices matrices;
  // Columns: what red, green and blue of the eye's picture give.
  matrices.shown_from_left[0] = Float4(0.437F, -0.062F, -0.048F, 0.0F);
  matrices.shown_from_left[1] = Float4(0.449F, -0.062F, -0.050F, 0.0F);
  matrices.shown_from_left[2] = Float4(0.164F, -0.024F, -0.017F, 0.0F);
  matrices.shown_from_right[0] = Float4(-0.011F, 0.377F, -0.026F, 0.0F);
  matrices.shown_from_right[1] = Float4(-0.032F, 0.761F, -0.093F, 0.0F);
  matrices.shown_from_right[2] = Float4(-0.007F, 0.009F, 1.234F, 0.0F);
  return matrices;
}

double live_eye_columns() { return is_software_renderer() ? 0.5 : 1.0; }

double live_moving_detail(StereoMode mode) {
  if (!is_software_renderer()) return 1.0;
  return mode == StereoMode::Mono ? 1.0 / 2.0 : 1.0 / 3.0;
}

StereoStage::StereoStage() : anaglyph_("ground.vert", "anaglyph.frag", written_matrices()) {}

void StereoStage::begin(const StereoSetting& setting, PixelSize window, double detail) {
  setting_ = setting;
  detail_ = detail;
  window_ = at_least_one(window);
  resize(left_);
  if (setting.mode != StereoMode::Mono) {
    resize(right_);
  } else if (right_.whole) {
    right_ = {};
  }
  if (setting.mode == StereoMode::Anaglyph) {
    resize_to(panels_, window_);
    make_transparent(*panels_);
  } else {
    panels_.reset();
  }
}

void StereoStage::resize(EyePicture& picture) const {
  PixelSize whole = window_;
  if (setting_.mode == StereoMode::SideBySide) whole.width = std::max(window_.width / 2, 1);
  if (setting_.mode == StereoMode::Anaglyph) {
    whole.width = scaled(window_.width, setting_.eye_columns);
  }
  resize_to(picture.whole, whole);
  if (!is_coarse()) return;
  resize_to(picture.coarse, {std::min(whole.width, scaled(window_.width, detail_)),
                             scaled(window_.height, detail_)});
}

const StereoStage::EyePicture& StereoStage::picture_of(Eye eye) const {
  return eye == Eye::Right ? right_ : left_;
}

const RenderTarget& StereoStage::whole(Eye eye) const {
  const std::optional<RenderTarget>& target = picture_of(eye).whole;
  CHECK(target.has_value());
  return *target;
}

const RenderTarget& StereoStage::eye(Eye eye) const {
  if (!is_coarse()) return whole(eye);
  const std::optional<RenderTarget>& target = picture_of(eye).coarse;
  CHECK(target.has_value());
  return *target;
}

KeptPicture& StereoStage::kept(Eye eye) noexcept {
  EyePicture& picture = eye == Eye::Right ? right_ : left_;
  return is_coarse() ? picture.kept_coarse : picture.kept_whole;
}

RefinedPicture& StereoStage::refined(Eye eye) noexcept {
  return (eye == Eye::Right ? right_ : left_).refined;
}

std::vector<DrawTarget> StereoStage::pictures_for_panels(const DrawTarget& window) const {
  if (setting_.mode == StereoMode::Mono) {
    copy_picture(eye(Eye::Left).target(), window);
    return {window};
  }
  if (panels_) return {panels_->target()};
  std::vector<DrawTarget> pictures;
  for (const Eye eye : {Eye::Left, Eye::Right}) {
    if (is_coarse()) copy_picture(this->eye(eye).target(), whole(eye).target());
    pictures.push_back(whole(eye).target());
  }
  return pictures;
}

EyeView StereoStage::view(Eye eye, const Camera& camera) const noexcept {
  const double aspect = static_cast<double>(window_.width) / window_.height;
  if (setting_.mode == StereoMode::Mono) eye = Eye::Middle;
  return view_of(camera, setting_.viewer, eye, aspect);
}

void StereoStage::compose(const DrawTarget& window) {
  switch (setting_.mode) {
    case StereoMode::Mono:
      return;
    case StereoMode::SideBySide:
      return copy_halves(window);
    case StereoMode::Anaglyph:
      return compose_anaglyph(window);
  }
}

void StereoStage::copy_halves(const DrawTarget& window) const {
  DrawTarget half = window;
  half.size = whole(Eye::Left).size();
  copy_picture(whole(setting_.is_swapped ? Eye::Right : Eye::Left).target(), half);
  half.left += window.size.width - half.size.width;
  copy_picture(whole(setting_.is_swapped ? Eye::Left : Eye::Right).target(), half);
}

void StereoStage::compose_anaglyph(const DrawTarget& window) {
  glBindFramebuffer(GL_FRAMEBUFFER, window.framebuffer);
  glViewport(window.left, window.bottom, window.size.width, window.size.height);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
  anaglyph_.use();
  bind_picture(2, panels_->texture());
  bind_picture(1, eye(setting_.is_swapped ? Eye::Left : Eye::Right).texture());
  bind_picture(0, eye(setting_.is_swapped ? Eye::Right : Eye::Left).texture());
  anaglyph_.set("left_eye", 0);
  anaglyph_.set("right_eye", 1);
  anaglyph_.set("panels", 2);
  anaglyph_.set("picture",
                Float4(window.left, window.bottom, 1.0F / static_cast<float>(window.size.width),
                       1.0F / static_cast<float>(window.size.height)));
  glBindVertexArray(no_attributes_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
  glUseProgram(0);
}

void StereoStage::draw(Renderer& renderer, const Scene& scene, const Camera& camera,
                       const StereoSetting& setting, const DrawTarget& window) {
  begin(setting, window.size);
  for (const Eye eye : {Eye::Left, Eye::Right}) {
    if (eye == Eye::Right && eye_count() == 1) break;
    renderer.draw(scene, view(eye, camera), this->eye(eye).target(), kept(eye));
  }
  pictures_for_panels(window);
  compose(window);
}

}  // namespace hallux::ui
