#include "ui/render/bone_view.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstddef>
#include <iterator>

#include "simulator/base/check.h"

namespace hallux::ui {

namespace {

using simulator::Triangle;

/// What stands still never grows.
constexpr BufferPolicy exact{.growth = {.factor = 1.0, .least = 1}};
/// All three corners the same: nothing is drawn.
constexpr Triangle blank{0, 0, 0};

/// OpenGL takes places in a buffer as pointers from nowhere.
const void* offset_of(std::size_t bytes) { return static_cast<const std::byte*>(nullptr) + bytes; }

void draw_triangles(std::size_t first, std::size_t count) {
  if (count == 0) return;
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * count), GL_UNSIGNED_INT,
                 offset_of(first * sizeof(Triangle)));
}

}  // namespace

BoneView::BoneView(const BoneMesh& mesh)
    : vertices_({}, exact), triangles_(blank, exact), skin_count_(mesh.skin_count) {
  vertices_.assign(mesh.vertices);
  vertices_.upload();
  triangles_.assign(mesh.triangles);
  triangles_.upload();
  still_.point_at(vertices_.name(), triangles_.name());
}

void BoneView::Arrays::point_at(unsigned vertex_buffer, unsigned index_buffer) {
  if (vertices == vertex_buffer && triangles == index_buffer) return;
  vertices = vertex_buffer;
  triangles = index_buffer;
  constexpr auto stride = static_cast<GLsizei>(sizeof(BoneVertex));
  glBindVertexArray(array.name());
  glBindBuffer(GL_ARRAY_BUFFER, vertex_buffer);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride,
                        offset_of(offsetof(BoneVertex, point_in_bone_mm)));
  glEnableVertexAttribArray(1);
  glVertexAttribPointer(1, 4, GL_SHORT, GL_TRUE, stride, offset_of(offsetof(BoneVertex, normal)));
  glEnableVertexAttribArray(2);
  glVertexAttribPointer(2, 2, GL_SHORT, GL_FALSE, stride, offset_of(offsetof(BoneVertex, kerf)));
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, index_buffer);
  glBindVertexArray(0);
}

void BoneView::hide(const BoneMesh& mesh, const std::vector<std::uint32_t>& hidden) {
  std::vector<std::uint32_t> gone, back;
  std::set_difference(hidden.begin(), hidden.end(), hidden_.begin(), hidden_.end(),
                      std::back_inserter(gone));
  std::set_difference(hidden_.begin(), hidden_.end(), hidden.begin(), hidden.end(),
                      std::back_inserter(back));
  for (std::uint32_t& triangle : gone) triangle = mesh.place_of[triangle];
  triangles_.remove(gone);
  for (const std::uint32_t triangle : back) {
    const std::uint32_t place = mesh.place_of[triangle];
    triangles_.write(place, mesh.triangles[place]);
  }
  triangles_.upload();
  hidden_ = hidden;
}

void BoneView::show(const BoneMesh& mesh, const simulator::SolidPatch* patch,
                    std::uint64_t revision) {
  if (patch == nullptr) revision = 0;
  if (revision == revision_) return;
  revision_ = revision;
  if (patch == nullptr) {
    patch_ = {};
    hide(mesh, {});
    return;
  }
  CHECK(revision != 0);
  hide(mesh, patch->hidden);
  make_patch_mesh(mesh, *patch, patch_);
  patch_vertices_.assign(patch_.vertices);
  patch_vertices_.upload();
  patch_triangles_.assign(patch_.triangles);
  patch_triangles_.upload();
  moving_.point_at(patch_vertices_.name(), patch_triangles_.name());
}

void BoneView::draw_skin() const {
  glBindVertexArray(still_.array.name());
  draw_triangles(0, skin_count_);
  glBindVertexArray(moving_.array.name());
  draw_triangles(0, patch_.skin_count);
}

void BoneView::draw_cut_faces() const {
  glBindVertexArray(still_.array.name());
  draw_triangles(skin_count_, triangles_.size() - skin_count_);
  glBindVertexArray(moving_.array.name());
  draw_triangles(patch_.skin_count, patch_.triangles.size() - patch_.skin_count);
}

std::uint64_t BoneView::uploaded_bytes() const noexcept {
  return vertices_.counts().uploaded_bytes + triangles_.counts().uploaded_bytes +
         patch_vertices_.counts().uploaded_bytes + patch_triangles_.counts().uploaded_bytes;
}

}  // namespace hallux::ui
