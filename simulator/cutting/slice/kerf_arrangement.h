/// How a region's outline and a contact's strip lie in each other: every crossing, winding and
/// containment, asked once on the exact lattice. What is built from it needs no further decision
/// about places. Inside this room only.
///
/// A strip edge is crossed by region edges alternately inward and outward; a region's edge enters
/// and leaves the bone's section on either plane; the upright line in a region's corner passes
/// through strip triangles. Entries and exits are counted with signs and paired in order, so that
/// all that is built closes even where rounding has exchanged two neighbours along a line.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "simulator/cutting/field/region_outline.h"
#include "simulator/cutting/slice/slab_slice.h"
#include "simulator/cutting/slice/strip_search.h"

namespace hallux::simulator {

/// A corner of the region's outline; region edge i runs from corner i to corner i.next, the region
/// on its left.
struct RegionCorner {
  LatticePoint place;
  Vec2 place_mm{0.0, 0.0};
  std::uint32_t next = 0, before = 0;
  std::int32_t windings_above = 0,
               /// Of the bone's section on the upper, lower plane.
      windings_below = 0;
};

/// Where a strip edge and a region edge cross.
struct StripCrossing {
  std::uint32_t strip_edge = 0, region_edge = 0;
  /// Along the strip edge from a to b.
  double strip_share = 0.0;
  /// Along the region edge.
  double region_share = 0.0;
  /// +1: the strip edge goes into the region here, -1: out of it.
  std::int8_t entry = 1;
};

/// Where the upright line in a region's corner passes through a strip triangle.
struct CornerHit {
  std::uint32_t corner = 0, triangle = 0;
  /// Of the triangle's points; they add up to 1.
  std::array<double, 3> weights{};
};

class KerfArrangement {
 public:
  /// Borrows the contact.
  explicit KerfArrangement(const SlabSlice& contact);

  /// Takes up a region.
  /// ensures false where the outline winds around a point of the strip more than once, or the strip
  ///         itself is not closed: then nothing may be built from it
  /// thread  worker or geometry; allocates nothing once it has seen as large a region
  bool arrange(const RegionOutline& region);

  const SlabSlice& contact() const noexcept { return contact_; }
  std::span<const RegionCorner> corners() const noexcept { return corners_; }
  /// Ascending by region edge.
  std::span<const StripCrossing> crossings() const noexcept { return crossings_; }
  /// Ascending by corner.
  std::span<const CornerHit> hits() const noexcept { return hits_; }
  /// The crossings on a strip edge from a to b, alternately in and out; the first one is an entry
  /// where a is not open.
  std::span<const std::uint32_t> chain(std::uint32_t strip_edge) const noexcept {
    const Chain& chain = chains_[strip_edge];
    return {chained_.data() + chain.first, chain.count};
  }
  /// Whether the region takes this strip point away.
  bool is_open(std::uint32_t strip_point) const noexcept { return is_open_[strip_point] != 0; }
  /// Whether the region reaches this skin at all.
  bool is_reached(std::uint32_t skin) const noexcept { return is_reached_[skin] != 0; }
  /// Whether some skin is reached and each that is reached is taken wholly, with all that it
  /// encloses.
  bool takes_section() const noexcept;

 private:
  struct Chain {
    std::uint32_t first = 0, count = 0;
  };

  void take_region(const RegionOutline& region);
  void add_loop(std::span<const Vec2> loop_mm);
  void find_crossings();
  void try_crossing(std::uint32_t strip_edge, std::uint32_t region_edge);
  bool open_points();
  bool order_chains();
  bool order_chain(std::uint32_t strip_edge);
  void find_hits();
  void try_hit(std::uint32_t corner, std::uint32_t triangle);
  bool wind_corners();
  void wind_first(RegionCorner& corner) const;
  std::array<std::int32_t, 2> windings_behind(std::uint32_t region_edge) const;
  void mark_reached();
  std::int32_t winding_around(const LatticePoint& bone) const noexcept;

  const SlabSlice& contact_;
  StripSearch search_;
  std::vector<RegionCorner> corners_;
  std::vector<std::uint32_t> loop_starts_;
  std::vector<StripCrossing> crossings_;
  std::vector<CornerHit> hits_;
  std::vector<std::uint32_t> first_crossing_;  // per region edge, and one behind the last
  std::vector<std::uint32_t> asked_by_;        // per strip edge: the region edge that asked last
  std::vector<std::uint32_t> newest_on_;   // per strip edge: a crossing, and from there by next_on_
  std::vector<std::uint32_t> next_on_;     // per crossing
  std::vector<std::int32_t> net_entries_;  // per strip edge
  std::vector<std::uint32_t> crossed_;     // strip edges with crossings
  std::vector<Chain> chains_;
  std::vector<std::uint32_t> chained_, entries_, exits_;
  std::vector<std::uint8_t> is_open_, is_reached_;
};

}  // namespace hallux::simulator
