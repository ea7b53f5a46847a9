/// One piece of bone on the graphics card: what stands still is sent once; hidden triangles and the
/// patch when they change. Inside this corner only.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "ui/render/gl/display_buffer.h"
#include "ui/render/scene/bone_mesh.h"

namespace hallux::ui {

class BoneView {
 public:
  /// Sends the mesh.
  explicit BoneView(const BoneMesh& mesh);

  /// Shows the mesh with this patch, or whole again where there is none. The same revision again
  /// costs nothing.
  /// needs   the mesh that this view was made of
  void show(const BoneMesh& mesh, const simulator::SolidPatch* patch, std::uint64_t revision);

  /// Only what may be seen is drawn.
  /// shape   frustum in the bone frame
  void draw_skin(const Frustum& frustum);
  void draw_cut_faces(const Frustum& frustum);

  /// Of the patch; 0: none.
  std::uint64_t revision() const noexcept { return revision_; }
  /// Around all that looks different since that revision was shown, bone frame; nothing where that
  /// is not known any more.
  std::optional<Box> changed_since(std::uint64_t revision) const;

  std::size_t triangle_count() const noexcept {
    return triangles_.size() + patch_.triangles.size();
  }
  /// Of all its buffers together.
  std::uint64_t uploaded_bytes() const noexcept;

 private:
  /// Vertices and triangles that are drawn together.
  struct Arrays {
    GlVertexArray array;
    /// The buffers it was set up with.
    unsigned vertices = 0, triangles = 0;

    void point_at(unsigned vertex_buffer, unsigned index_buffer);
  };

  /// What one revision changed against the one before.
  struct Change {
    std::uint64_t from_revision = 0;
    Box box;
  };

  void hide(const BoneMesh& mesh, const std::vector<std::uint32_t>& hidden, Box& changed);
  void show_patch(const BoneMesh& mesh, const simulator::SolidPatch& patch);
  void draw_seen(const std::vector<TriangleCluster>& clusters, const Frustum& frustum);

  DisplayBuffer<BoneVertex> vertices_, patch_vertices_;
  DisplayBuffer<simulator::Triangle> triangles_, patch_triangles_;
  Arrays still_, moving_;
  const std::vector<TriangleCluster> skin_, cut_;
  PatchMesh patch_, patch_before_;
  /// The newest last.
  std::deque<Change> changes_;
  std::uint64_t revision_ = 0;
  /// Ascending.
  std::vector<std::uint32_t> hidden_;
  /// Room for draw_seen.
  std::vector<TriangleRun> seen_;
};

}  // namespace hallux::ui
