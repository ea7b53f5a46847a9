#include "ui/render/bone_painter.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "simulator/base/check.h"

namespace hallux::ui {

namespace {

/// Two values of the stencil each.
constexpr std::size_t bones_at_most = 127;

void bind_volume(int unit, const GlTexture& texture) {
  glActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
  glBindTexture(GL_TEXTURE_3D, texture.name());
}

void bind_picture(int unit, unsigned texture) {
  glActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
  glBindTexture(GL_TEXTURE_2D, texture);
}

/// The bone frame in the depth volume's texture coordinates: nodes lie in the middle of texels.
void set_depth(ShaderProgram& program, const DepthVolume& depth) {
  const Vec3 counts(depth.x_count, depth.y_count, depth.z_count);
  const Vec3 scale = 1.0 / (depth.spacing_mm * counts);
  program.set("depth_scale", to_float(scale));
  program.set("depth_shift", to_float(0.5 / counts - scale * depth.origin_in_bone_mm));
}

void set_cortex(ShaderProgram& program, const BoneLook& look) {
  if (!look.cortex) {
    program.set("cortex", Float4(0.0F));
    return;
  }
  program.set("cortex",
              Float4(look.cortex->mid_mm, look.cortex->floor_mm, look.cortex->length_mm, 1.0));
}

void set_map(ShaderProgram& program, const BoneInScene& bone) {
  const std::optional<SignedMap>& map = bone.map;
  if (!map) {
    program.set("map_faces", Float4(0.0F));
    return;
  }
  program.set("map_plane", Float4(to_float(map->normal_in_bone), map->offset_mm));
  program.set("map_faces", Float4(map->kerf, map->side, map->range_mm, 1.0));
  program.set("map_normal_in_world",
              to_float(transform_direction(bone.world_from_bone, map->normal_in_bone)));
  program.set("map_low", map_low);
  program.set("map_middle", map_middle);
  program.set("map_high", map_high);
}

struct LineUniforms {
  std::array<Float4, lines_at_most> plane{}, window{}, style{}, half{};
};

void set_lines(ShaderProgram& program, const Frame& frame) {
  const std::vector<CuttingLine>& lines = frame.scene.lines;
  CHECK(lines.size() <= lines_at_most);
  LineUniforms uniforms;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const RigidTransform& plane = lines[i].world_from_plane;
    const Vec3 normal = plane.rotation * Vec3(0.0, 0.0, 1.0);
    const Vec3 across = plane.rotation * Vec3(0.0, 1.0, 0.0);
    uniforms.plane[i] = Float4(to_float(normal), glm::dot(normal, plane.translation_mm));
    uniforms.window[i] = Float4(to_float(across), glm::dot(across, plane.translation_mm));
    uniforms.style[i] = Float4(colour_of(frame.palette, lines[i].ink),
                               0.5 * lines[i].width_pixels * frame.pixel_scale);
    uniforms.half[i] = Float4(lines[i].half_width_mm, 0.0, 0.0, 0.0);
  }
  program.set("line_plane", uniforms.plane);
  program.set("line_window", uniforms.window);
  program.set("line_style", uniforms.style);
  program.set("line_half", uniforms.half);
}

/// Restricts drawing to the pixels that the mesh can cover: the box around its box's corners.
void bound_to(const Frame& frame, const BoneInScene& bone) {
  Vec3 low(1e9), high(-1e9);
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Vec3 share((corner & 1U) != 0 ? 1.0 : 0.0, (corner & 2U) != 0 ? 1.0 : 0.0,
                     (corner & 4U) != 0 ? 1.0 : 0.0);
    const Vec3 corner_mm = glm::mix(bone.mesh->low_mm, bone.mesh->high_mm, share);
    const Vec3 place =
        place_in_picture(frame.view, transform_point(bone.world_from_bone, corner_mm));
    if (!(std::abs(place.z) <= 1.0)) {  // before the eye or beyond sight: nothing is known
      low = Vec3(0.0);
      high = Vec3(1.0);
      break;
    }
    low = glm::min(low, place);
    high = glm::max(high, place);
  }
  const double width = frame.target.size.width, height = frame.target.size.height;
  const auto pixel = [](double share, double size) {
    return static_cast<int>(std::clamp(std::floor(share * size), 0.0, size));
  };
  const int left = pixel(low.x, width), bottom = pixel(1.0 - high.y, height);
  glScissor(left, bottom, pixel(high.x, width) + 1 - left, pixel(1.0 - low.y, height) + 1 - bottom);
}

