/// An input tape in memory as it is stored, a tenth of its lines or less.
#pragma once

#include <cstddef>
#include <vector>

#include "database/recording/chunk_codec.h"
#include "simulator/record/tape_lines.h"

namespace hallux::database {

class PackedTape {
 public:
  /// The next window.
  /// needs   a chunk of a tape that was unpacked to rows before
  void add(std::vector<std::byte> bytes, const ChunkShape& shape);
  /// Unpacked window by window, each time they are visited; borrows this.
  /// errors  none beside what a visit throws
  /// thread  any, several at once
  simulator::TapeLines lines() const;

 private:
  struct Window {
    std::vector<std::byte> bytes;
    ChunkShape shape;
  };
  void visit(const simulator::TapeLines::Visit& visit) const;

  std::vector<Window> windows_;
  std::size_t line_count_ = 0;
};

}  // namespace hallux::database
