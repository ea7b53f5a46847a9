/// A pass over what is seen of bones, once a pixel: which bone is where stands in the stencil, at
/// which point of it in the shapes' textures. Inside this corner only.
#pragma once

#include <cstddef>

#include "ui/render/gl/gl_objects.h"
#include "ui/render/painters/frame.h"

namespace hallux::ui {

/// Two values of the stencil a bone.
inline constexpr std::size_t bones_at_most = 127;
inline constexpr unsigned all_bits = 0xff;

/// What the stencil holds where the skin, or the cut faces, of a scene's bone are seen; 0 is none.
constexpr int skin_of(std::size_t bone) noexcept { return static_cast<int>(2 * bone + 1); }
constexpr int cut_faces_of(std::size_t bone) noexcept { return skin_of(bone) + 1; }

/// While it lives: shapes are bound, depth is neither asked nor written, the stencil is asked.
/// needs   the shapes of all the picture are drawn; a framebuffer with their stencil is bound
class BonePass {
 public:
  BonePass(const Frame& frame, const GlVertexArray& no_attributes);
  ~BonePass();
  BonePass(const BonePass&) = delete;
  BonePass& operator=(const BonePass&) = delete;

  /// From now on only pixels of which the stencil says this.
  void take_only(int stencil) const;

 private:
  PixelSize size_;
};

/// Colours that are already times their alpha are laid over the picture while it lives.
class BlendOver {
 public:
  BlendOver();
  ~BlendOver();
  BlendOver(const BlendOver&) = delete;
  BlendOver& operator=(const BlendOver&) = delete;
};

/// Sets the uniforms of a bone that such a pass needs: where it lies, how present it is.
/// needs   the program is the current one
void place_bone(ShaderProgram& program, const Frame& frame, const BoneInScene& bone);

}  // namespace hallux::ui
