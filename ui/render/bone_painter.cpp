#include "ui/render/bone_painter.h"

#include <epoxy/gl.h>

#include <array>

#include "simulator/base/check.h"
#include "ui/render/noise_volume.h"

namespace hallux::ui {

namespace {

constexpr int noise_unit = 0, depth_unit = 1;

void bind_volume(int unit, const GlTexture& texture) {
  glActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
  glBindTexture(GL_TEXTURE_3D, texture.name());
}

void set_filter(GLint minified, GLint wrap) {
  glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, minified);
  glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  for (const GLenum side : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
    glTexParameteri(GL_TEXTURE_3D, side, wrap);
  }
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

void set_map(ShaderProgram& program, const std::optional<SignedMap>& map) {
  if (!map) {
    program.set("map_faces", Float4(0.0F));
    return;
  }
  program.set("map_plane", Float4(to_float(map->normal_in_bone), map->offset_mm));
  program.set("map_faces", Float4(map->kerf, map->side, map->range_mm, 1.0));
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
  program.set("line_count", static_cast<int>(lines.size()));
  program.set("line_plane", uniforms.plane);
  program.set("line_window", uniforms.window);
  program.set("line_style", uniforms.style);
  program.set("line_half", uniforms.half);
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

GlTexture make_noise_texture() {
  const NoiseVolume noise = make_noise(64);
  const auto side = static_cast<GLsizei>(noise.side);
  GlTexture texture;
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_3D, texture.name());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, side, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               noise.rgba.data());
  set_filter(GL_LINEAR_MIPMAP_NEAREST, GL_REPEAT);
  glGenerateMipmap(GL_TEXTURE_3D);
  return texture;
}

BonePainter::BonePainter()
    : skin_("bone.vert", "bone_skin.frag"),
      cut_("bone.vert", "bone_cut.frag"),
      noise_(make_noise_texture()) {}

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
  set_filter(GL_LINEAR, GL_CLAMP_TO_EDGE);
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

void BonePainter::begin(ShaderProgram& program, const Frame& frame) {
  program.use();
  set_light(program, frame);
  set_ground(program, frame);
  set_shadow(program, frame);
  program.set("noise", noise_unit);
  program.set("depth_volume", depth_unit);
}

void BonePainter::place(ShaderProgram& program, const Frame& frame, const BoneInScene& bone) {
  const DoubleMatrix4 world_from_bone = matrix_of(bone.world_from_bone);
  program.set("world_from_bone", to_float(world_from_bone));
  program.set("clip_from_bone", to_float(frame.clip_from_world * world_from_bone));
  program.set("presence", static_cast<float>(bone.presence));
  if (bone.cut_away) {
    program.set("cut_away",
                Float4(to_float(bone.cut_away->normal_in_bone), bone.cut_away->offset_mm));
  }
  if (frame.scene.saw) {
    const RigidTransform tool_from_world = inverse(frame.scene.saw->world_from_tool);
    program.set("tool_from_bone", to_float(matrix_of(tool_from_world * bone.world_from_bone)));
  }
}

void BonePainter::draw_skin(const Frame& frame, const BoneInScene& bone, const BoneView& view) {
  skin_.use();
  place(skin_, frame, bone);
  if (bone.cut_away) glDisable(GL_CULL_FACE);
  view.draw_skin();
  glEnable(GL_CULL_FACE);
}

void BonePainter::draw_cut_faces(const Frame& frame, const BoneInScene& bone, const BoneView& view,
                                 const GlTexture& depth) {
  bind_volume(depth_unit, depth);
  cut_.use();
  place(cut_, frame, bone);
  set_depth(cut_, bone.look->depth);
  set_cortex(cut_, *bone.look);
  set_map(cut_, bone.map);
  view.draw_cut_faces();
}

void BonePainter::draw(const Frame& frame, std::uint64_t picture) {
  begin(skin_, frame);
  set_lines(skin_, frame);
  begin(cut_, frame);
  bind_volume(noise_unit, noise_);
  triangle_count_ = 0;
  uploaded_bytes_ = 0;
  for (const BoneInScene& bone : frame.scene.bones) {
    CHECK(bone.mesh != nullptr && bone.look != nullptr);
    const std::uint64_t before =
        bones_.contains(bone.mesh->id) ? bones_.at(bone.mesh->id).view.uploaded_bytes() : 0;
    const BoneView& view = view_of(bone, picture);
    uploaded_bytes_ += view.uploaded_bytes() - before;
    triangle_count_ += view.triangle_count();
    const GlTexture& depth = depth_of(*bone.look, picture);
    if (bone.cut_away) glEnable(GL_CLIP_DISTANCE0);
    draw_skin(frame, bone, view);
    draw_cut_faces(frame, bone, view, depth);
    glDisable(GL_CLIP_DISTANCE0);
  }
  glBindVertexArray(0);
  glActiveTexture(GL_TEXTURE0);
}

void BonePainter::forget_before(std::uint64_t picture) {
  std::erase_if(bones_, [&](const auto& seen) { return seen.second.picture < picture; });
  std::erase_if(looks_, [&](const auto& seen) { return seen.second.picture < picture; });
}

}  // namespace hallux::ui
