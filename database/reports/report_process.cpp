#include "database/reports/report_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sqlite3.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "simulator/base/progress.h"

namespace hallux::database {

namespace {

/// SQLite's, of one statement with all that it sorts and joins.
constexpr std::int64_t heap_bytes_max = std::int64_t{192} << 20U;
/// Beyond its time the child may take so long to start and to answer.
constexpr int grace_ms = 500;
/// Of an answer beyond its texts and blobs: numbers, lengths and names.
constexpr std::size_t frame_bytes_max = std::size_t{64} << 20U;

/// An answer as bytes between two processes of the same program.
class Writer {
 public:
  void number(std::int64_t value) { bits(value); }
  void bits(const auto& value) {
    static_assert(std::is_trivially_copyable_v<std::remove_cvref_t<decltype(value)>>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void text(std::string_view text) {
    number(static_cast<std::int64_t>(text.size()));
    bytes_.append(text);
  }
  void cell(const ReportCell& cell) {
    number(static_cast<std::int64_t>(cell.index()));
    if (const auto* const whole = std::get_if<std::int64_t>(&cell)) number(*whole);
    if (const auto* const real = std::get_if<double>(&cell)) bits(*real);
    if (const auto* const words = std::get_if<std::string>(&cell)) text(*words);
    if (const auto* const blob = std::get_if<std::vector<std::byte>>(&cell)) {
      text({reinterpret_cast<const char*>(blob->data()), blob->size()});
    }
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}
  std::int64_t number() { return bits<std::int64_t>(); }
  template <typename Value>
  Value bits() {
    Value value{};
    const std::string_view taken = take(sizeof value);
    std::memcpy(&value, taken.data(), sizeof value);
    return value;
  }
  std::string_view text() { return take(static_cast<std::size_t>(number())); }
  ReportCell cell() {
    switch (number()) {
      case 1:
        return number();
      case 2:
        return bits<double>();
      case 3:
        return std::string{text()};
      case 4: {
        const std::string_view blob = text();
        const auto* const first = reinterpret_cast<const std::byte*>(blob.data());
        return std::vector<std::byte>(first, first + blob.size());
      }
      default:
        return {};
    }
  }

 private:
  std::string_view take(std::size_t count) {
    if (count > rest_.size()) throw std::runtime_error{"the answer ends too early"};
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }
  std::string_view rest_;
};

constexpr std::int64_t answered = -1;

std::string bytes_of(const Report& report) {
  Writer writer;
  writer.number(answered);
  writer.number(static_cast<std::int64_t>(report.columns.size()));
  for (const std::string& column : report.columns) writer.text(column);
  writer.number(static_cast<std::int64_t>(report.rows.size()));
  for (const auto& row : report.rows) {
    for (const ReportCell& cell : row) writer.cell(cell);
  }
  return writer.take();
}

std::string bytes_of(DatabaseErrorKind kind, std::string_view sentence) {
  Writer writer;
  writer.number(static_cast<std::int64_t>(kind));
  writer.text(sentence);
  return writer.take();
}

Report report_in(std::string_view bytes) {
  Reader reader{bytes};
  const std::int64_t outcome = reader.number();
  if (outcome != answered) {
    throw DatabaseError{static_cast<DatabaseErrorKind>(outcome), std::string{reader.text()}};
  }
  Report report;
  report.columns.resize(static_cast<std::size_t>(reader.number()));
  for (std::string& column : report.columns) column = reader.text();
  report.rows.resize(static_cast<std::size_t>(reader.number()));
  for (auto& row : report.rows) {
    for (std::size_t i = 0; i < report.columns.size(); ++i) row.push_back(reader.cell());
  }
  return report;
}

bool write_all(int descriptor, std::string_view bytes) noexcept {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

std::string read_all(int descriptor) {
  std::string bytes;
  std::array<char, 65536> piece{};
  for (;;) {
    const ssize_t count = ::read(descriptor, piece.data(), piece.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return bytes;
    bytes.append(piece.data(), static_cast<std::size_t>(count));
  }
}

std::string answer_to(const std::string& question, const ReportLimits& limits) {
  try {
    Reader reader{question};
    const std::filesystem::path directory{std::string{reader.text()}};
    const std::string sql{reader.text()};
    return bytes_of(ReportConnection{directory, limits}.answer(sql));
  } catch (const DatabaseError& error) {
    return bytes_of(error.kind(), error.what());
  } catch (const std::bad_alloc&) {
    return bytes_of(DatabaseErrorKind::BadInput,
                    "could not answer the report: it takes more memory than a report may");
  } catch (const std::exception& error) {
    return bytes_of(DatabaseErrorKind::InputOutput, error.what());
  }
}

/// What this process has open is not the child's business; another child's question would never
/// end.
void close_all_but(int one, int other) noexcept {
  const auto [low, high] = std::minmax(one, other);
  const auto from = [](int descriptor) { return static_cast<unsigned>(descriptor); };
  if (low > 3) ::close_range(3, from(low - 1), 0);
  if (high > low + 1) ::close_range(from(low + 1), from(high - 1), 0);
  ::close_range(from(high + 1), ~0U, 0);
}

[[noreturn]] void serve(int asked, int answering, const ReportLimits& limits) {
  close_all_but(asked, answering);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  const auto seconds = static_cast<rlim_t>((limits.time_ms + grace_ms) / 1000) + 1;
  const rlimit processor{seconds, seconds};
  ::setrlimit(RLIMIT_CPU, &processor);
  sqlite3_hard_heap_limit64(heap_bytes_max);
  const std::string question = read_all(asked);
  const bool is_said = !question.empty() && write_all(answering, answer_to(question, limits));
  ::_exit(is_said ? 0 : 1);
}

[[noreturn]] void fail(const std::string& reason) {
  throw DatabaseError{DatabaseErrorKind::BadInput, "could not answer the report: " + reason};
}

/// Whether something came before the moment; a signal ends the waiting.
bool comes_before(int descriptor, std::chrono::steady_clock::time_point end) {
  const auto left =
      std::chrono::ceil<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
  if (left.count() <= 0) return false;
  pollfd waiting{descriptor, POLLIN, 0};
  const int found = ::poll(&waiting, 1, static_cast<int>(left.count()));
  if (found < 0) throw Cancelled{"the report was stopped"};
  return found > 0;
}

}  // namespace

ReportProcess::ReportProcess(const ReportLimits& limits) : limits_(limits) {
  std::array<int, 2> question{-1, -1}, reply{-1, -1};
  const bool has_pipes =
      ::pipe2(question.data(), O_CLOEXEC) == 0 && ::pipe2(reply.data(), O_CLOEXEC) == 0;
  child_ = has_pipes ? ::fork() : -1;
  if (child_ == 0) {
    serve(question[0], reply[1], limits_);
  }
  const int error_number = errno;
  ::close(question[0]);
  ::close(reply[1]);
  asking_ = question[1];
  answering_ = reply[0];
  if (child_ > 0) return;
  ::close(asking_);
  ::close(answering_);
  throw DatabaseError{DatabaseErrorKind::InputOutput,
                      std::string{"could not begin a process for the report: "} +
                          std::strerror(error_number) + "; end other programs and try again"};
}

ReportProcess::~ReportProcess() {
  ::close(answering_);
  if (asking_ >= 0) ::close(asking_);
  ::kill(child_, SIGKILL);
  ::waitpid(child_, nullptr, 0);
}

Report ReportProcess::answer(const std::filesystem::path& directory, const std::string& sql) {
  Writer question;
  question.text(std::filesystem::absolute(directory).string());
  question.text(sql);
  write_all(asking_, question.take());
  ::close(std::exchange(asking_, -1));
  const auto end =
      std::chrono::steady_clock::now() + std::chrono::milliseconds{limits_.time_ms + grace_ms};
  std::string bytes;
  std::array<char, 65536> piece{};
  for (;;) {
    if (!comes_before(answering_, end)) {
      fail("it took longer than " + std::to_string(limits_.time_ms) +
           " ms; ask for less, as with a range of `tick`");
    }
    const ssize_t count = ::read(answering_, piece.data(), piece.size());
    if (count <= 0) break;
    bytes.append(piece.data(), static_cast<std::size_t>(count));
    if (bytes.size() > limits_.bytes + frame_bytes_max) fail("its answer is too large");
  }
  if (bytes.empty()) fail("it was stopped before it ended; ask for less");
  return report_in(bytes);
}

}  // namespace hallux::database
