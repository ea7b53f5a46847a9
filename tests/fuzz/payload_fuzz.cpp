/// Feeds any bytes to the reader of payloads, as tape, samples and events: it must throw
/// DatabaseError, or give rows whose payload is these very bytes.
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "database/recording/columns.h"
#include "simulator/base/check.h"

namespace {

using namespace hallux;

template <typename Row>
void feed(std::span<const std::byte> payload, std::size_t column_count) {
  const std::size_t row_count = std::clamp<std::size_t>(payload.size() / column_count, 1, 1024);
  try {
    database::Columns columns{column_count, row_count};
    database::read_payload(payload, columns);
    std::vector<Row> rows;
    database::append_rows(columns, rows);
    std::vector<std::byte> buffer;
    const auto again =
        database::payload_in(buffer, database::columns_from(std::span<const Row>{rows}));
    CHECK(std::equal(again.begin(), again.end(), payload.begin(), payload.end()));
  } catch (const database::DatabaseError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  const auto payload = std::as_bytes(std::span{bytes, size}).subspan(1);
  if (bytes[0] % 3 == 0) feed<simulator::TapeLine>(payload, simulator::tape_columns);
  if (bytes[0] % 3 == 1) feed<simulator::ToolSample>(payload, simulator::sample_columns);
  if (bytes[0] % 3 == 2) feed<simulator::CutEvent>(payload, simulator::event_columns);
  return 0;
}
