#include "ui/render/painters/noise_textures.h"

#include <epoxy/gl.h>

#include "ui/render/painters/frame.h"
#include "ui/render/painters/noise_volume.h"

namespace hallux::ui {

namespace {

void fill(const GlTexture& texture, const NoiseVolume& noise) {
  const auto side = static_cast<GLsizei>(noise.side);
  glBindTexture(GL_TEXTURE_3D, texture.name());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, side, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               noise.rgba.data());
  glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  for (const GLenum side_of : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
    glTexParameteri(GL_TEXTURE_3D, side_of, GL_REPEAT);
  }
  glGenerateMipmap(GL_TEXTURE_3D);
}

}  // namespace

NoiseTextures::NoiseTextures() {
  const NoiseVolume noise = make_noise(64);
  const ReliefVolume relief = make_relief(noise);
  slope_scale_ = relief.slope_scale;
  glActiveTexture(GL_TEXTURE0);
  fill(noise_, noise);
  fill(relief_, relief.volume);
}

void NoiseTextures::bind() const {
  glActiveTexture(GL_TEXTURE0 + relief_unit);
  glBindTexture(GL_TEXTURE_3D, relief_.name());
  glActiveTexture(GL_TEXTURE0 + noise_unit);
  glBindTexture(GL_TEXTURE_3D, noise_.name());
}

}  // namespace hallux::ui
