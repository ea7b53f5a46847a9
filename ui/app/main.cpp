/// The `hallux` command: understands the line, runs the verb, turns what is thrown into a sentence
/// and an exit code.
#include <csignal>
#include <cstdio>
#include <iostream>

#include "ui/app/command_line.h"
#include "ui/app/terminal/freed_memory.h"

int main(int argc, char** argv) {
  hallux::ui::keep_freed_memory();
  // A closed pipe (hallux ... | head) is an error of writing, not a reason to die in the middle of
  // a transaction.
  std::signal(SIGPIPE, SIG_IGN);
  // A limit on the size of files then reads as a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  // What is read there are passwords: none may stay in a buffer that nobody wipes.
  std::setvbuf(stdin, nullptr, _IONBF, 0);
  return static_cast<int>(hallux::ui::run_command_line(argc, argv, std::cin, std::cout, std::cerr));
}
