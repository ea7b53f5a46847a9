#include "simulator/record/drain.h"

namespace hallux::simulator {

namespace {

template <typename Row>
bool take_all(Ring<Row>& ring, std::vector<Row>& rows) {
  const std::size_t before = rows.size();
  for (Row row; ring.pop(row);) rows.push_back(row);
  return rows.size() > before;
}

}  // namespace

bool drain(AttemptChannels& channels, Recording& recording) {
  bool took_any = take_all(channels.tape, recording.tape);
  took_any = take_all(channels.events, recording.events) || took_any;
  return take_all(channels.samples, recording.samples) || took_any;
}

}  // namespace hallux::simulator
