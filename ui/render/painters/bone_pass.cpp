#include "ui/render/painters/bone_pass.h"

#include <epoxy/gl.h>

#include "ui/render/painters/tool_shadow.h"

namespace hallux::ui {

namespace {

void bind_picture(int unit, unsigned texture) {
  glActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
  glBindTexture(GL_TEXTURE_2D, texture);
}

}  // namespace

BonePass::BonePass(const Frame& frame, const GlVertexArray& no_attributes)
    : size_(frame.target.size) {
  bind_picture(place_unit, frame.place_texture);
  bind_picture(normal_unit, frame.normal_texture);
  glDisable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  glEnable(GL_STENCIL_TEST);
  glBindVertexArray(no_attributes.name());
}

BonePass::~BonePass() {
  glDisable(GL_STENCIL_TEST);
  glDepthMask(GL_TRUE);
  glEnable(GL_DEPTH_TEST);
  set_scissor(all_of(size_));
  glBindVertexArray(0);
  glActiveTexture(GL_TEXTURE0);
}

void BonePass::take_only(int stencil) const { glStencilFunc(GL_EQUAL, stencil, all_bits); }

BlendOver::BlendOver() {
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

BlendOver::~BlendOver() {
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDisable(GL_BLEND);
}

void place_bone(ShaderProgram& program, const Frame& frame, const BoneInScene& bone) {
  program.set("world_from_bone", to_float(matrix_of(bone.world_from_bone)));
  program.set("presence", static_cast<float>(bone.presence));
  const RigidTransform* const world_from_tool = world_from_shading_tool(frame.scene);
  if (world_from_tool == nullptr) return;
  const RigidTransform tool_from_bone = inverse(*world_from_tool) * bone.world_from_bone;
  program.set("tool_from_bone", to_float(matrix_of(tool_from_bone)));
}

}  // namespace hallux::ui
