/// The record as a table would hold it: a row for each line of the tape, each sample and each
/// event. What chunks are compared with, made as well as such a table can be: typed columns, no
/// index beside the key, one prepared statement a table, WAL, a transaction each half second, the
/// settings that the recorder has.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "simulator/record/record.h"

namespace hallux::benchmarks {

class RowsStore {
 public:
  /// Makes a new database file.
  explicit RowsStore(const std::filesystem::path& file);
  ~RowsStore();
  RowsStore(const RowsStore&) = delete;
  RowsStore& operator=(const RowsStore&) = delete;

  void write(const simulator::Recording& recording);
  simulator::Recording read();
  /// The rows of those ticks, from `first` up to and not with `end`.
  simulator::Recording read(std::int64_t first, std::int64_t end);
  /// Of the file, once all of its log is in it.
  std::int64_t bytes();

 private:
  struct Tables;
  std::filesystem::path file_;
  std::unique_ptr<Tables> tables_;
};

}  // namespace hallux::benchmarks
