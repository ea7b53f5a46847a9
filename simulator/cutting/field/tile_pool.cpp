#include "simulator/cutting/field/tile_pool.h"

#include <algorithm>
#include <memory>

#include "simulator/base/check.h"
#include "simulator/base/fixed_array.h"

namespace hallux::simulator {

namespace {

/// Of a cache: a line of a tile then lies in two of them.
constexpr std::size_t line_bytes = 64;
constexpr std::size_t tile_bytes = TilePool::nodes_per_tile * sizeof(float);

constexpr std::size_t bytes_for(std::size_t tile_count) {
  return (tile_count + 1) * tile_bytes + line_bytes;
}

float* aligned(void* memory, std::size_t bytes) noexcept {
  return static_cast<float*>(std::align(line_bytes, bytes - line_bytes, memory, bytes));
}

}  // namespace

TilePool::TilePool(std::size_t tile_count, float closed_mm)
    : memory_(take_memory(bytes_for(tile_count))),
      tiles_(aligned(memory_, bytes_for(tile_count))),
      tile_count_(tile_count),
      closed_mm_(closed_mm) {
  std::fill_n(tiles_, nodes_per_tile, closed_mm_);
}

TilePool::~TilePool() { free_memory(memory_); }

float* TilePool::take() noexcept {
  CHECK(taken_count_ < tile_count_);
  if (touched_count_ == taken_count_) touch_next();
  return tile(++taken_count_);
}

void TilePool::make_ready(std::size_t ahead, std::size_t at_once) noexcept {
  const std::size_t wanted = std::min(taken_count_ + ahead, tile_count_);
  for (std::size_t made = 0; made < at_once && touched_count_ < wanted; ++made) touch_next();
}

void TilePool::touch_next() noexcept {
  std::fill_n(tile(++touched_count_), nodes_per_tile, closed_mm_);
}

}  // namespace hallux::simulator
