/// A kerf: the plane a blade is frozen to, and the field of what it has covered there.
///
/// Kerf frame: origin and axes of the tool at the moment of freezing, said in the bone frame.
///
///     x: feed direction
///     y: along the tooth line
///     z: blade normal; the kerf is the slab |z| <= thickness / 2 over the opened region
///
/// The field holds at each node the greatest inside-distance to any blade that was there, limited
/// to +-1 node spacing: above zero means opened. `max` makes it monotone and independent of the
/// order and repetition of stamps. The limit is what makes a stamp cheap: nodes deep inside hold it
/// already and are skipped by their bits, so that a small motion costs the rim of the blade and not
/// its area. One spacing is enough for the outline: both nodes of an edge that a blade's side
/// crosses lie nearer to it than that.
///
/// Nodes have memory, in tiles of 32 x 32, where a blade has come by (TilePool).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "simulator/base/fixed_array.h"
#include "simulator/base/transform.h"
#include "simulator/cutting/field/line_cover.h"
#include "simulator/cutting/field/node_bits.h"
#include "simulator/cutting/field/tile_pool.h"
#include "simulator/tool/saw.h"

namespace hallux::simulator {

struct KerfPlane {
  RigidTransform bone_from_kerf;
  double thickness_mm = 0.5;
};

/// A blade in the kerf's plane: middle of the tooth line, and unit feed direction.
struct PlanarPose {
  Vec2 tip_mm{0.0, 0.0};
  Vec2 direction{1.0, 0.0};
};

/// The pose of the tool, projected to the kerf's plane.
PlanarPose planar_pose(const KerfPlane& plane, const RigidTransform& bone_from_tool) noexcept;

/// Nodes [first, last) in both directions; empty where first == last.
struct FieldWindow {
  std::int32_t u_first = 0, v_first = 0, u_last = 0, v_last = 0;

  bool is_empty() const noexcept { return u_first >= u_last || v_first >= v_last; }
};

/// The nodes of a field: node (i, j) lies at origin + spacing (i, j) in the kerf's plane.
struct FieldGrid {
  Vec2 origin_mm{-40.0, -40.0};
  double spacing_mm = 0.05;
  std::int32_t u_count = 1601, v_count = 1601;
};

class SweptBlade;

class KerfField {
 public:
  /// Takes all its memory here, tiles from a pool of its own; every node starts closed.
  explicit KerfField(const FieldGrid& grid);
  /// The same with tiles of a pool that fields share, borrowed for its lifetime.
  /// needs   the pool's closed tile holds closed_mm(grid); tiles_of(grid) of its tiles are for this
  ///         field
  KerfField(const FieldGrid& grid, TilePool& pool);
  /// With a pool of its own.
  KerfField(const KerfField& other);
  KerfField(KerfField&&) noexcept = default;
  KerfField& operator=(KerfField&&) noexcept = default;
  ~KerfField() = default;

  /// What a node holds that no blade came near [mm].
  static float closed_mm(const FieldGrid& grid) noexcept;
  /// Tiles for all nodes of a grid.
  static std::size_t tiles_of(const FieldGrid& grid) noexcept;

  const FieldGrid& grid() const noexcept { return grid_; }
  /// Inside-distance at a node [mm]; not above 0 where bone still stands.
  float at(std::int32_t u, std::int32_t v) const noexcept {
    return line_in_tile(tile_of(u, v), u)[place_in_line(v)];
  }
  /// Bilinear between nodes; closed outside the grid.
  bool is_open(const Vec2& point_mm) const noexcept;

  /// Raises the field to the inside-distance of the blade's rectangle (x in [-depth, 0], y within
  /// +-width/2 of the tool frame) on its way from `from` to `to`: the hull of the two.
  /// shape   `changed` becomes the smallest window that holds every node that rose
  /// needs   blade sizes above zero, directions of unit length
  /// ensures the field never falls; order and repetition of stamps do not matter, bit for bit; a
  ///         straight motion in parts raises the field as the whole does, but for rounding
  /// errors  none: total, allocates nothing; what lies outside the grid is not opened, poses that
  ///         are not finite open nothing
  /// thread  haptic (and, on its own copy, jobs)
  /// source  docs/cutting.md; thesis 4.4.2
  void stamp(const Blade& blade, const PlanarPose& from, const PlanarPose& to,
             FieldWindow& changed) noexcept;

