/// A bone's solid as the graphics card wants it: vertices with normals, triangles in the order in
/// which they are drawn.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "simulator/cutting/solid/solid_patch.h"
#include "ui/render/scene/bone_look.h"
#include "ui/render/scene/float_vector.h"
#include "ui/render/scene/triangle_clusters.h"

namespace hallux::ui {

inline constexpr std::int16_t canal_kerf = -2;

/// 24 bytes, as the shaders read it.
struct BoneVertex {
  Float3 point_in_bone_mm{0.0F};
  /// Unit length times 32767.
  std::array<std::int16_t, 3> normal{};
  /// How much light comes here, 0 to 32767.
  std::int16_t openness = 32767;
  /// Of the face, see FaceSource; the canal's wall: canal_kerf.
  std::int16_t kerf = -1, side = 0;
};

/// A piece of bone that stands still while it is looked at; a new one after each commit.
struct BoneMesh {
  /// Another content has another; given by whoever makes it.
  std::uint64_t id = 0;
  simulator::CutSolid solid;
  /// The box around it.
  Vec3 low_mm{0.0, 0.0, 0.0}, high_mm{0.0, 0.0, 0.0};
  std::vector<BoneVertex> vertices;
  /// By vertices; the skin's first.
  std::vector<simulator::Triangle> triangles;
  /// Triangles of the skin; the others are cut faces and the canal's wall.
  std::size_t skin_count = 0;
  /// All of `triangles`, in their order.
  std::vector<TriangleCluster> skin_clusters, cut_clusters;
  /// Per triangle of the solid its place in `triangles`.
  std::vector<std::uint32_t> place_of;
  /// Per point of the solid; no_index inside the bone.
  std::vector<std::uint32_t> skin_vertex_of;
};

/// Vertices are shared where faces of one source meet, so that skins are smooth and walls are sharp
/// at their rims.
/// needs   id is not 0 and was not given to another content; look is of the bone that the solid was
///         cut from
/// thread  any; no graphics
BoneMesh mesh_of(std::uint64_t id, const simulator::CutSolid& solid, const BoneLook& look);

/// The same with light on its cut faces that the solid alone keeps from them.
BoneMesh lit_mesh_of(std::uint64_t id, const simulator::CutSolid& solid, const BoneLook& look);

/// A patch's triangles, sorted as a BoneMesh's are, with vertices of their own.
struct PatchMesh {
  std::vector<BoneVertex> vertices;
  /// The skin's first.
  std::vector<simulator::Triangle> triangles;
  std::size_t skin_count = 0;
};

/// Replaces `made` by the patch's picture.
/// needs   the patch was built on mesh.solid
/// thread  any; no graphics
void make_patch_mesh(const BoneMesh& mesh, const simulator::SolidPatch& patch, PatchMesh& made);

/// Another solid near a wall.
struct Occluder {
  /// In its own frame; stays the caller's.
  const simulator::Bvh* bvh = nullptr;
  RigidTransform body_from_other;
};

/// Sets how much light reaches each cut face: by how far the next surface lies that it looks at, of
/// this solid or others. To be called again when a neighbour was taken away or moved.
/// needs   occluders hold the mesh's own tree, with the identity
/// thread  any; no graphics
void light_cut_faces(BoneMesh& mesh, std::span<const Occluder> occluders);

}  // namespace hallux::ui
