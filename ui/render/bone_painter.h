/// Draws the bones of a scene; inside this room only.
#pragma once

#include <cstdint>
#include <map>

#include "ui/render/bone_view.h"
#include "ui/render/frame.h"

namespace hallux::ui {

class BonePainter {
 public:
  BonePainter();

  /// Draws them all; `noise` is the bound texture's unit.
  void draw(const Frame& frame, std::uint64_t picture);
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

  BoneView& view_of(const BoneInScene& bone, std::uint64_t picture);
  const GlTexture& depth_of(const BoneLook& look, std::uint64_t picture);
  void begin(ShaderProgram& program, const Frame& frame);
  void place(ShaderProgram& program, const Frame& frame, const BoneInScene& bone);
  void draw_skin(const Frame& frame, const BoneInScene& bone, const BoneView& view);
  void draw_cut_faces(const Frame& frame, const BoneInScene& bone, const BoneView& view,
                      const GlTexture& depth);

  ShaderProgram skin_, cut_;
  GlTexture noise_;
  std::map<std::uint64_t, SeenBone> bones_;
  std::map<std::uint64_t, SeenLook> looks_;
  std::size_t triangle_count_ = 0;
  std::uint64_t uploaded_bytes_ = 0;
};

/// A block of noise as a texture that repeats; made once and shared by the painters.
/// needs   a current context
GlTexture make_noise_texture();

}  // namespace hallux::ui
