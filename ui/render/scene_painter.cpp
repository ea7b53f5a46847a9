// Scenes for the widgets with OpenGL. A named picture has a target of its own, which lives as long
// as the name is asked for; what nobody asked for during five seconds of frames goes, for its
// memory. The picture behind everything goes through the stage of two eyes, and the panels are
// drawn into what comes out of it.
#include "ui/render/scene_painter.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "simulator/base/check.h"

namespace hallux::ui {

namespace {

// About five seconds at full rate: a screen that is gone needs its pictures and bones no more.
constexpr long frames_kept = 300;

struct ShownPixels {
  GlTexture texture;
  std::shared_ptr<const Pixels> sent;
  long last_frame = 0;
};

struct DrawnScene {
  RenderTarget target;
  long last_frame = 0;
};

void send(const GlTexture& texture, const Pixels& pixels) {
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, pixels.size.width, pixels.size.height, 0, GL_RGBA,
               GL_UNSIGNED_BYTE, pixels.rgba.data());
  glBindTexture(GL_TEXTURE_2D, 0);
}

void fill(const DrawTarget& target, const std::array<std::uint8_t, 3>& colour) {
  const auto share = [](std::uint8_t value) { return static_cast<float>(value) / 255.0F; };
  glViewport(target.left, target.bottom, target.size.width, target.size.height);
  glDisable(GL_SCISSOR_TEST);
  glClearColor(share(colour[0]), share(colour[1]), share(colour[2]), 1.0F);
  glClear(GL_COLOR_BUFFER_BIT);
}

}  // namespace

struct OpenGlScenePainter::Parts {
  Renderer renderer;
  std::optional<StereoStage> stage;
  std::map<std::string, DrawnScene, std::less<>> drawn;
  std::map<std::string, ShownPixels, std::less<>> shown;
  DrawTarget window;
  bool has_scene_behind = false;
  std::optional<Camera> camera_behind;  ///< of the frame before, if there was one
  long frame = 0, last_scene_frame = 0;
};

OpenGlScenePainter::OpenGlScenePainter() : parts_(std::make_unique<Parts>()) {}
OpenGlScenePainter::~OpenGlScenePainter() = default;

void OpenGlScenePainter::set_quality(const RenderQuality& quality) {
  parts_->renderer.set_quality(quality);
}

void OpenGlScenePainter::begin_frame(const DrawTarget& window) {
  Parts& parts = *parts_;
  parts.window = window;
  if (!std::exchange(parts.has_scene_behind, false)) parts.camera_behind.reset();
  const long oldest = ++parts.frame - frames_kept;
  std::erase_if(parts.drawn, [&](const auto& entry) { return entry.second.last_frame < oldest; });
  std::erase_if(parts.shown, [&](const auto& entry) { return entry.second.last_frame < oldest; });
  if (parts.last_scene_frame == oldest) parts.renderer.forget_bones();
}

std::uint64_t OpenGlScenePainter::draw(std::string_view name, const Scene& scene,
                                       const Camera& camera, PixelSize size) {
  Parts& parts = *parts_;
  const PixelSize wanted = at_least_one(size);
  auto found = parts.drawn.find(name);
  if (found != parts.drawn.end() && found->second.target.size() != wanted) {
    parts.drawn.erase(found);
    found = parts.drawn.end();
  }
  if (found == parts.drawn.end())
    found = parts.drawn.emplace(std::string(name), DrawnScene{RenderTarget(wanted)}).first;
  parts.renderer.draw(scene, camera, found->second.target.target());
  found->second.last_frame = parts.last_scene_frame = parts.frame;
  return found->second.target.texture();
}

std::uint64_t OpenGlScenePainter::drawn(std::string_view name, PixelSize size) {
  const auto found = parts_->drawn.find(name);
  if (found == parts_->drawn.end() || found->second.target.size() != at_least_one(size)) return 0;
  found->second.last_frame = parts_->frame;
  return found->second.target.texture();
}

std::uint64_t OpenGlScenePainter::show(std::string_view name,
                                       std::shared_ptr<const Pixels> pixels) {
  CHECK(pixels != nullptr);
  ShownPixels& shown = parts_->shown[std::string(name)];
  if (shown.sent != pixels) send(shown.texture, *pixels);
  shown.sent = std::move(pixels);
  shown.last_frame = parts_->frame;
  return shown.texture.name();
}

void OpenGlScenePainter::draw_behind(const Scene& scene, const Camera& camera,
                                     const StereoSetting& setting) {
  Parts& parts = *parts_;
  if (!parts.stage) parts.stage.emplace();
  StereoSetting live = setting;
  const std::optional<Camera> before = std::exchange(parts.camera_behind, camera);
  const bool is_moving = before && *before != camera;
  live.eye_columns = std::min(setting.eye_columns, live_eye_columns());
  parts.stage->begin(live, parts.window, is_moving ? live_moving_detail(setting.mode) : 1.0);
  for (const Eye eye : {Eye::Left, Eye::Right}) {
    if (eye == Eye::Right && parts.stage->eye_count() < 2) continue;
    parts.renderer.draw(scene, parts.stage->view(eye, camera), parts.stage->eye(eye),
                        parts.stage->kept(eye), parts.stage->detail());
  }
  parts.has_scene_behind = true;
  parts.last_scene_frame = parts.frame;
}

bool OpenGlScenePainter::is_coarse() const noexcept {
  return parts_->has_scene_behind && parts_->stage->is_coarse();
}

std::size_t OpenGlScenePainter::triangles() const noexcept {
  return parts_->renderer.counts().triangles;
}

void OpenGlScenePainter::finish_frame(const std::array<std::uint8_t, 3>& page,
                                      const std::function<void(float columns)>& draw_panels) {
  Parts& parts = *parts_;
  if (!parts.has_scene_behind) {
    glBindFramebuffer(GL_FRAMEBUFFER, parts.window.framebuffer);
    fill(parts.window, page);
    draw_panels(1.0F);
    return;
  }
  for (const DrawTarget& target : parts.stage->pictures_for_panels()) {
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    draw_panels(static_cast<float>(target.size.width) /
                static_cast<float>(parts.window.size.width));
  }
  parts.stage->compose();
}

}  // namespace hallux::ui
