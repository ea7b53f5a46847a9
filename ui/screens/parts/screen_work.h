/// Work that a screen starts and may leave behind.
///
/// Where the screen goes before the work ends, it ends unheard. The work runs on a thread of its
/// own and may outlive the screen: it holds copies and the session, never the screen or anything of
/// it.
#pragma once

#include <memory>
#include <string>

#include "ui/window/shell/shell.h"

namespace hallux::ui {

class ScreenWork {
 public:
  ScreenWork() : tie_(std::make_shared<Tie>()) {}
  ScreenWork(const ScreenWork&) = delete;
  ScreenWork& operator=(const ScreenWork&) = delete;
  ~ScreenWork() { tie_->is_cut = true; }

  /// `finish` is called in a frame, while the screen is there.
  /// thread  the window's
  void start(Shell& shell, std::string label, Background::Work work, Background::Finish finish) {
    ++tie_->running;
    shell.background().start(
        std::move(label), std::move(work),
        [tie = tie_, heard = std::move(finish)](WorkEnd end, const std::string& reason) {
          --tie->running;
          if (!tie->is_cut) heard(end, reason);
        });
  }
  bool is_running() const noexcept { return tie_->running > 0; }

 private:
  struct Tie {
    int running = 0;
    bool is_cut = false;
  };
  std::shared_ptr<Tie> tie_;
};

}  // namespace hallux::ui
