/// The `hallux` command: understands the line, runs the verb, turns what is thrown into a sentence
/// and an exit code.
#include <malloc.h>

#include <csignal>
#include <cstdio>
#include <iostream>

#include "ui/app/command_line.h"

namespace {

/// Blocks from this size on are the system's own, and go back to it when they are freed.
constexpr int large_block_bytes = 1 << 17;
/// So much free memory a heap keeps at its end for what is asked for next.
constexpr int kept_bytes = 8 << 20;

/// The C library otherwise raises the first limit to the largest block that was ever freed, 32 MiB
/// at most: each thread's heap then keeps the pages of trees and meshes that are gone.
void give_large_blocks_back() {
  ::mallopt(M_MMAP_THRESHOLD, large_block_bytes);
  ::mallopt(M_TRIM_THRESHOLD, kept_bytes);
}

}  // namespace

int main(int argc, char** argv) {
  give_large_blocks_back();
  // A closed pipe (hallux ... | head) is an error of writing, not a reason to die in the middle of
  // a transaction.
  std::signal(SIGPIPE, SIG_IGN);
  // A limit on the size of files then reads as a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  // What is read there are passwords: none may stay in a buffer that nobody wipes.
  std::setvbuf(stdin, nullptr, _IONBF, 0);
  return static_cast<int>(hallux::ui::run_command_line(argc, argv, std::cin, std::cout, std::cerr));
}
