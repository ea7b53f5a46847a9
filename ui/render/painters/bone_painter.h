/// Draws the bones of a scene.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ui/render/painters/bone_view.h"
#include "ui/render/painters/frame.h"
#include "ui/render/painters/noise_textures.h"
#include "ui/render/painters/pixel_box.h"

namespace hallux::ui {

class BonePainter {
 public:
  /// Borrows the noise.
  explicit BonePainter(const NoiseTextures& noise);

  /// Sends what is new of bones and looks to the card.
  void show(const Scene& scene, std::uint64_t picture);
  /// The patch of each bone of the scene shown last.
  std::vector<std::uint64_t> revisions(const Scene& scene) const;
  /// Around what looks different of each bone since those revisions; nothing where that is not
  /// known any more.
  /// shape   revisions one for each bone of the scene shown last
  std::optional<std::vector<Box>> changed_since(const Scene& scene,
                                                std::span<const std::uint64_t> revisions) const;
  /// Writes which bone is where in that part, with depth; into the stencil what is to be lit how.
  /// needs   the scene was shown last; the shapes' framebuffer is bound and cleared there
  void draw_shapes(const Frame& frame, const PixelBox& part);
  /// Lays light on them in those boxes, once a pixel.
  /// needs   the shapes of all the picture are drawn; a framebuffer with their stencil is bound
  void draw_light(const Frame& frame, std::span<const PixelBox> boxes);
  /// Draws an outline around each piece that came free, before what is seen there.
  /// needs   the scene was shown last
  void draw_outlines(const Frame& frame);
  /// Lets go of what was not drawn since.
  void forget_before(std::uint64_t picture);

  std::size_t triangle_count() const noexcept { return triangle_count_; }
  std::uint64_t uploaded_bytes() const noexcept { return uploaded_bytes_; }

 private:
  struct SeenBone {
    BoneView view;
    std::uint64_t picture = 0;
  };
  struct SeenLook {
    GlTexture depth;
    std::uint64_t picture = 0;
  };

  BoneView& view_of(const BoneMesh& mesh, std::uint64_t picture);
  void send_depth(const BoneLook& look, std::uint64_t picture);
  void draw_shape(const Frame& frame, std::size_t number, const PixelBox& part);
  ShaderProgram& skin_program(const Frame& frame, const BoneInScene& bone);
  void begin_light(ShaderProgram& program, const Frame& frame);
  void light_skin(const Frame& frame, const BoneInScene& bone, std::span<const PixelBox> boxes);
  void light_cut_faces(const Frame& frame, const BoneInScene& bone,
                       std::span<const PixelBox> boxes);

  const NoiseTextures& noise_;
  ShaderProgram shape_, cut_, outline_;
  /// By settings, made when first needed.
  std::map<std::string, ShaderProgram> skins_;
  GlVertexArray no_attributes_;
  std::map<std::uint64_t, SeenBone> bones_;
  std::map<std::uint64_t, SeenLook> looks_;
  std::size_t triangle_count_ = 0;
  std::uint64_t uploaded_bytes_ = 0;
};

}  // namespace hallux::ui
