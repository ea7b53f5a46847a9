#include "tests/database/killed_child.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>
#include <utility>

namespace hallux::database {

bool say(int pipe, const ChildWord& word) noexcept {
  return ::write(pipe, &word, sizeof word) == static_cast<ssize_t>(sizeof word);
}

KilledChild::KilledChild(const std::vector<std::string>& arguments) {
  int ends[2];
  // Closed in every other child, or the end of this one would not be heard.
  if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error{"no pipe"};
  std::vector<std::string> words{HALLUX_KILL_COURSE};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  const int error =
      ::posix_spawn(&process_, HALLUX_KILL_COURSE, &actions, nullptr, pointers.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  pipe_ = ends[0];
  if (error != 0) throw std::runtime_error{"the program " HALLUX_KILL_COURSE " does not start"};
}

KilledChild::~KilledChild() {
  kill();
  wait();
  ::close(pipe_);
}

std::optional<ChildWord> KilledChild::listen() noexcept {
  ChildWord word;
  if (::read(pipe_, &word, sizeof word) != static_cast<ssize_t>(sizeof word)) return std::nullopt;
  return word;
}

void KilledChild::kill() noexcept {
  if (process_ > 0) ::kill(process_, SIGKILL);
}

std::optional<int> KilledChild::wait() noexcept {
  if (process_ <= 0) return std::nullopt;
  int status = 0;
  ::waitpid(std::exchange(process_, -1), &status, 0);
  if (!WIFEXITED(status)) return std::nullopt;
  return WEXITSTATUS(status);
}

}  // namespace hallux::database
