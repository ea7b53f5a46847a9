/// Recorder of a running attempt: one thread drains the rings and commits each half-second window.
///
///   ring tape    -> |  window of 500 ticks: up to three chunks  |
///   ring samples -> |  (tape, samples, events), linked in this  | -> one IMMEDIATE transaction,
///   ring events  -> |  order to the chain                       |    synchronous FULL
///
/// What was on the screen comes from the window's thread, late by a frame and in no window: it is
/// committed with the window that is next. Of a full disk no more waits than a ring holds.
///
/// Windows are cut by ticks, not by the clock: the same recording gives the same chunks whatever
/// the scheduling. A line of the tape belongs to the window of its last tick, so that what is kept
/// of a lost attempt is whole: no line without its sample. A window is committed once a later tick
/// was seen in an earlier pass, because then every row of it was pushed. Killing the process loses
/// the window being filled and what waits for the next pass (10 ms), never a committed one.
/// source  docs/data_format.md
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "database/store/connection.h"
#include "database/store/writer_lease.h"
#include "simulator/record/channels.h"

namespace hallux::database {

inline constexpr std::int64_t window_ticks = 500;

struct RecorderStatistics {
  /// Of packed chunks.
  std::int64_t bytes = 0;
  std::int64_t chunks = 0;
  /// Of the three streams together.
  std::int64_t rows = 0;
  std::int64_t samples = 0;
  std::int64_t display_facts = 0;
  std::int64_t commits = 0;
  /// Places where the tape leaves ticks out.
  std::int64_t gaps = 0;
  /// Lines of the tape for ticks that one before covers.
  std::int64_t duplicates = 0;
  /// Of the recorder's thread, commits included.
  double cpu_s = 0.0;
  /// Time spent committing, wall clock.
  double commit_s = 0.0;
  /// The longest.
  double commit_max_s = 0.0;
};

/// What a recorder does where the disk is full.
enum class FullDisk {
  /// As with any other failure: for an attempt that nobody watches.
  Fails,
  /// Keeps what is not committed, says so in channels.storage_full, tries again until there is
  /// room.
  IsWaitedFor
};

/// thread  made, drained and finished by one; writes on a thread of its own
class Recorder {
 public:
  /// Starts the thread with its own connection to the file of `database`.
  /// needs   `channels` outlives the recorder; nobody else pops from them
  /// errors  DatabaseError where the second connection cannot be opened
  Recorder(const Database& database, WriterLease lease, simulator::AttemptChannels& channels,
           FullDisk full_disk = FullDisk::Fails);
  /// Stops without sealing: what was drained is committed, the attempt is found interrupted at the
  /// next opening.
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  const AttemptId& attempt() const noexcept;

  /// Waits until the producer has set channels.closed and all it pushed is committed; for room on a
  /// full disk, where that is waited for, until channels.gives_up.
  /// errors  DatabaseError: why channels.recorder_failed was set; what was committed before stays
  /// thread  the one that made the recorder
  RecorderStatistics drain();

  /// Drains, then closes and seals the attempt with its quality (a JSON text), and brings SQLite's
  /// log into the file.
  /// errors  DatabaseError
  /// thread  the one that made the recorder
  RecorderStatistics finish(const std::string& quality_json);

  /// Drains, then marks the attempt as interrupted, with an act: its person gave it up.
  /// errors  DatabaseError; the next opening marks it then, without the act
  /// thread  the one that made the recorder
  RecorderStatistics abandon();

 private:
  class Writer;
  std::unique_ptr<Writer> writer_;
};

}  // namespace hallux::database
