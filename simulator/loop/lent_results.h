/// Results of jobs while the step may need them. Inside this corner only.
#pragma once

#include <memory>
#include <vector>

#include "simulator/jobs/geometry_job.h"

namespace hallux::simulator {

/// thread  of the jobs
class LentResults {
 public:
  /// Keeps it until it comes back.
  JobResult* lend(std::unique_ptr<JobResult> result);
  /// Lets go of a result that the step gave back, but for the bodies that it marked as taken out:
  /// they are kept to the end.
  void take_back(const JobResult* result);
  std::size_t count() const noexcept { return lent_.size(); }

 private:
  std::vector<std::unique_ptr<JobResult>> lent_;
  std::vector<std::unique_ptr<const Bvh>> taken_out_;
};

}  // namespace hallux::simulator
