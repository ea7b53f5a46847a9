/// Draws scenes for the widgets: into pictures that cards show, and behind everything, for one eye
/// or two.
///
/// A screen is built while its context is current, so a scene is drawn when it is asked for and
/// nothing of it is kept:
///
///     draw("result.plan", ...)  a texture for a card, at once
///     draw_behind(...)          the eyes' pictures, at once; the window then draws the panels into
///                               each and composes them
///
/// An interface, so that screens are driven without graphics: a test's painter notes what it was
/// asked for.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>

#include "ui/render/renderer.h"
#include "ui/render/scene/scene.h"
#include "ui/render/stereo.h"

namespace hallux::ui {

class ScenePainter {
 public:
  virtual ~ScenePainter() = default;

  /// Draws into the picture of that name, which is made anew where its size changed. Pictures that
  /// nothing was drawn or shown in for a while are let go.
  /// returns its texture, rows upwards
  /// errors  GraphicsError
  virtual std::uint64_t draw(std::string_view name, const Scene& scene, const Camera& camera,
                             PixelSize size) = 0;
  /// The texture of that name as it was drawn last, with nothing to draw; 0 where it went or has
  /// another size.
  virtual std::uint64_t drawn(std::string_view name, PixelSize size) = 0;
  /// The same, with one more sample of the picture at rest.
  /// needs   nothing changed in scene and camera since it was drawn
  virtual std::uint64_t refine(std::string_view name, const Scene& /*scene*/,
                               const Camera& /*camera*/, PixelSize size) {
    return drawn(name, size);
  }
  /// Whether more samples of it would show nothing more.
  virtual bool is_refined(std::string_view /*name*/) const noexcept { return true; }
  /// A picture that a job made, sent once and kept; rows from the top.
  /// needs   pixels is not nullptr
  virtual std::uint64_t show(std::string_view name, std::shared_ptr<const Pixels> pixels) = 0;
  /// Draws the scene behind the widgets of this frame, over the whole window.
  /// errors  GraphicsError
  virtual void draw_behind(const Scene& scene, const Camera& camera,
                           const StereoSetting& setting) = 0;
  /// Whether another frame would show the scene behind better, though nothing changes: it is
  /// coarse, as a processor draws what has just moved, or at rest and not yet refined.
  virtual bool is_unfinished() const noexcept { return false; }

  /// Triangles of the scene that was drawn last.
  virtual std::size_t triangles() const noexcept = 0;
};

/// Where there are no graphics: pictures stay empty.
class NoScenePainter : public ScenePainter {
 public:
  std::uint64_t draw(std::string_view, const Scene&, const Camera&, PixelSize) override {
    return 0;
  }
  std::uint64_t drawn(std::string_view, PixelSize) override { return 0; }
  std::uint64_t show(std::string_view, std::shared_ptr<const Pixels>) override { return 0; }
  void draw_behind(const Scene&, const Camera&, const StereoSetting&) override {}
  std::size_t triangles() const noexcept override { return 0; }
};

/// With the OpenGL context that is current; all methods need it.
class OpenGlScenePainter final : public ScenePainter {
 public:
  OpenGlScenePainter();
  ~OpenGlScenePainter() override;
  OpenGlScenePainter(const OpenGlScenePainter&) = delete;
  OpenGlScenePainter& operator=(const OpenGlScenePainter&) = delete;

  /// How smooth the edges of what is drawn from now on are; live_quality() until then.
  void set_quality(const RenderQuality& quality);

  /// A frame begins that is to fill `window`: nothing lies behind it yet. Where somebody touched
  /// mouse or keys it answers, and refines nothing.
  void begin_frame(const DrawTarget& window, bool is_touched = false);

  std::uint64_t draw(std::string_view name, const Scene& scene, const Camera& camera,
                     PixelSize size) override;
  std::uint64_t drawn(std::string_view name, PixelSize size) override;
  std::uint64_t refine(std::string_view name, const Scene& scene, const Camera& camera,
                       PixelSize size) override;
  bool is_refined(std::string_view name) const noexcept override;
  std::uint64_t show(std::string_view name, std::shared_ptr<const Pixels> pixels) override;
  void draw_behind(const Scene& scene, const Camera& camera, const StereoSetting& setting) override;
  bool is_unfinished() const noexcept override;
  /// Whether the scene behind has fewer rows and columns in this frame, as the camera has just
  /// moved and a processor draws.
  bool is_coarse() const noexcept;
  std::size_t triangles() const noexcept override;

  /// Calls `draw_panels` for each picture that takes panels, bound and ready: each eye's over the
  /// scene behind, with the share of the window's columns that it has; in an anaglyph once, for
  /// both eyes; without a scene once, over the window filled with `page`.
  void finish_frame(const std::array<std::uint8_t, 3>& page,
                    const std::function<void(float columns)>& draw_panels);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hallux::ui
