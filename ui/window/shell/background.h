/// Work beside the window: nothing that takes longer than a frame runs in one.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace hallux::ui {

/// Handed to running work: where it says how far it is and hears that it should stop.
/// thread  the work's own
class WorkReport {
 public:
  /// Says how far it is, 0-1. Returns false where the person pressed Cancel: the work should end
  /// soon.
  bool reached(double share) noexcept {
    share_.store(share, std::memory_order_relaxed);
    return !is_cancelled_.load(std::memory_order_relaxed);
  }

 private:
  friend class Background;
  std::atomic<double> share_{0.0};
  std::atomic<bool> is_cancelled_{false}, is_done_{false};
};

/// How work ended.
enum class WorkEnd { Done, Cancelled, Failed };

class Background {
 public:
  using Work = std::function<void(WorkReport&)>;
  /// Told how it ended and, where it failed, the sentence of its exception.
  using Finish = std::function<void(WorkEnd end, const std::string& reason)>;

  /// `wake` is called from the work's thread when something changed that a frame should show.
  explicit Background(std::function<void()> wake = {});
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;
  /// Cancels what runs and waits for it; no Finish is called any more.
  ~Background();

  /// Starts `work` on a thread of its own; `finish` is called by collect(), on the thread of the
  /// window. Work without a label is not shown: nobody waits for it.
  void start(std::string label, Work work, Finish finish);
  /// Calls the finish of what ended since.
  /// thread  the window's
  void collect();

  struct Running {
    /// Of its controls, "work.3".
    std::string id;
    std::string label;
    double share = 0.0, elapsed_s = 0.0;
  };
  std::vector<Running> running() const;
  void cancel(const std::string& id);
  bool is_idle() const noexcept { return jobs_.empty(); }

 private:
  struct Job;
  std::function<void()> wake_;
  std::vector<std::unique_ptr<Job>> jobs_;
  int next_number_ = 0;
};

}  // namespace hallux::ui
