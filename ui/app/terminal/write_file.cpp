#include "ui/app/terminal/write_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <string>

#include "ui/jobs/files/output_error.h"

namespace hallux::ui {

namespace {

namespace fs = std::filesystem;

/// A new file beside the target, under a name that nothing has; it is gone with the object unless
/// it was published.
class FileBeside {
 public:
  explicit FileBeside(const fs::path& target) : target_(target) {
    constexpr int attempts_max = 1000;
    const std::string start = ".hallux-" + std::to_string(::getpid()) + "-";
    for (int i = 0; i < attempts_max && descriptor_ < 0; ++i) {
      file_ = target.parent_path() / (start + std::to_string(i) + ".new");
      descriptor_ = ::open(file_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor_ < 0 && errno != EEXIST) break;
    }
    if (descriptor_ < 0) fail();
  }
  ~FileBeside() {
    if (descriptor_ >= 0) ::close(descriptor_);
    std::error_code ignored;
    if (!is_published_) fs::remove(file_, ignored);
  }
  FileBeside(const FileBeside&) = delete;
  FileBeside& operator=(const FileBeside&) = delete;

  void write(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
      if (count < 0 && errno != EINTR) fail();
      if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
    }
  }
  void publish() {
    const int closed = ::close(descriptor_);
    descriptor_ = -1;
    if (closed != 0) fail();
    if (::rename(file_.c_str(), target_.c_str()) != 0) fail();
    is_published_ = true;
  }

 private:
  [[noreturn]] void fail() const { throw output_error(target_, errno); }

  fs::path target_, file_;
  int descriptor_ = -1;
  bool is_published_ = false;
};

}  // namespace

void write_file_whole(const fs::path& file, std::string_view bytes) {
  std::error_code ignored;
  const fs::file_status before = fs::status(file, ignored);
  if (fs::is_directory(before)) throw output_error(file, EISDIR);
  if (fs::exists(before) && !fs::is_regular_file(before)) {
    throw OutputError(OutputErrorKind::Name, "could not write " + file.string() +
                                                 ": it is a device or a pipe; name a file");
  }
  FileBeside beside(file);
  beside.write(bytes);
  beside.publish();
}

}  // namespace hallux::ui
