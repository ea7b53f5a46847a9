/// Draws a scene with whatever OpenGL context is current: a window's, one without a window, a test's.
#pragma once

#include <cstdint>
#include <memory>

#include "ui/render/camera.h"
#include "ui/render/render_target.h"
#include "ui/render/scene.h"

namespace hallux::ui {

struct RenderQuality {
  int supersampling =
      1;  ///< pixels drawn along each side of one shown, for smooth edges: 1, 2 or 4
};

/// What this machine draws fast enough to be lived with: 2 only where a graphics card draws.
/// needs   a current context
RenderQuality live_quality();
/// For pictures that stand still.
inline constexpr RenderQuality still_quality{.supersampling = 4};

/// Of the last picture.
struct DrawCounts {
  std::size_t triangles = 0;
  std::uint64_t uploaded_bytes = 0;  ///< of bones
};

class Renderer {
 public:
  /// errors  GraphicsError where a shader is refused
  explicit Renderer(const RenderQuality& quality = live_quality());
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Draws one eye's picture over all of the target. Bones are sent to the card when first seen, and let go when they were
  /// not seen for 300 pictures.
  /// ensures the target's framebuffer stays bound; depth test, culling, blending and scissor are off afterwards
  /// errors  GraphicsError where there is no room for the picture
  /// thread  the context's
  void draw(const Scene& scene, const EyeView& view, const DrawTarget& target);
  /// The same as seen by one who looks at the target from the middle.
  void draw(const Scene& scene, const Camera& camera, const DrawTarget& target);

  /// Lets go of everything that belongs to bones, at once.
  void forget_bones() noexcept;
  void set_quality(const RenderQuality& quality) noexcept;
  const RenderQuality& quality() const noexcept;
  const DrawCounts& counts() const noexcept;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hallux::ui
