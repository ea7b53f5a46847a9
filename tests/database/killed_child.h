/// The program kill_course as a child that is killed: what it says of its work comes through a
/// pipe.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace hallux::database {

/// One line of the pipe; written whole or not at all.
struct ChildWord {
  enum class Kind : std::int32_t {
    /// Value: what is already there.
    Began,
    /// Value: ticks that the producer has handed over.
    Pushed,
    /// Value: windows or writes that are committed.
    Acknowledged,
    /// Value: the longest that one write took [us].
    Waited,
    /// The reason stands on stderr.
    Failed
  };
  Kind kind = Kind::Began;
  std::int32_t value = 0;
};

/// Says it through `pipe`; false where nobody listens any more.
bool say(int pipe, const ChildWord& word) noexcept;

class KilledChild {
 public:
  /// Starts the program with these arguments; its standard output is the pipe.
  explicit KilledChild(const std::vector<std::string>& arguments);
  /// Kills it where it still lives.
  ~KilledChild();
  KilledChild(const KilledChild&) = delete;
  KilledChild& operator=(const KilledChild&) = delete;

  /// Waits for the next word; nothing where the child has ended and said all.
  std::optional<ChildWord> listen() noexcept;
  /// kill -9. What it said before can still be heard.
  void kill() noexcept;
  /// Waits for its end; the exit status, or nothing where a signal ended it.
  std::optional<int> wait() noexcept;

 private:
  pid_t process_ = -1;
  int pipe_ = -1;
};

}  // namespace hallux::database
