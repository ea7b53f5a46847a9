/// Half the work of reading is in the tapes, and the samples of a window are told by its tape: so a
/// thread of its own unpacks tapes ahead, and the reader unpacks the rest and checks all links in
/// the order of the chain. The first damaged chunk is named whichever thread met it.
#include "database/recording/chunk_run.h"

#include <algorithm>
#include <array>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace hallux::database {

namespace {

/// How far tapes are unpacked ahead of the rest. A run of no more windows is not worth a thread: it
/// takes a millisecond.
constexpr std::size_t windows_ahead = 8;

bool is_tape(const StoredChunk& chunk) noexcept { return chunk.place.stream == Stream::Tape; }

void reserve_for(std::span<const StoredChunk> chunks, RecordingPart part,
                 simulator::Recording& recording) {
  std::array<std::size_t, 3> rows{};
  for (const StoredChunk& chunk : chunks) {
    // A false count takes no more memory than a true one may.
    const auto count = static_cast<std::size_t>(std::clamp<std::int64_t>(
        chunk.place.row_count, 0, static_cast<std::int64_t>(chunk.bytes.size()) * 64));
    rows[static_cast<std::size_t>(chunk.place.stream)] += count;
  }
  if (part == RecordingPart::Whole) recording.tape.reserve(recording.tape.size() + rows[0]);
  recording.samples.reserve(recording.samples.size() + rows[1]);
  recording.events.reserve(recording.events.size() + rows[2]);
}

/// Unpacks the tapes of a run and appends their lines, ahead of whoever asks for them. Half of the
/// work of reading is in the tapes, and the samples of a window are told by its tape: so those of a
/// long run have a thread of their own.
class TapesAhead {
 public:
  /// lines   null where they are not kept
  /// needs   both outlive it; nobody else looks at `lines` meanwhile
  TapesAhead(std::span<const StoredChunk> chunks, std::vector<simulator::TapeLine>* lines)
      : chunks_(chunks), lines_(lines) {
    if (std::ranges::count_if(chunks, is_tape) <= static_cast<std::ptrdiff_t>(windows_ahead)) {
      read_all({});
    } else {
      thread_ = std::jthread{[this](const std::stop_token& stop) { read_all(stop); }};
    }
  }

  /// The next tape of the run, its link not checked; valid until the next call.
  /// needs   there is one
  /// errors  DatabaseError Damaged
  const Columns& next() {
    std::unique_lock lock{mutex_};
    given_back_ = asked_;
    if (read_ - given_back_ <= windows_ahead / 2) changed_.notify_one();
    changed_.wait(lock, [this] { return read_ > asked_; });
    const Place& place = places_[asked_++ % windows_ahead];
    if (!place.fault.empty()) fail_damaged(place.fault.c_str());
    return place.columns;
  }

 private:
  struct Place {
    Columns columns;
    std::string fault;  ///< why there are none
  };

  void read_all(const std::stop_token& stop) {
    for (const StoredChunk& chunk : chunks_) {
      if (!is_tape(chunk)) continue;
      if (!wait_for_room(stop)) return;
      Place& place = places_[read_ % windows_ahead];
      read(chunk, place);
      const bool is_last = !place.fault.empty();
      {
        const std::lock_guard lock{mutex_};
        ++read_;
      }
      changed_.notify_one();
      if (is_last) return;
    }
  }
  /// Once all places are taken, half of them must be free: else each tape would wake the thread.
  bool wait_for_room(const std::stop_token& stop) {
    std::unique_lock lock{mutex_};
    if (read_ - given_back_ < windows_ahead) return !stop.stop_requested();
    return changed_.wait(lock, stop, [this] { return read_ - given_back_ <= windows_ahead / 2; });
  }
  void read(const StoredChunk& chunk, Place& place) {
    try {
      unpacker_.unpack(chunk.bytes, shape_of(chunk), nullptr, place.columns);
      // That rows can be made of it is a part of the check.
      passed_.clear();
      append_rows(place.columns, lines_ != nullptr ? *lines_ : passed_);
    } catch (const std::exception& error) {
      place.fault = error.what();
    }
  }

  std::span<const StoredChunk> chunks_;
  std::vector<simulator::TapeLine>* lines_;
  std::vector<simulator::TapeLine> passed_;  ///< of one chunk
  ChunkUnpacker unpacker_;
  std::array<Place, windows_ahead> places_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::size_t read_ = 0, asked_ = 0, given_back_ = 0;  ///< tapes
  std::jthread thread_;                                ///< last: it is over before the others go
};

/// Reads a run in the order of its chain.
class RunReader {
 public:
  RunReader(const AttemptId& id, const ChunkRun& run, RecordingPart part,
            simulator::Recording& recording)
      : run_(run),
        recording_(recording),
        reader_(id),
        tapes_(run.chunks, part == RecordingPart::Whole ? &recording.tape : nullptr) {}

  /// errors  DatabaseError Damaged
  void read(std::size_t index) {
    const StoredChunk& chunk = run_.chunks[index];
    std::optional<Digest> before = run_.before;
    if (index > 0) before = run_.chunks[index - 1].link;
    if (!before) fail_damaged("the link before it is none");
    if (is_tape(chunk)) {
      tape_ = &tapes_.next();
      tape_window_ = chunk.place.seq;
      reader_.check(chunk, *tape_, *before);
    } else if (chunk.place.stream == Stream::Sample) {
      const Columns* tape = tape_window_ == chunk.place.seq ? tape_ : nullptr;
      append_rows(reader_.read_checked(chunk, tape, *before), recording_.samples);
    } else {
      append_rows(reader_.read_checked(chunk, nullptr, *before), recording_.events);
    }
  }

 private:
  const ChunkRun& run_;
  simulator::Recording& recording_;
  ChunkReader reader_;
  TapesAhead tapes_;
  const Columns* tape_ = nullptr;  ///< the last one
  std::optional<std::int64_t> tape_window_;
};

}  // namespace

void append_run(const Database& database, const AttemptId& id, const ChunkRun& run,
                RecordingPart part, simulator::Recording& recording) {
  reserve_for(run.chunks, part, recording);
  RunReader reader{id, run, part, recording};
  for (std::size_t i = 0; i < run.chunks.size(); ++i) {
    try {
      reader.read(i);
    } catch (const std::exception& error) {
      fail_chunk(database, id, run.chunks[i], error.what());
    }
  }
}

}  // namespace hallux::database
