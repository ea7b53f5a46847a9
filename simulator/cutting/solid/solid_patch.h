/// The solid at frame rate: bone minus (region x kerf) as what changed against the mesh that stands
/// still.
///
///     solid shown = mesh without `hidden` triangles + patch triangles
///
/// The patch is the outer skin of the reached triangles, two walls and the fronts. It is closed by
/// construction: every edge is made once and used by its two faces in opposite directions. Its size
/// follows the triangles that the kerf's planes cross and the region's outline, never the number of
/// steps.
#pragma once

#include <cstdint>
#include <vector>

#include "simulator/cutting/fill/ring_filler.h"
#include "simulator/cutting/slice/kerf_arrangement.h"

namespace hallux::simulator {

struct SolidPatch {
  /// Triangles of the mesh, ascending.
  std::vector<std::uint32_t> hidden;
  std::vector<Vec3> points_in_bone_mm;
  /// Per point the mesh triangle whose skin it lies on; no_index inside the bone.
  std::vector<std::uint32_t> parents;
  /// Counter-clockwise from outside. Indices below the mesh's point count are points of the mesh,
  /// the others are patch points behind them.
  std::vector<Triangle> triangles;
  /// Per triangle; walls {kerf, +-1}, fronts {kerf, 0}.
  std::vector<FaceSource> sources;
};

class PatchBuilder {
 public:
  /// Borrows the contact.
  explicit PatchBuilder(const SlabSlice& contact);

  /// Replaces the patch by that of a region.
  /// ensures true: mesh and patch together are closed; a pure function of contact and region
  /// errors  false where the region's outline is not simple: the patch is left as it was (see
  ///         refusals)
  /// thread  worker or geometry; allocates nothing once it has seen as large a region with walls of
  ///         one ring
  bool build(const RegionOutline& region, SolidPatch& patch);
  /// Whether the last region takes all that lies in the slab of every skin that it reaches, and
  /// reaches one.
  bool takes_section() const noexcept { return arrangement_.takes_section(); }
  /// How often build said false.
  std::uint64_t refusals() const noexcept { return refusals_; }

 private:
  struct Piece {
    std::uint32_t from = 0, to = 0;
  };
  /// A piece of a region edge on a strip triangle, as the strip uses it.
  struct FrontCut {
    Piece piece;
    std::uint32_t next_of_edge = no_index;
  };
  /// An end of a cut in one strip triangle.
  struct CutEnd {
    std::uint32_t region_edge = 0, point = 0;
    bool is_start = false;
  };
  /// Where something begins or ends along a line.
  struct Mark {
    double at = 0.0;
    std::uint32_t point = 0;
  };

  void begin();
  void add_points();
  void add_crossing_points();
  void add_hit_points();
  void add_corner_points();
  std::uint32_t add_point(const LatticeCorner& corner, const Vec3& point_in_bone_mm,
                          std::uint32_t parent);
  bool add_skin();
  void add_outer_part(const OuterPart& part);
  bool add_strip_triangle(std::uint32_t triangle);
  bool add_cut_triangle(std::uint32_t triangle);
  void gather_cut_ends(std::uint32_t triangle);
  bool join_cut_ends();
  bool add_front(std::uint32_t region_edge);
  bool add_wall(std::int8_t level);
  bool fill(FaceView view, const FaceSource& source);

  void mark(double at, std::uint32_t point, std::int32_t count);
  bool pair_marks(std::vector<Piece>& pieces);
  bool find_section_pieces();
  bool find_uprights();
  void push_triangle(const Triangle& triangle, const FaceSource& source);
  /// The pieces of a strip edge inside or outside the region, in the edge's direction.
  template <typename Visit>
  void for_pieces(std::uint32_t strip_edge, bool in_region, Visit&& visit) const {
    const StripEdge& edge = contact_.edges[strip_edge];
    bool is_open = arrangement_.is_open(edge.a);
    std::uint32_t from = edge.a;
    for (const std::uint32_t crossing : arrangement_.chain(strip_edge)) {
      const std::uint32_t to = first_crossing_point_ + crossing;
      if (is_open == in_region) visit(from, to);
      from = to;
      is_open = !is_open;
    }
    if (is_open == in_region) visit(from, edge.b);
  }
  FaceView view_of(std::uint32_t triangle) const noexcept;
  FaceView view_of_front(std::uint32_t region_edge) const noexcept;

  const SlabSlice& contact_;
  KerfArrangement arrangement_;
  RingFiller filler_;
  std::uint64_t refusals_ = 0;

  // Frame points: the strip's, then the crossings', the hits', the upper and the lower corners'.
  std::vector<LatticeCorner> corners_;
  std::vector<std::uint32_t> named_;  // per strip point and made point its index in the result
  std::vector<std::uint32_t> upper_corner_, lower_corner_;
  std::uint32_t first_crossing_point_ = 0, first_hit_point_ = 0;

  std::vector<std::uint32_t> newest_hit_on_, next_hit_on_;  // hits of a strip triangle
  std::vector<std::uint32_t> hit_triangles_;                // that have any
  std::vector<FrontCut> cuts_;
  std::vector<std::uint32_t> newest_cut_of_;  // per region edge
  std::vector<CutEnd> cut_ends_;
  std::vector<Mark> starts_, ends_;
  std::vector<Piece> upper_pieces_, lower_pieces_, uprights_;
  std::vector<std::uint32_t> first_upper_, first_lower_, first_upright_;
  std::vector<Triangle> face_;
  SolidPatch made_;
  std::size_t static_points_ = 0;
};

}  // namespace hallux::simulator
