/// Our kernel as the benchmarks run it: one cut, from the contact to the committed solid.
#pragma once

#include <cstdint>
#include <vector>

#include "simulator/cutting/field/region_outline.h"
#include "simulator/cutting/slice/slab_slice.h"
#include "simulator/cutting/solid/solid_patch.h"

namespace hallux::benchmarks {

/// What a frame hands to the graphics card: what is new, in its number format. The mesh that stands
/// still is there already.
struct UploadBuffers {
  /// Three per point of the patch.
  std::vector<float> positions_mm;
  std::vector<std::uint32_t> indices;
  /// Triangles of the mesh that are no longer drawn.
  std::vector<std::uint32_t> hidden;
};

/// Processor time of the parts of the last frame.
struct FrameParts {
  double field_ms = 0.0, outline_ms = 0.0, patch_ms = 0.0, buffers_ms = 0.0;
};

/// needs   solid, bvh and field outlive it; the field is closed everywhere
class OurCut {
 public:
  /// The contact: everything that is done once.
  OurCut(const simulator::CutSolid& solid, const simulator::Bvh& bvh,
         const simulator::KerfPlane& plane, simulator::KerfField& field, std::int32_t kerf = 0);
  OurCut(const OurCut&) = delete;
  OurCut& operator=(const OurCut&) = delete;

  /// A frame: stamps the blade's way from where it was, and brings outline, patch and buffers up to
  /// date.
  /// ensures true where this opened something and bone is taken away
  bool advance(const simulator::Blade& blade, const simulator::PlanarPose& to);

  const simulator::SlabSlice& contact() const noexcept { return contact_; }
  const simulator::SolidPatch& patch() const noexcept { return patch_; }
  const simulator::RegionOutline& outline() const noexcept { return tracker_.outline(); }
  const FrameParts& parts() const noexcept { return parts_; }
  std::uint64_t refusals() const noexcept { return builder_.refusals(); }

 private:
  void fill_buffers();

  simulator::KerfField& field_;
  simulator::SlabSlice contact_;
  simulator::PatchBuilder builder_;
  simulator::OutlineTracker tracker_;
  simulator::SolidPatch patch_;
  UploadBuffers buffers_;
  FrameParts parts_;
  simulator::PlanarPose from_;
  bool has_pose_ = false;
};

/// An outline around every section of these benchmarks' bones.
simulator::RegionOutline whole_plane();

}  // namespace hallux::benchmarks
