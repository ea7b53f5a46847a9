#include "ui/window/shell/background.h"

#include <chrono>
#include <exception>
#include <utility>

namespace hallux::ui {

struct Background::Job {
  std::string id, label;
  Finish finish;
  WorkReport report;
  std::string failure;  ///< written by the work's thread before is_done_
  bool has_failed = false;
  std::chrono::steady_clock::time_point started = std::chrono::steady_clock::now();
  std::jthread thread;  ///< last: ends before what it uses
};

Background::Background(std::function<void()> wake) : wake_(std::move(wake)) {}

Background::~Background() {
  for (const auto& job : jobs_) job->report.is_cancelled_.store(true);
}

void Background::start(std::string label, Work work, Finish finish) {
  auto job = std::make_unique<Job>();
  job->id = "work." + std::to_string(next_number_++);
  job->label = std::move(label);
  job->finish = std::move(finish);
  Job* own = job.get();
  job->thread = std::jthread([own, run = std::move(work), wake = wake_] {
    try {
      run(own->report);
    } catch (const std::exception& fault) {
      own->has_failed = true;
      own->failure = fault.what();
    }
    own->report.is_done_.store(true, std::memory_order_release);
    if (wake) wake();
  });
  jobs_.push_back(std::move(job));
}

void Background::collect() {
  std::vector<std::unique_ptr<Job>> ended;
  for (auto& job : jobs_)
    if (job->report.is_done_.load(std::memory_order_acquire)) ended.push_back(std::move(job));
  std::erase(jobs_, nullptr);
  // A finish may start new work: the list is settled by then.
  for (const auto& job : ended) {
    job->thread.join();
    const WorkEnd end = job->report.is_cancelled_.load() ? WorkEnd::Cancelled
                        : job->has_failed                ? WorkEnd::Failed
                                                         : WorkEnd::Done;
    if (job->finish) job->finish(end, job->failure);
  }
}

std::vector<Background::Running> Background::running() const {
  std::vector<Running> result;
  for (const auto& job : jobs_) {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - job->started;
    result.push_back(
        {job->id, job->label, job->report.share_.load(std::memory_order_relaxed), elapsed.count()});
  }
  return result;
}

void Background::cancel(const std::string& id) {
  for (const auto& job : jobs_)
    if (job->id == id) job->report.is_cancelled_.store(true);
}

}  // namespace hallux::ui
