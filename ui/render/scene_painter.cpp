// Scenes for the widgets with OpenGL. A named picture has a target of its own, which lives as long
// as the name is asked for; what nobody asked for during five seconds of frames goes, for its
// memory. The picture behind everything goes through the stage of two eyes, and the panels are
// drawn into what comes out of it.
//
// What rests is refined: samples that differ by less than a pixel are laid over each other, one a
// frame, until there are enough of them; then nothing is drawn any more. Whether the scene behind
// rests is seen by comparing it with the last one, so that whatever changes ends it in that frame.
#include "ui/render/scene_painter.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "simulator/base/check.h"
#include "ui/render/scene/remembered_scene.h"

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
  explicit DrawnScene(PixelSize size) : target(size) {}

  RenderTarget target;
  RefinedPicture refined;
  Rest rest;
  long last_frame = 0;
};

/// What was asked for behind the widgets: where that is the same again, it rests.
struct AskedBehind {
  RememberedScene scene;
  Camera camera;
  StereoSetting setting;
  PixelSize window;

  friend bool operator==(const AskedBehind&, const AskedBehind&) = default;
};

/// The view of sample `number` of a picture of this size. What one picture has of samples lies in
/// its pixels already: the places are those within one of them.
EyeView sample_view(const EyeView& view, int number, PixelSize size, const RenderQuality& quality) {
  const Vec2 drawn = static_cast<double>(quality.supersampling) * Vec2(size.width, size.height);
  return shifted(view, sample_place(number) / drawn);
}

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
  std::optional<AskedBehind> behind;  ///< in the frame before, if there was one
  Rest rest_behind;
  SampleMixer mixer;
  bool is_touched = false;
  long frame = 0, last_scene_frame = 0, last_behind_frame = 0;

  std::vector<Eye> eyes() const;
  void draw_eyes(const Scene& scene, const Camera& camera);
  void draw_sample(const Scene& scene, const Camera& camera);
  void draw_behind_at(Drawing drawing, const Scene& scene, const Camera& camera);
};

std::vector<Eye> OpenGlScenePainter::Parts::eyes() const {
  if (stage->eye_count() < 2) return {Eye::Left};
  return {Eye::Left, Eye::Right};
}

/// As while it moves.
void OpenGlScenePainter::Parts::draw_eyes(const Scene& scene, const Camera& camera) {
  for (const Eye eye : eyes()) {
    renderer.draw(scene, stage->view(eye, camera), stage->eye(eye).target(), stage->kept(eye),
                  stage->detail());
  }
}

void OpenGlScenePainter::Parts::draw_sample(const Scene& scene, const Camera& camera) {
  for (const Eye eye : eyes()) {
    const RenderTarget& target = stage->eye(eye);
    const EyeView view = sample_view(stage->view(eye, camera), rest_behind.samples() - 1,
                                     target.size(), renderer.quality());
    renderer.draw_sample(scene, view, target.target(), stage->kept(eye));
    stage->refined(eye).add(mixer, target);
  }
}

void OpenGlScenePainter::Parts::draw_behind_at(Drawing drawing, const Scene& scene,
                                               const Camera& camera) {
  if (drawing == Drawing::Moving || drawing == Drawing::First) draw_eyes(scene, camera);
  if (drawing == Drawing::Sample) draw_sample(scene, camera);
  for (const Eye eye : eyes()) {
    RefinedPicture& refined = stage->refined(eye);
    if (drawing == Drawing::Moving) refined.let_go();
    if (drawing == Drawing::First) refined.begin(mixer, stage->eye(eye));
    if (drawing == Drawing::Sample || drawing == Drawing::Kept)
      refined.show(stage->eye(eye).target());
  }
}

OpenGlScenePainter::OpenGlScenePainter() : parts_(std::make_unique<Parts>()) {}
OpenGlScenePainter::~OpenGlScenePainter() = default;

void OpenGlScenePainter::set_quality(const RenderQuality& quality) {
  parts_->renderer.set_quality(quality);
  parts_->behind.reset();
}

