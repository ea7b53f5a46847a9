#include "simulator/record/tape_lines.h"

#include <algorithm>

namespace hallux::simulator {

TapeLines tape_of(const Recording& recording) {
  const std::vector<TapeLine>& tape = recording.tape;
  return {tape.size(),
          [&tape](const TapeLines::Visit& visit) { std::ranges::for_each(tape, visit); }};
}

}  // namespace hallux::simulator
