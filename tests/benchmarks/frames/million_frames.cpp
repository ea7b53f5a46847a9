// A million random frames, each checked as in tests/simulator/cutting/frames/kerf_frames_test.cpp:
// none open, none refused, all in balance. Worlds are independent, so every core plays its own;
// what they were is printed, faults end with an exit code.
#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include "tests/simulator/cutting/frames/frame_count.h"

namespace hallux::benchmarks {

namespace {

using tests::FrameCount;

struct Request {
  std::uint64_t frames = 1'000'000;
  std::uint64_t seed = 1;
  bool is_single_world = false;  ///< the seed is a world's, as a fault names it
  bool is_understood = true;
};

bool read_number(std::string_view text, std::uint64_t& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

Request request_from(int count, char** words) {
  Request request;
  for (int i = 1; i < count && request.is_understood; i += 2) {
    const std::string_view option = words[i];
    request.is_single_world = request.is_single_world || option == "--world";
    std::uint64_t& number = option == "--frames" ? request.frames : request.seed;
    request.is_understood = (option == "--frames" || option == "--seed" || option == "--world") &&
                            i + 1 < count && read_number(words[i + 1], number);
  }
  return request;
}

/// The worlds `first`, `first + stride`, ... of the seed, until the share of the frames is played.
void play_share(const Request& request, std::uint64_t first, std::uint64_t stride,
                FrameCount& count) {
  for (std::uint64_t world = first; count.frames < request.frames / stride; world += stride) {
    tests::count_world(Random(request.seed + world).bits(), count);
  }
}

FrameCount sum_of(const std::vector<FrameCount>& shares) {
  FrameCount sum;
  for (const FrameCount& share : shares) {
    sum.frames += share.frames;
    sum.intersected += share.intersected;
    sum.partial += share.partial;
    sum.severed += share.severed;
    sum.nested += share.nested;
    sum.commits += share.commits;
    sum.faults.insert(sum.faults.end(), share.faults.begin(), share.faults.end());
  }
  return sum;
}

FrameCount play(const Request& request) {
  std::vector<FrameCount> shares(std::max(1U, std::thread::hardware_concurrency()));
  {
    std::vector<std::jthread> players;
    for (std::size_t i = 0; i < shares.size(); ++i) {
      players.emplace_back([&, i] { play_share(request, i, shares.size(), shares[i]); });
    }
  }
  return sum_of(shares);
}

int run(const Request& request) {
  const auto start = std::chrono::steady_clock::now();
  FrameCount count;
  if (request.is_single_world) {
    tests::count_world(request.seed, count);
  } else {
    count = play(request);
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  std::printf("%s; seed %llu, %.0f s\n", tests::sentence_of(count).c_str(),
              static_cast<unsigned long long>(request.seed), elapsed.count());
  // One world is too few for shares.
  const std::vector<std::string> found =
      request.is_single_world ? count.faults : tests::complaints(count);
  for (const std::string& complaint : found) std::fprintf(stderr, "%s\n", complaint.c_str());
  return found.empty() ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace

}  // namespace hallux::benchmarks

int main(int count, char** words) {
  const hallux::benchmarks::Request request = hallux::benchmarks::request_from(count, words);
  if (!request.is_understood || request.frames == 0) {
    std::fputs("usage: million_frames [--frames N] [--seed S | --world S]\n", stderr);
    return 2;
  }
  return hallux::benchmarks::run(request);
}
