/// Generated bones are remeshed by OpenMesh's kernel and by nothing beside it.
///
/// The linker leads each call of the kernel through a counter here (`--wrap` in CMakeLists.txt), so
/// what the shipped archive calls is counted. A collapse takes one point away and a split adds one;
/// a point or a triangle made or lost by other code would break the sums.
#include <gtest/gtest.h>

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>
#include <array>
#include <cstdint>

#include "scenarios/foot/first_metatarsal.h"
#include "scenarios/foot/first_proximal_phalanx.h"
#include "scenarios/foot/remesh.h"

namespace hallux::scenarios {
namespace {

using OpenMesh::EdgeHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::PolyConnectivity;
using OpenMesh::TriConnectivity;
using OpenMesh::VertexHandle;

struct KernelCalls {
  std::size_t faces_added = 0, splits = 0, collapses = 0, collapses_allowed = 0, flips = 0,
              flips_allowed = 0;
};

KernelCalls calls;

}  // namespace

// The kernel's own functions, as the linker names them, and what is called in their place.
OpenMesh::SmartFaceHandle kernel_add_face(
    TriConnectivity* mesh, VertexHandle a, VertexHandle b,
    VertexHandle c) asm("__real__ZN8OpenMesh15TriConnectivity8add_faceENS_12VertexHandleES1_S1_");
OpenMesh::SmartFaceHandle counted_add_face(
    TriConnectivity* mesh, VertexHandle a, VertexHandle b,
    VertexHandle c) asm("__wrap__ZN8OpenMesh15TriConnectivity8add_faceENS_12VertexHandleES1_S1_");
void kernel_split(TriConnectivity* mesh, EdgeHandle edge, VertexHandle vertex) asm(
    "__real__ZN8OpenMesh15TriConnectivity5splitENS_10EdgeHandleENS_12VertexHandleE");
void counted_split(TriConnectivity* mesh, EdgeHandle edge, VertexHandle vertex) asm(
    "__wrap__ZN8OpenMesh15TriConnectivity5splitENS_10EdgeHandleENS_12VertexHandleE");
bool kernel_is_collapse_ok(TriConnectivity* mesh, HalfedgeHandle side) asm(
    "__real__ZN8OpenMesh15TriConnectivity14is_collapse_okENS_14HalfedgeHandleE");
bool counted_is_collapse_ok(TriConnectivity* mesh, HalfedgeHandle side) asm(
    "__wrap__ZN8OpenMesh15TriConnectivity14is_collapse_okENS_14HalfedgeHandleE");
void kernel_collapse(PolyConnectivity* mesh, HalfedgeHandle side) asm(
    "__real__ZN8OpenMesh16PolyConnectivity8collapseENS_14HalfedgeHandleE");
void counted_collapse(PolyConnectivity* mesh, HalfedgeHandle side) asm(
    "__wrap__ZN8OpenMesh16PolyConnectivity8collapseENS_14HalfedgeHandleE");
bool kernel_is_flip_ok(const TriConnectivity* mesh, EdgeHandle edge) asm(
    "__real__ZNK8OpenMesh15TriConnectivity10is_flip_okENS_10EdgeHandleE");
bool counted_is_flip_ok(const TriConnectivity* mesh, EdgeHandle edge) asm(
    "__wrap__ZNK8OpenMesh15TriConnectivity10is_flip_okENS_10EdgeHandleE");
void kernel_flip(TriConnectivity* mesh,
                 EdgeHandle edge) asm("__real__ZN8OpenMesh15TriConnectivity4flipENS_10EdgeHandleE");
void counted_flip(TriConnectivity* mesh, EdgeHandle edge) asm(
    "__wrap__ZN8OpenMesh15TriConnectivity4flipENS_10EdgeHandleE");

OpenMesh::SmartFaceHandle counted_add_face(TriConnectivity* mesh, VertexHandle a, VertexHandle b,
                                           VertexHandle c) {
  ++calls.faces_added;
  return kernel_add_face(mesh, a, b, c);
}

void counted_split(TriConnectivity* mesh, EdgeHandle edge, VertexHandle vertex) {
  ++calls.splits;
  kernel_split(mesh, edge, vertex);
}

bool counted_is_collapse_ok(TriConnectivity* mesh, HalfedgeHandle side) {
  const bool is_ok = kernel_is_collapse_ok(mesh, side);
  if (is_ok) ++calls.collapses_allowed;
  return is_ok;
}

void counted_collapse(PolyConnectivity* mesh, HalfedgeHandle side) {
  ++calls.collapses;
  kernel_collapse(mesh, side);
}

bool counted_is_flip_ok(const TriConnectivity* mesh, EdgeHandle edge) {
  const bool is_ok = kernel_is_flip_ok(mesh, edge);
  if (is_ok) ++calls.flips_allowed;
  return is_ok;
}

void counted_flip(TriConnectivity* mesh, EdgeHandle edge) {
  ++calls.flips;
  kernel_flip(mesh, edge);
}

namespace {

/// The kernel did all of it: each operation was called, none without its check.
void expect_whole_kernel() {
  EXPECT_GT(calls.faces_added, 0U);
  EXPECT_GT(calls.splits, 0U);
  EXPECT_GT(calls.collapses, 0U);
  EXPECT_EQ(calls.collapses, calls.collapses_allowed);
  EXPECT_GT(calls.flips, 0U);
  EXPECT_LE(calls.flips, calls.flips_allowed);
}

simulator::Bone metatarsal() {
  return make_first_metatarsal(first_metatarsal_table(), {.eminence_mm = 4.0, .edge_mm = 1.0});
}

simulator::Bone phalanx() {
  return make_first_proximal_phalanx(first_proximal_phalanx_table(), {.edge_mm = 1.0});
}

TEST(OpenMeshKernel, RemeshesEachGeneratedBone) {
  for (const auto make : {metatarsal, phalanx}) {
    calls = {};
    const simulator::Bone bone = make();
    expect_whole_kernel();
  }
}

TEST(OpenMeshKernel, AddsAndTakesEachPointAndTriangleOfASurface) {
  const Field field = [](const Vec3& p) {
    const double r = std::sqrt(glm::dot(p, p) + 1e-12);
    return Dual{r - 3.0, p / r};
  };
  const simulator::IndexedMesh raw =
      march_tetrahedra(sample_field(field, {{-4.0, -4.0, -4.0}, {4.0, 4.0, 4.0}, 1.0, 1.0}));
  calls = {};
  const simulator::IndexedMesh even = remesh(raw, field, 0.4, {});
  expect_whole_kernel();
  EXPECT_EQ(calls.faces_added, raw.triangles.size());
  EXPECT_EQ(even.points_mm.size(), raw.points_mm.size() + calls.splits - calls.collapses);
  EXPECT_EQ(even.triangles.size(), raw.triangles.size() + 2 * calls.splits - 2 * calls.collapses);
}

}  // namespace
}  // namespace hallux::scenarios
