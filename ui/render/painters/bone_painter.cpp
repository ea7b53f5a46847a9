// Bones in two steps: first shapes, where normal, place and which part of a bone a pixel shows are
// written, with the part in the stencil; then light, one pass for each kind of part over the pixels
// that want it. So light is computed once a pixel, however many triangles lie behind each other,
// and again only where it changed.
#include "ui/render/painters/bone_painter.h"

#include <epoxy/gl.h>

#include <array>
#include <cmath>

#include "simulator/base/check.h"
#include "ui/render/painters/bone_pass.h"
#include "ui/render/painters/tool_shadow.h"

namespace hallux::ui {

namespace {

constexpr double outline_pixels = 2.5;

void bind_volume(int unit, const GlTexture& texture) {
  glActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
  glBindTexture(GL_TEXTURE_3D, texture.name());
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

/// The pixels that the mesh can cover.
PixelBox pixels_of(const Frame& frame, const BoneInScene& bone) {
  return pixels_of({bone.mesh->low_mm, bone.mesh->high_mm}, bone.world_from_bone, frame.view,
                   frame.target.size);
}

/// What of the bone may be seen through part of the picture.
Frustum frustum_of(const Frame& frame, const BoneInScene& bone, const DoubleMatrix4& clip_from_bone,
                   const PixelBox& part) {
  const Vec2 size(frame.target.size.width, frame.target.size.height);
  Frustum frustum = frustum_through(clip_from_bone, Vec2(part.left, part.bottom) / size,
                                    Vec2(part.right, part.top) / size);
  if (!bone.cut_away) {
    frustum.eye_mm = transform_point(inverse(bone.world_from_bone), frame.view.eye_in_world_mm);
  }
  return frustum;
}

/// The shadow of the tool in the hand on bones.
void set_shadow(ShaderProgram& program, const Frame& frame) {
  const std::optional<ToolShadow> shadow = tool_shadow(frame.scene, frame.key_light);
  if (!shadow) {
    program.set("blade_shadow", Float4(0.0F));
    return;
  }
  program.set("key_in_tool", to_float(shadow->key_in_tool));
  program.set("blade_shadow", Float4(shadow->blade_depth_mm, shadow->blade_half_width_mm, 1.0,
                                     shadow->handpiece_from_mm));
  program.set("shaft_shadow", static_cast<float>(shadow->shaft_radius_mm));
}

}  // namespace

BonePainter::BonePainter(const NoiseTextures& noise)
    : noise_(noise),
      shape_("bone.vert", "bone.frag"),
      cut_("part.vert", "bone_cut.frag"),
      outline_("outline.vert", "ghost.frag") {}

void BonePainter::send_depth(const BoneLook& look, std::uint64_t picture) {
  const auto [at, is_new] = looks_.try_emplace(look.id);
  at->second.picture = picture;
  if (!is_new) return;
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
}

BoneView& BonePainter::view_of(const BoneMesh& mesh, std::uint64_t picture) {
  auto at = bones_.find(mesh.id);
  if (at == bones_.end()) at = bones_.emplace(mesh.id, SeenBone{BoneView(mesh), picture}).first;
  at->second.picture = picture;
  return at->second.view;
}

void BonePainter::show(const Scene& scene, std::uint64_t picture) {
  CHECK(scene.bones.size() <= bones_at_most);
  triangle_count_ = 0;
  uploaded_bytes_ = 0;
  for (const BoneInScene& bone : scene.bones) {
    CHECK(bone.mesh != nullptr && bone.look != nullptr);
    const auto seen = bones_.find(bone.mesh->id);
    const std::uint64_t before = seen == bones_.end() ? 0 : seen->second.view.uploaded_bytes();
    BoneView& view = view_of(*bone.mesh, picture);
    view.show(*bone.mesh, bone.patch, bone.patch_revision);
    uploaded_bytes_ += view.uploaded_bytes() - before;
    triangle_count_ += view.triangle_count();
    send_depth(*bone.look, picture);
  }
  for (const FreePiece& piece : scene.free_pieces) {
    CHECK(piece.mesh != nullptr);
    view_of(*piece.mesh, picture);
  }
}

std::vector<std::uint64_t> BonePainter::revisions(const Scene& scene) const {
  std::vector<std::uint64_t> revisions;
  for (const BoneInScene& bone : scene.bones) {
    revisions.push_back(bones_.at(bone.mesh->id).view.revision());
  }
  return revisions;
}

std::optional<std::vector<Box>> BonePainter::changed_since(
    const Scene& scene, std::span<const std::uint64_t> revisions) const {
  CHECK(revisions.size() == scene.bones.size());
  std::vector<Box> changed;
  for (std::size_t i = 0; i < revisions.size(); ++i) {
    const BoneView& view = bones_.at(scene.bones[i].mesh->id).view;
    const std::optional<Box> box = view.changed_since(revisions[i]);
    if (!box) return std::nullopt;
    changed.push_back(*box);
  }
  return changed;
}

void BonePainter::draw_shape(const Frame& frame, std::size_t number, const PixelBox& part) {
  const BoneInScene& bone = frame.scene.bones[number];
  const DoubleMatrix4 world_from_bone = matrix_of(bone.world_from_bone);
  const DoubleMatrix4 clip_from_bone = frame.clip_from_world * world_from_bone;
  shape_.set("world_from_bone", to_float(world_from_bone));
  shape_.set("clip_from_bone", to_float(clip_from_bone));
  // Set in either case: llvmpipe goes on clipping by the plane of the picture before where that was
  // cut open.
  shape_.set("cut_away", bone.cut_away ? Float4(to_float(bone.cut_away->normal_in_bone),
                                                bone.cut_away->offset_mm)
                                       : Float4(0.0F, 0.0F, 0.0F, 1.0F));
  if (bone.cut_away) {
    glEnable(GL_CLIP_DISTANCE0);
    glDisable(GL_CULL_FACE);
  }
  const Frustum frustum = frustum_of(frame, bone, clip_from_bone, part);
  BoneView& view = bones_.at(bone.mesh->id).view;
  glStencilFunc(GL_ALWAYS, skin_of(number), all_bits);
  view.draw_skin(frustum);
  glStencilFunc(GL_ALWAYS, cut_faces_of(number), all_bits);
  view.draw_cut_faces(frustum);
  glEnable(GL_CULL_FACE);
  glDisable(GL_CLIP_DISTANCE0);
}

void BonePainter::draw_shapes(const Frame& frame, const PixelBox& part) {
  shape_.use();
  set_scissor(part);
  glEnable(GL_STENCIL_TEST);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  for (std::size_t i = 0; i < frame.scene.bones.size(); ++i) draw_shape(frame, i, part);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  glDisable(GL_STENCIL_TEST);
  glBindVertexArray(0);
}

ShaderProgram& BonePainter::skin_program(const Frame& frame, const BoneInScene& bone) {
  std::string settings;
  if (world_from_shading_tool(frame.scene) != nullptr) settings += "#define SHADOW\n";
  if (bone.presence < 1.0) settings += "#define FADED\n";
  auto at = skins_.find(settings);
  if (at == skins_.end()) {
    at = skins_.emplace(settings, ShaderProgram("part.vert", "bone_skin.frag", settings)).first;
  }
  return at->second;
}

void BonePainter::light_skin(const Frame& frame, const BoneInScene& bone,
                             std::span<const PixelBox> boxes) {
  ShaderProgram& program = skin_program(frame, bone);
  begin_light(program, frame);
  program.set("relief", relief_unit);
  program.set("slope_scale", static_cast<float>(noise_.slope_scale()));
  place_bone(program, frame, bone);
  set_boxes(program, boxes, frame.target.size);
  draw_boxes(boxes);
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

void BonePainter::light_cut_faces(const Frame& frame, const BoneInScene& bone,
                                  std::span<const PixelBox> boxes) {
  bind_volume(depth_unit, looks_.at(bone.look->id).depth);
  cut_.use();
  place_bone(cut_, frame, bone);
  set_depth(cut_, bone.look->depth);
  set_cortex(cut_, *bone.look);
  set_map(cut_, bone);
  draw_boxes(boxes);
}

void BonePainter::draw_light(const Frame& frame, std::span<const PixelBox> boxes) {
  begin_light(cut_, frame);
  set_boxes(cut_, boxes, frame.target.size);
  noise_.bind();
  const BonePass pass(frame, no_attributes_);
  for (std::size_t i = 0; i < frame.scene.bones.size(); ++i) {
    const BoneInScene& bone = frame.scene.bones[i];
    set_scissor(pixels_of(frame, bone));
    pass.take_only(skin_of(i));
    light_skin(frame, bone, boxes);
    pass.take_only(cut_faces_of(i));
    light_cut_faces(frame, bone, boxes);
  }
}

void BonePainter::draw_outlines(const Frame& frame) {
  if (frame.scene.free_pieces.empty()) return;
  outline_.use();
  outline_.set("ink", Float4(colour_of(frame.palette, Ink::Accent), 1.0F));
  const Vec2 size(frame.target.size.width, frame.target.size.height);
  const Vec2 width = outline_pixels * frame.pixel_scale * 2.0 / size;
  outline_.set("width", Float4(width.x, width.y, size.x, size.y));
  glCullFace(GL_FRONT);
  for (const FreePiece& piece : frame.scene.free_pieces) {
    const DoubleMatrix4 clip_from_bone = frame.clip_from_world * matrix_of(piece.world_from_bone);
    outline_.set("clip_from_bone", to_float(clip_from_bone));
    // Backs are what is drawn: nothing is left out for looking away.
    const Frustum all = frustum_through(clip_from_bone, Vec2(0.0), Vec2(1.0));
    BoneView& view = bones_.at(piece.mesh->id).view;
    view.draw_skin(all);
    view.draw_cut_faces(all);
  }
  glCullFace(GL_BACK);
  glBindVertexArray(0);
}

void BonePainter::forget_before(std::uint64_t picture) {
  std::erase_if(bones_, [&](const auto& seen) { return seen.second.picture < picture; });
  std::erase_if(looks_, [&](const auto& seen) { return seen.second.picture < picture; });
}

}  // namespace hallux::ui