void OpenGlScenePainter::begin_frame(const DrawTarget& window, bool is_touched) {
  Parts& parts = *parts_;
  parts.window = window;
  parts.is_touched = is_touched;
  if (!std::exchange(parts.has_scene_behind, false)) parts.behind.reset();
  const long oldest = ++parts.frame - frames_kept;
  std::erase_if(parts.drawn, [&](const auto& entry) { return entry.second.last_frame < oldest; });
  std::erase_if(parts.shown, [&](const auto& entry) { return entry.second.last_frame < oldest; });
  if (parts.last_behind_frame == oldest) parts.stage.reset();
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
    found = parts.drawn.emplace(std::string(name), DrawnScene(wanted)).first;
  DrawnScene& drawn = found->second;
  parts.renderer.draw(scene, camera, drawn.target.target());
  drawn.refined.let_go();
  drawn.rest = Rest(live_rest(parts.renderer.quality()));
  drawn.last_frame = parts.last_scene_frame = parts.frame;
  return drawn.target.texture();
}

std::uint64_t OpenGlScenePainter::refine(std::string_view name, const Scene& scene,
                                         const Camera& camera, PixelSize size) {
  Parts& parts = *parts_;
  const std::uint64_t texture = drawn(name, size);
  if (texture == 0) return 0;
  DrawnScene& drawn = parts.drawn.find(name)->second;
  const PixelSize pixels = drawn.target.size();
  const double aspect = static_cast<double>(pixels.width) / pixels.height;
  switch (drawn.rest.next(true, parts.is_touched)) {
    case Drawing::First:
      drawn.refined.begin(parts.mixer, drawn.target);
      break;
    case Drawing::Sample:
      parts.renderer.draw_sample(
          scene,
          sample_view(view_of(camera, Viewer{}, Eye::Middle, aspect), drawn.rest.samples() - 1,
                      pixels, parts.renderer.quality()),
          drawn.target.target());
      drawn.refined.add(parts.mixer, drawn.target);
      drawn.refined.show(drawn.target.target());
      parts.last_scene_frame = parts.frame;
      if (drawn.rest.is_finished()) {
        drawn.refined.let_go();
        parts.renderer.forget_passing();
      }
      break;
    case Drawing::Moving:
    case Drawing::Kept:
      break;
  }
  return texture;
}

bool OpenGlScenePainter::is_refined(std::string_view name) const noexcept {
  const auto found = parts_->drawn.find(name);
  return found == parts_->drawn.end() || found->second.rest.is_finished();
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
  AskedBehind now{RememberedScene(scene), camera, setting, parts.window.size};
  now.setting.eye_columns = std::min(setting.eye_columns, live_eye_columns());
  const bool is_moving = parts.behind && parts.behind->camera != camera;
  const bool is_same = parts.behind == now;
  if (!is_same) parts.rest_behind = Rest(live_rest(parts.renderer.quality()));
  parts.behind = std::move(now);
  parts.stage->begin(parts.behind->setting, parts.window.size,
                     is_moving ? live_moving_detail(setting.mode) : 1.0);
  parts.draw_behind_at(parts.rest_behind.next(is_same, parts.is_touched), scene, camera);
  parts.has_scene_behind = true;
  parts.last_behind_frame = parts.last_scene_frame = parts.frame;
}

bool OpenGlScenePainter::is_coarse() const noexcept {
  return parts_->has_scene_behind && parts_->stage->is_coarse();
}

bool OpenGlScenePainter::is_unfinished() const noexcept {
  return parts_->has_scene_behind && (is_coarse() || !parts_->rest_behind.is_finished());
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
  for (const DrawTarget& target : parts.stage->pictures_for_panels(parts.window)) {
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    draw_panels(static_cast<float>(target.size.width) /
                static_cast<float>(parts.window.size.width));
  }
  parts.stage->compose(parts.window);
}

}  // namespace hallux::ui