/// The saw's shadow on bones.
void set_shadow(ShaderProgram& program, const Frame& frame) {
  if (!frame.scene.saw) {
    program.set("blade_shadow", Float4(0.0F));
    return;
  }
  const SawInScene& saw = *frame.scene.saw;
  const RigidTransform tool_from_world = inverse(saw.world_from_tool);
  const Vec3 key = transform_direction(tool_from_world, Vec3(frame.key_light));
  const double strength = frame.scene.ground == Ground::Dark ? 0.80 : 0.62;
  program.set("key_in_tool", to_float(key));
  program.set("blade_shadow", Float4(saw.blade.depth_mm, 0.5 * saw.blade.width_mm, strength,
                                     -saw.blade.depth_mm - 2.0));
}

}  // namespace

BonePainter::BonePainter(const NoiseTextures& noise)
    : noise_(noise), shape_("bone.vert", "bone.frag"), cut_("ground.vert", "bone_cut.frag") {}

const GlTexture& BonePainter::depth_of(const BoneLook& look, std::uint64_t picture) {
  const auto [at, is_new] = looks_.try_emplace(look.id);
  at->second.picture = picture;
  if (!is_new) return at->second.depth;
  const DepthVolume& depth = look.depth;
  bind_volume(depth_unit, at->second.depth);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage3D(GL_TEXTURE_3D, 0, GL_R16, static_cast<GLsizei>(depth.x_count),
               static_cast<GLsizei>(depth.y_count), static_cast<GLsizei>(depth.z_count), 0, GL_RED,
               GL_UNSIGNED_SHORT, depth.nodes.data());
  glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  for (const GLenum side : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
    glTexParameteri(GL_TEXTURE_3D, side, GL_CLAMP_TO_EDGE);
  }
  return at->second.depth;
}

BoneView& BonePainter::view_of(const BoneInScene& bone, std::uint64_t picture) {
  auto at = bones_.find(bone.mesh->id);
  if (at == bones_.end()) {
    at = bones_.emplace(bone.mesh->id, SeenBone{BoneView(*bone.mesh), picture}).first;
  }
  at->second.picture = picture;
  at->second.view.show(*bone.mesh, bone.patch, bone.patch_revision);
  return at->second.view;
}

void BonePainter::draw_shape(const Frame& frame, const BoneInScene& bone, const BoneView& view,
                             int stencil) {
  const DoubleMatrix4 world_from_bone = matrix_of(bone.world_from_bone);
  shape_.set("world_from_bone", to_float(world_from_bone));
  shape_.set("clip_from_bone", to_float(frame.clip_from_world * world_from_bone));
  // Set in either case: llvmpipe goes on clipping by the plane of the picture before where that was cut open.
  shape_.set("cut_away", bone.cut_away ? Float4(to_float(bone.cut_away->normal_in_bone),
                                                bone.cut_away->offset_mm)
                                       : Float4(0.0F, 0.0F, 0.0F, 1.0F));
  if (bone.cut_away) {
    glEnable(GL_CLIP_DISTANCE0);
    glDisable(GL_CULL_FACE);
  }
  glStencilFunc(GL_ALWAYS, stencil, 0xff);
  view.draw_skin();
  glStencilFunc(GL_ALWAYS, stencil + 1, 0xff);
  view.draw_cut_faces();
  glEnable(GL_CULL_FACE);
  glDisable(GL_CLIP_DISTANCE0);
}

