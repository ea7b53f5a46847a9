/// The bone that is being cut, on OpenMesh's half-edges: what is shown during a cut, and cuts that are done, in place.
///
///     load      half-edges with spare room, once
///     frame     show(patch): some faces are hidden, a patch stands in their place; the half-edges stay
///     cut done  commit(patch): hidden faces die, the patch becomes faces in the spare room; no other handle moves
///     between   compacted(): a copy without the dead and with new room, made by a worker, swapped in
///
/// Cuts are sliced on `indexed()`, plain triangles that know their faces, and not on the half-edges: the next contact needs
/// a search tree over what stands in any case, which costs as much, and the kernel's loops want arrays without dead faces
/// in them. A patch on those triangles names its faces through them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "simulator/cutting/solid/mend_solid.h"
#include "simulator/cutting/solid/solid_patch.h"
#include "simulator/mesh/solid_mesh.h"

namespace hallux::simulator {

/// Where a vertex lies on the bone as it was before any cut.
struct SkinPoint {
  Vec3 on_bone_mm{0.0, 0.0, 0.0};  ///< in the bone frame; also its place in the bone's texture
  Vec3 normal{0.0, 0.0, 0.0};      ///< of the skin there, unit length
  bool is_on_skin = false;         ///< otherwise a vertex inside the bone, of walls and fronts only
};

/// Room for what cuts add, half as many points as triangles. Enough for four cuts right through a sphere of 9 mm with 500,000
/// triangles, which added 34,000 each at most; bones have fewer triangles on that length.
struct SpareRoom {
  std::size_t points = 60'000, triangles = 120'000;
};

/// What stands as plain triangles, and the names of its parts in the working solid.
struct IndexedSolid {
  CutSolid solid;
  std::vector<std::uint32_t> faces, vertices;  ///< per triangle and per point; ascending
  std::uint32_t commits = 0;                   ///< the working solid's when this was made
};

enum class CommitOutcome {
  Done,
  NoRoom  ///< nothing was changed: the cut goes into a compacted() solid
};

struct WorkingPieces;

class WorkingSolid {
 public:
  /// Triangle i of the solid becomes face i. Normals are means over the faces of the bone's own surface by their areas.
  /// errors  MeshError (see half_edges_of)
  explicit WorkingSolid(const CutSolid& solid, const SpareRoom& room = {});

  const HalfEdgeMesh& half_edges() const noexcept { return mesh_; }
  const FaceOrigin& origin(OpenMesh::FaceHandle face) const {
    return mesh_.property(origin_, face);
  }
  const SkinPoint& skin(OpenMesh::VertexHandle vertex) const {
    return mesh_.property(skin_, vertex);
  }
  /// How many cuts are done.
  std::uint32_t commits() const noexcept { return commits_; }
  SpareRoom room_left() const noexcept;

  /// What stands, cuts that are done included. Cost grows with the bone.
  IndexedSolid indexed() const;

  /// Hides the faces that the patch replaces, and those only.
  /// needs   the patch was built on base.solid, and base is indexed() since the last commit
  /// ensures cost grows with what was and is hidden
  void show(const SolidPatch& patch, const IndexedSolid& base);
  bool is_hidden(OpenMesh::FaceHandle face) const { return mesh_.status(face).hidden(); }
  /// What a patch's point has of the skin: its parent triangle's corners by skin_weights.
  /// needs   as show
  SkinPoint skin_at(const IndexedSolid& base, std::uint32_t parent, const Vec3& point_mm) const;

  /// Makes the patch part of the solid, in place: hidden faces and what only they used are deleted, the patch's points and
  /// faces come behind all others. Nothing is shown afterwards.
  /// needs   as show
  /// ensures indexed() is what commit_patch makes of base.solid; no face or vertex that stands changes its handle, its place
  ///         or its attributes; within the room no table of the half-edges moves; cost grows with the patch
  /// errors  NoRoom. A point where two fans of the patch touch gets a copy, which is not foreseen: it may make the table of
  ///         points grow
  [[nodiscard]] CommitOutcome commit(const SolidPatch& patch, const IndexedSolid& base);

  /// The same solid without dead parts. Cost grows with the bone: a worker's, between two cuts.
  WorkingSolid compacted(const SpareRoom& room = {}) const;
  /// The connected bodies with their canals, as split_pieces orders them; pieces below debris_limit_mm3, sheets without
  /// volume among them, are only counted.
  WorkingPieces pieces(const SpareRoom& room = {}) const;

 private:
  /// A directed edge between a face that stands and one that is about to die.
  struct RimSide {
    std::uint64_t edge = 0;  ///< as EdgeUse's
    bool is_descending = false;
    OpenMesh::HalfedgeHandle side;
  };

  WorkingSolid(const CutSolid& solid, const SpareRoom& room, bool finds_skin);
  void find_skin();
  void take_skin(const WorkingSolid& from, const IndexedSolid& base,
                 const std::vector<std::uint32_t>& triangles, const CutSolid& part);
  static SkinPoint blend(const std::array<SkinPoint, 3>& corners,
                         const std::array<double, 3>& weights) noexcept;

  void take_in(const SolidPatch& patch, const IndexedSolid& base);
  void separate_repeated();
  std::uint32_t add_middle(std::uint32_t a, std::uint32_t b);
  bool has_room() const noexcept;
  void delete_hidden(const SolidPatch& patch, const IndexedSolid& base);
  void add_vertices();
  void add_sides();
  void add_faces();
  void separate_fans();
  void delete_unused_vertices();

  HalfEdgeMesh mesh_;
  OpenMesh::FPropHandleT<FaceOrigin> origin_;
  OpenMesh::VPropHandleT<SkinPoint> skin_;
  std::size_t vertices_at_most_ = 0, faces_at_most_ = 0, edges_at_most_ = 0;
  std::uint32_t commits_ = 0;
  std::vector<OpenMesh::FaceHandle> hidden_;

  // What a commit adds: points by their future vertices, triangles by vertices; kept for the memory.
  std::vector<Vec3> new_points_mm_;
  std::vector<SkinPoint> new_skins_;
  std::vector<std::uint32_t> new_vertex_of_;  // per patch point
  std::vector<Triangle> new_triangles_;
  std::vector<FaceOrigin> new_origins_;
  EdgeMender mender_;
  std::vector<RimSide> rim_;
  std::vector<OpenMesh::HalfedgeHandle> sides_;  // three per new triangle, side k leaves corner k
  std::vector<std::uint8_t> is_walked_;          // per side
  std::vector<OpenMesh::VertexHandle> touched_;  // vertices of hidden faces
  std::uint32_t first_vertex_ = 0, first_face_ = 0;
};

struct WorkingPieces {
  std::vector<WorkingSolid> bodies;
  std::size_t debris_count = 0;
  double debris_mm3 = 0.0;
};

}  // namespace hallux::simulator
