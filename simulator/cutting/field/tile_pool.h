/// Memory of kerf fields: tiles of 32 x 32 nodes, each handed out once. Inside this corner only.
///
///     addresses for every tile that there can be, taken at the start
///     |  handed out  |  ready: filled, waiting  |  never touched: no memory behind it  |
///
/// A field takes a tile where a blade first comes by, so that memory follows what is opened, not
/// how large the grids are. There are as many tiles as all nodes need: none is ever missing, and no
/// stamp depends on how many there are. What is touched for the first time makes the system look
/// for memory; who must not wait for that has tiles made ready ahead.
#pragma once

#include <cstddef>
#include <cstdint>

namespace hallux::simulator {

class TilePool {
 public:
  static constexpr std::int32_t nodes_on_a_side = 32;
  static constexpr std::size_t nodes_per_tile =
      static_cast<std::size_t>(nodes_on_a_side) * nodes_on_a_side;

  /// Takes addresses for so many tiles of closed nodes.
  /// errors  std::bad_alloc
  TilePool(std::size_t tile_count, float closed_mm);
  ~TilePool();
  TilePool(const TilePool&) = delete;
  TilePool& operator=(const TilePool&) = delete;

  /// A tile of closed nodes for all that was never opened; nobody may write to it.
  float* closed_tile() const noexcept { return tiles_; }
  /// The next tile, all nodes closed, line by line; it lives as long as the pool.
  /// needs   fewer were taken than there are
  float* take() noexcept;
  /// Makes tiles ready until `ahead` of them wait, at most `at_once`.
  void make_ready(std::size_t ahead, std::size_t at_once) noexcept;

  std::size_t taken_count() const noexcept { return taken_count_; }
  /// Tiles that have memory: taken or ready.
  std::size_t touched_count() const noexcept { return touched_count_; }

 private:
  void touch_next() noexcept;
  float* tile(std::size_t place) noexcept { return tiles_ + place * nodes_per_tile; }

  void* memory_;
  /// The first is the closed one.
  float* tiles_;
  std::size_t tile_count_;
  float closed_mm_;
  std::size_t taken_count_ = 0, touched_count_ = 0;
};

}  // namespace hallux::simulator
