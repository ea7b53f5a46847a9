/// One piece of bone on the graphics card: what stands still is sent once; hidden triangles and the patch when they change.
#pragma once

#include <cstdint>
#include <vector>

#include "ui/render/bone_mesh.h"
#include "ui/render/display_buffer.h"

namespace hallux::ui {

class BoneView {
 public:
  /// Sends the mesh.
  explicit BoneView(const BoneMesh& mesh);

  /// Shows the mesh with this patch, or whole again where there is none. The same revision again costs nothing.
  /// needs   the mesh that this view was made of
  void show(const BoneMesh& mesh, const simulator::SolidPatch* patch, std::uint64_t revision);

  void draw_skin() const;
  void draw_cut_faces() const;

  std::size_t triangle_count() const noexcept {
    return triangles_.size() + patch_.triangles.size();
  }
  /// Of all its buffers together.
  std::uint64_t uploaded_bytes() const noexcept;

 private:
  /// Vertices and triangles that are drawn together.
  struct Arrays {
    GlVertexArray array;
    unsigned vertices = 0, triangles = 0;  ///< the buffers it was set up with

    void point_at(unsigned vertex_buffer, unsigned index_buffer);
  };

  void hide(const BoneMesh& mesh, const std::vector<std::uint32_t>& hidden);

  DisplayBuffer<BoneVertex> vertices_, patch_vertices_;
  DisplayBuffer<simulator::Triangle> triangles_, patch_triangles_;
  Arrays still_, moving_;
  std::size_t skin_count_ = 0;
  PatchMesh patch_;
  std::uint64_t revision_ = 0;
  std::vector<std::uint32_t> hidden_;  ///< ascending
};

}  // namespace hallux::ui
