#include "database/recording/packed_tape.h"

#include <algorithm>
#include <utility>

namespace hallux::database {

void PackedTape::add(std::vector<std::byte> bytes, const ChunkShape& shape) {
  line_count_ += shape.row_count;
  windows_.push_back({std::move(bytes), shape});
}

simulator::TapeLines PackedTape::lines() const {
  return {line_count_, [this](const simulator::TapeLines::Visit& each) { visit(each); }};
}

void PackedTape::visit(const simulator::TapeLines::Visit& visit) const {
  ChunkUnpacker unpacker;
  Columns columns;
  std::vector<simulator::TapeLine> lines;
  for (const Window& window : windows_) {
    unpacker.unpack(window.bytes, window.shape, nullptr, columns);
    lines.clear();
    append_rows(columns, lines);
    std::ranges::for_each(lines, visit);
  }
}

}  // namespace hallux::database
