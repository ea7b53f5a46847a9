// One bone in the card's memory, with as little sent as a patch changes. Hidden triangles become
// triangles of one point at their place; the patch has buffers of its own. Each change is noted
// with the box around it, found by comparing the old patch with the new one, so that a kept picture
// is drawn again only there.
#include "ui/render/painters/bone_view.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <bit>
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

/// More pictures than are ever drawn of one bone between two of the same kept picture.
constexpr std::size_t changes_kept = 16;

/// A triangle by all that is seen of it, and the same as words that can be put in order.
using Corners = std::array<BoneVertex, 3>;
using CornerWords = std::array<std::uint32_t, sizeof(Corners) / sizeof(std::uint32_t)>;

std::vector<CornerWords> words_of(const PatchMesh& patch) {
  std::vector<CornerWords> words;
  words.reserve(patch.triangles.size());
  for (const Triangle& t : patch.triangles) {
    words.push_back(std::bit_cast<CornerWords>(
        Corners{patch.vertices[t[0]], patch.vertices[t[1]], patch.vertices[t[2]]}));
  }
  return words;
}

/// Takes off how both begin and how both end: a patch grows somewhere in the middle, in the order
/// of its cells.
void drop_what_both_have(std::vector<CornerWords>& one, std::vector<CornerWords>& other) {
  const auto first = std::ranges::mismatch(one, other);
  one.erase(one.begin(), first.in1);
  other.erase(other.begin(), first.in2);
  const auto last = std::mismatch(one.rbegin(), one.rend(), other.rbegin(), other.rend());
  one.erase(last.first.base(), one.end());
  other.erase(last.second.base(), other.end());
}

/// Adds the triangles that only one of the two has.
void add_difference(const PatchMesh& before, const PatchMesh& now, Box& changed) {
  std::vector<CornerWords> old_words = words_of(before), new_words = words_of(now);
  drop_what_both_have(old_words, new_words);
  std::ranges::sort(old_words);
  std::ranges::sort(new_words);
  std::vector<CornerWords> different;
  std::set_symmetric_difference(old_words.begin(), old_words.end(), new_words.begin(),
                                new_words.end(), std::back_inserter(different));
  for (const CornerWords& words : different) {
    for (const BoneVertex& corner : std::bit_cast<Corners>(words)) {
      changed.add(Vec3(corner.point_in_bone_mm));
    }
  }
}

void draw_triangles(std::size_t first, std::size_t count) {
  if (count == 0) return;
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * count), GL_UNSIGNED_INT,
                 offset_of(first * sizeof(Triangle)));
}

}  // namespace

BoneView::BoneView(const BoneMesh& mesh)
    : vertices_({}, exact),
      triangles_(blank, exact),
      skin_(mesh.skin_clusters),
      cut_(mesh.cut_clusters) {
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

void BoneView::hide(const BoneMesh& mesh, const std::vector<std::uint32_t>& hidden, Box& changed) {
  std::vector<std::uint32_t> gone, back;
  std::set_difference(hidden.begin(), hidden.end(), hidden_.begin(), hidden_.end(),
                      std::back_inserter(gone));
  std::set_difference(hidden_.begin(), hidden_.end(), hidden.begin(), hidden.end(),
                      std::back_inserter(back));
  for (const auto* triangles : {&gone, &back}) {
    for (const std::uint32_t triangle : *triangles) {
      for (const std::uint32_t point : mesh.solid.mesh.triangles[triangle]) {
        changed.add(mesh.solid.mesh.points_mm[point]);
      }
    }
  }
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
  CHECK(patch == nullptr || revision != 0);
  if (patch == nullptr) revision = 0;
  if (revision == revision_) return;
  changes_.push_back({revision_, {}});
  if (changes_.size() > changes_kept) changes_.pop_front();
  revision_ = revision;
  static const simulator::SolidPatch none;
  show_patch(mesh, patch != nullptr ? *patch : none);
}

void BoneView::show_patch(const BoneMesh& mesh, const simulator::SolidPatch& patch) {
  Box& changed = changes_.back().box;
  hide(mesh, patch.hidden, changed);
  std::swap(patch_, patch_before_);
  make_patch_mesh(mesh, patch, patch_);
  add_difference(patch_before_, patch_, changed);
  patch_vertices_.assign(patch_.vertices);
  patch_vertices_.upload();
  patch_triangles_.assign(patch_.triangles);
  patch_triangles_.upload();
  moving_.point_at(patch_vertices_.name(), patch_triangles_.name());
}

std::optional<Box> BoneView::changed_since(std::uint64_t revision) const {
  Box changed;
  if (revision == revision_) return changed;
  for (auto change = changes_.rbegin(); change != changes_.rend(); ++change) {
    changed.add(change->box);
    if (change->from_revision == revision) return changed;
  }
  return std::nullopt;
}

void BoneView::draw_seen(const std::vector<TriangleCluster>& clusters, const Frustum& frustum) {
  find_seen(clusters, frustum, seen_);
  glBindVertexArray(still_.array.name());
  for (const TriangleRun& run : seen_) draw_triangles(run.first, run.count);
}

void BoneView::draw_skin(const Frustum& frustum) {
  draw_seen(skin_, frustum);
  glBindVertexArray(moving_.array.name());
  draw_triangles(0, patch_.skin_count);
}

void BoneView::draw_cut_faces(const Frustum& frustum) {
  draw_seen(cut_, frustum);
  glBindVertexArray(moving_.array.name());
  draw_triangles(patch_.skin_count, patch_.triangles.size() - patch_.skin_count);
}

std::uint64_t BoneView::uploaded_bytes() const noexcept {
  return vertices_.counts().uploaded_bytes + triangles_.counts().uploaded_bytes +
         patch_vertices_.counts().uploaded_bytes + patch_triangles_.counts().uploaded_bytes;
}

}  // namespace hallux::ui
