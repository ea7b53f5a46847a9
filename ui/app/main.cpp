/// The `hallux` command: understands the line, runs the verb, turns what is thrown into a sentence
/// and an exit code.
#include <malloc.h>

#include <csignal>
#include <cstdio>
#include <iostream>

#include "ui/app/command_line.h"

namespace {

/// So much free memory each thread's heap keeps at its end for what is asked for next; larger
/// blocks are the system's own, and go back to it when they are freed. Trees, meshes and fields of
/// some megabytes come and go all the time: given back at once, their pages would be cleared and
/// mapped anew each time, which takes as long as the work itself.
constexpr int kept_bytes = 32 << 20;

/// Of a verb that does its work and ends; a window gives more back (ui/app/window/open_window.cpp).
void keep_what_is_asked_for_again() {
  ::mallopt(M_MMAP_THRESHOLD, kept_bytes);
  ::mallopt(M_TRIM_THRESHOLD, kept_bytes);
}

}  // namespace

int main(int argc, char** argv) {
  keep_what_is_asked_for_again();
  // A closed pipe (hallux ... | head) is an error of writing, not a reason to die in the middle of
  // a transaction.
  std::signal(SIGPIPE, SIG_IGN);
  // A limit on the size of files then reads as a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  // What is read there are passwords: none may stay in a buffer that nobody wipes.
  std::setvbuf(stdin, nullptr, _IONBF, 0);
  return static_cast<int>(hallux::ui::run_command_line(argc, argv, std::cin, std::cout, std::cerr));
}
