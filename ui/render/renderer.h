/// Draws a scene with whatever OpenGL context is current: a window's, one without a window, a
/// test's. Inside this corner only.
#pragma once

#include <cstdint>
#include <memory>

#include "ui/render/gl/render_target.h"
#include "ui/render/scene/camera.h"
#include "ui/render/scene/scene.h"

namespace hallux::ui {

struct RenderQuality {
  /// Pixels drawn along each side of one shown, for smooth edges: 1, 2 or 4.
  int supersampling = 1;
  /// Whether KeptPictures are used: 40 bytes a pixel drawn, for each of them, 44 with smooth edges.
  bool keeps_still = false;
  /// Whether a pass takes the stairs from the edges of pictures in motion.
  bool smooths_edges = false;
};

/// What this machine draws fast enough to be lived with: smooth edges only where a graphics card
/// draws, what stands still is kept only where none does.
/// needs   a current context
RenderQuality live_quality();
/// For pictures that stand still.
inline constexpr RenderQuality still_quality{.supersampling = 4};

/// Of the last picture.
struct DrawCounts {
  /// In the scene.
  std::size_t triangles = 0;
  /// Of what stands still, those that no kept picture had.
  std::size_t redrawn_pixels = 0;
  /// Those, and where a tool's shadow was or is.
  std::size_t relit_pixels = 0;
  /// Of bones.
  std::uint64_t uploaded_bytes = 0;
};

/// What stands still of a picture that is drawn again and again, bones and ground: while nobody
/// turns the view, only what was cut since is drawn anew below what moves, and only where a tool's
/// shadow was or is light is laid anew. One for each eye; empty until a renderer draws with it.
/// thread  the context's
class KeptPicture {
 public:
  KeptPicture();
  ~KeptPicture();
  KeptPicture(KeptPicture&&) noexcept;
  KeptPicture& operator=(KeptPicture&&) noexcept;

 private:
  friend class Renderer;
  struct Still;
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

class Renderer {
 public:
  /// errors  GraphicsError where a shader is refused
  explicit Renderer(const RenderQuality& quality = live_quality());
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Draws one eye's picture over all of the target. Bones are sent to the card when first seen,
  /// and let go when they were not seen for 300 pictures. What it is drawn in (of a still one
  /// 800 bytes for each pixel) goes when 10 pictures were drawn otherwise.
  /// ensures the target's framebuffer stays bound; depth test, culling, blending and scissor are
  ///         off afterwards
  /// errors  GraphicsError where there is no room for the picture
  /// thread  the context's
  void draw(const Scene& scene, const EyeView& view, const DrawTarget& target);
  /// The same picture, with what `kept` still has of the one before. `detail`: the target's rows
  /// over those it will be shown with; lines and marks that are some pixels wide become that much
  /// narrower.
  void draw(const Scene& scene, const EyeView& view, const DrawTarget& target, KeptPicture& kept,
            double detail = 1.0);
  /// The same as seen by one who looks at the target from the middle.
  void draw(const Scene& scene, const Camera& camera, const DrawTarget& target);

  /// One sample of a picture at rest, its edges as they are. It takes the room of `kept`, so that
  /// there are never buffers for both: the next picture in motion is drawn whole.
  void draw_sample(const Scene& scene, const EyeView& view, const DrawTarget& target,
                   KeptPicture& kept);
  /// The same in the room of what passes.
  void draw_sample(const Scene& scene, const EyeView& view, const DrawTarget& target);

  /// Lets go of what pictures of which nothing is kept are drawn in.
  void forget_passing() noexcept;
  /// Lets go of everything that belongs to bones, and of what pictures of which nothing is kept are
  /// drawn in, at once.
  void forget_bones() noexcept;
  void set_quality(const RenderQuality& quality) noexcept;
  const RenderQuality& quality() const noexcept;
  const DrawCounts& counts() const noexcept;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hallux::ui
