#include "simulator/loop/lent_results.h"

#include <algorithm>
#include <utility>

#include "simulator/base/check.h"

namespace hallux::simulator {

JobResult* LentResults::lend(std::unique_ptr<JobResult> result) {
  lent_.push_back(std::move(result));
  return lent_.back().get();
}

void LentResults::take_back(const JobResult* result) {
  const auto found = std::find_if(lent_.begin(), lent_.end(),
                                  [result](const auto& lent) { return lent.get() == result; });
  CHECK(found != lent_.end());
  for (FoundPiece& piece : (*found)->pieces) {
    if (piece.is_taken_out) taken_out_.push_back(std::move(piece.body));
  }
  lent_.erase(found);
}

}  // namespace hallux::simulator