  /// Puts kept values at the nodes of a window, line by line, whatever stood there; limited to what
  /// a field holds, and closed where a value is no number.
  /// shape   one value for each node of the window
  /// needs   a window within the grid
  /// ensures the field is as if stamps had made it, but for the time the next stamp takes
  void put(const FieldWindow& window, std::span<const float> inside_mm) noexcept;

  // For those who follow the outline. Cell (i, j) lies between nodes (i - 1, j - 1) and (i, j): the
  // first and the last cells reach beyond the grid. Tile (I, J) holds the 32 x 32 cells from (32 I,
  // 32 J) on.
  static constexpr std::int32_t tile_cells = TilePool::nodes_on_a_side;
  static constexpr std::int32_t tiles_over(std::int32_t node_count) noexcept {
    return node_count / tile_cells + 1;
  }
  /// Per tile, J running fastest: differs from an earlier answer where a node of the tile's cells
  /// changed since.
  const std::vector<std::uint32_t>& tile_revisions() const noexcept { return tile_revisions_; }
  /// One bit a node: open.
  const NodeBits& open_nodes() const noexcept { return open_; }

 private:
  struct Rim;
  struct Corners {
    float here, next_u, next_v, next_both;
  };
  Corners corners_from(std::int32_t u, std::int32_t v) const noexcept;

  KerfField(const FieldGrid& grid, std::unique_ptr<TilePool> own);
  // Tile (I, J) of nodes holds those from (32 I, 32 J) on: the far corners of that tile's cells.
  std::size_t tile_of(std::int32_t u, std::int32_t v) const noexcept {
    return static_cast<std::size_t>(static_cast<std::uint32_t>(u) / tile_cells) *
               static_cast<std::size_t>(tile_rows_) +
           static_cast<std::uint32_t>(v) / tile_cells;
  }
  static std::size_t line_place(std::int32_t u) noexcept {
    return static_cast<std::size_t>(static_cast<std::uint32_t>(u) % tile_cells) * tile_cells;
  }
  static std::size_t place_in_line(std::int32_t v) noexcept {
    return static_cast<std::uint32_t>(v) % tile_cells;
  }
  float* line_in_tile(std::size_t tile, std::int32_t u) const noexcept {
    return tiles_[tile] + line_place(u);
  }
  const float* closed_line(std::int32_t u) const noexcept {
    return pool_->closed_tile() + line_place(u);
  }
  float* writable_line(std::size_t tile, std::int32_t u) noexcept {
    if (tiles_[tile] == pool_->closed_tile()) tiles_[tile] = pool_->take();
    return line_in_tile(tile, u);
  }
  void stamp_line(const SweptBlade& swept, std::int32_t u, FieldWindow& changed) noexcept;
  bool put_node(std::int32_t u, std::int32_t v, float wanted_mm) noexcept;
  NodeSpan raise_rim(const Rim& rim) noexcept;
  NodeSpan fill_deep(std::int32_t u, const NodeSpan& deep) noexcept;
  void fill(std::int32_t u, const NodeSpan& nodes) noexcept;
  void note_risen(std::int32_t u, const NodeSpan& risen, FieldWindow& changed) noexcept;

  // Lines are nodes of one u: a saw feeds along u, so its long sides run across the lines, where a
  // stamp costs two or three nodes each, and only its teeth run along them.
  FieldGrid grid_;
  /// Stored values lie within +-limit.
  float limit_mm_;
  std::int32_t tile_rows_;
  /// None where the pool is another's.
  std::unique_ptr<TilePool> own_pool_;
  TilePool* pool_;
  /// Per tile, J running fastest: its nodes, line by line; where none ever rose the pool's closed
  /// tile.
  std::vector<float*> tiles_;
  /// Nodes that hold the limit.
  NodeBits deep_;
  /// Nodes above zero.
  NodeBits open_;
  /// Per line.
  ZeroedArray<KeptCover> covers_;
  std::vector<std::uint32_t> tile_revisions_;
  std::uint32_t revision_ = 0;
};

}  // namespace hallux::simulator
