#include "ui/jobs/files/read_small_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace hallux::ui {

namespace {

/// An open file, closed with the end of its life.
class Descriptor {
 public:
  // Without O_NONBLOCK, opening a pipe that nobody writes to would wait for ever.
  explicit Descriptor(const std::filesystem::path& file)
      : number_(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const noexcept { return number_; }

 private:
  int number_;
};

}  // namespace

std::string read_small_file(const std::filesystem::path& file, std::size_t mebibytes_max,
                            std::string_view mend) {
  const auto refuse = [&](const std::string& what) {
    throw FileRefused(file.string() + ": " + what + "; " + std::string(mend));
  };
  const auto refuse_unreadable = [&](int error_number) {
    refuse("cannot be read (" + std::generic_category().message(error_number) + ")");
  };
  const Descriptor descriptor(file);
  if (descriptor.number() < 0) refuse_unreadable(errno);
  struct stat facts {};
  if (::fstat(descriptor.number(), &facts) != 0) refuse_unreadable(errno);
  if (!S_ISREG(facts.st_mode)) refuse("cannot be read (not a regular file)");
  const std::size_t bytes_max = mebibytes_max << 20U;
  const auto refuse_length = [&] {
    refuse("is larger than " + std::to_string(mebibytes_max) + " MiB");
  };
  if (static_cast<std::size_t>(facts.st_size) > bytes_max) refuse_length();
  // Read by what comes, not by the size that was told: the file may grow, and files of /proc tell
  // none.
  std::string bytes;
  constexpr std::size_t block = std::size_t{64} << 10U;
  while (bytes.size() <= bytes_max) {
    const std::size_t before = bytes.size();
    bytes.resize(before + block);
    const ssize_t count = ::read(descriptor.number(), bytes.data() + before, block);
    bytes.resize(before + (count > 0 ? static_cast<std::size_t>(count) : 0));
    if (count == 0) return bytes;
    if (count < 0 && errno != EINTR) refuse_unreadable(errno);
  }
  refuse_length();
  return bytes;
}

}  // namespace hallux::ui