void BonePainter::draw_shapes(const Frame& frame, std::uint64_t picture) {
  CHECK(frame.scene.bones.size() <= bones_at_most);
  triangle_count_ = 0;
  uploaded_bytes_ = 0;
  shape_.use();
  glEnable(GL_STENCIL_TEST);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  int stencil = 1;
  for (const BoneInScene& bone : frame.scene.bones) {
    CHECK(bone.mesh != nullptr && bone.look != nullptr);
    const auto seen = bones_.find(bone.mesh->id);
    const std::uint64_t before = seen == bones_.end() ? 0 : seen->second.view.uploaded_bytes();
    const BoneView& view = view_of(bone, picture);
    uploaded_bytes_ += view.uploaded_bytes() - before;
    triangle_count_ += view.triangle_count();
    depth_of(*bone.look, picture);
    draw_shape(frame, bone, view, stencil);
    stencil += 2;
  }
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  glBindVertexArray(0);
}

ShaderProgram& BonePainter::skin_program(const Frame& frame, const BoneInScene& bone) {
  std::string settings = "#define LINES " + std::to_string(frame.scene.lines.size()) + "\n";
  if (frame.scene.saw) settings += "#define SHADOW\n";
  if (bone.presence < 1.0) settings += "#define FADED\n";
  auto at = skins_.find(settings);
  if (at == skins_.end()) {
    at = skins_.emplace(settings, ShaderProgram("ground.vert", "bone_skin.frag", settings)).first;
  }
  return at->second;
}

void BonePainter::light_skin(const Frame& frame, const BoneInScene& bone) {
  ShaderProgram& program = skin_program(frame, bone);
  begin_light(program, frame);
  set_lines(program, frame);
  program.set("relief", relief_unit);
  program.set("slope_scale", static_cast<float>(noise_.slope_scale()));
  place(program, frame, bone);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void BonePainter::begin_light(ShaderProgram& program, const Frame& frame) {
  program.use();
  set_light(program, frame);
  set_ground(program, frame);
  set_seen_bone(program, frame);
  set_shadow(program, frame);
  program.set("noise", noise_unit);
  program.set("depth_volume", depth_unit);
  program.set("pixel_scale", static_cast<float>(frame.pixel_scale));
}

void BonePainter::place(ShaderProgram& program, const Frame& frame, const BoneInScene& bone) {
  program.use();
  program.set("world_from_bone", to_float(matrix_of(bone.world_from_bone)));
  program.set("presence", static_cast<float>(bone.presence));
  if (!frame.scene.saw) return;
  const RigidTransform tool_from_world = inverse(frame.scene.saw->world_from_tool);
  program.set("tool_from_bone", to_float(matrix_of(tool_from_world * bone.world_from_bone)));
}

void BonePainter::light_cut_faces(const Frame& frame, const BoneInScene& bone) {
  bind_volume(depth_unit, looks_.at(bone.look->id).depth);
  place(cut_, frame, bone);
  set_depth(cut_, bone.look->depth);
  set_cortex(cut_, *bone.look);
  set_map(cut_, bone);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void BonePainter::draw_light(const Frame& frame) {
  begin_light(cut_, frame);
  noise_.bind();
  bind_picture(place_unit, frame.place_texture);
  bind_picture(normal_unit, frame.normal_texture);
  glDisable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  glEnable(GL_STENCIL_TEST);
  glBindVertexArray(no_attributes_.name());
  int stencil = 1;
  for (const BoneInScene& bone : frame.scene.bones) {
    bound_to(frame, bone);
    glStencilFunc(GL_EQUAL, stencil, 0xff);
    light_skin(frame, bone);
    glStencilFunc(GL_EQUAL, stencil + 1, 0xff);
    light_cut_faces(frame, bone);
    stencil += 2;
  }
  glDisable(GL_STENCIL_TEST);
  glDepthMask(GL_TRUE);
  glEnable(GL_DEPTH_TEST);
  glScissor(0, 0, frame.target.size.width, frame.target.size.height);
  glBindVertexArray(0);
  glActiveTexture(GL_TEXTURE0);
}

void BonePainter::forget_before(std::uint64_t picture) {
  std::erase_if(bones_, [&](const auto& seen) { return seen.second.picture < picture; });
  std::erase_if(looks_, [&](const auto& seen) { return seen.second.picture < picture; });
}

}  // namespace hallux::ui
