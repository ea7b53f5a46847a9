#include "ui/jobs/files/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <string>

#include "database/store/output_place.h"
#include "ui/jobs/files/output_error.h"

namespace hallux::ui {

namespace {

namespace fs = std::filesystem;

/// A new file beside the target, under a name that nothing has; it is gone with the object unless
/// it was published.
class FileBeside {
 public:
  FileBeside(const fs::path& target, bool is_private) : target_(target) {
    const mode_t mode = is_private ? 0600 : 0666;
    constexpr int attempts_max = 1000;
    const std::string start = ".hallux-" + std::to_string(::getpid()) + "-";
    for (int i = 0; i < attempts_max && descriptor_ < 0; ++i) {
      file_ = target.parent_path() / (start + std::to_string(i) + ".new");
      descriptor_ = ::open(file_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
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

void replace_file(const fs::path& file, std::string_view bytes, bool is_private) {
  FileBeside beside(file, is_private);
  beside.write(bytes);
  beside.publish();
}

}  // namespace

bool may_be_replaced(const fs::path& file, const OutputKind& kind) {
  std::error_code error;
  if (fs::file_size(file, error) == 0 && !error) return true;
  std::ifstream stream(file, std::ios::binary);
  std::string beginning(kind.beginning.size(), '\0');
  stream.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  return beginning == kind.beginning;
}

void check_output(const fs::path& file, const OutputKind& kind, const fs::path& data_directory) {
  database::check_outside(file, data_directory);
  std::error_code ignored;
  const fs::file_status before = fs::status(file, ignored);
  if (!fs::exists(before)) return;
  if (fs::is_directory(before)) throw output_error(file, EISDIR);
  if (!fs::is_regular_file(before)) {
    throw OutputError(OutputErrorKind::Name, "could not write " + file.string() +
                                                 ": it is a device or a pipe; name a file");
  }
  if (may_be_replaced(file, kind)) return;
  throw OutputError(OutputErrorKind::Name, file.string() + " is there already and is not " +
                                               std::string(kind.name) +
                                               " of this program; it was left as it is, name "
                                               "another file");
}

void write_output(const fs::path& file, std::string_view bytes, const OutputKind& kind,
                  const fs::path& data_directory) {
  check_output(file, kind, data_directory);
  replace_file(file, bytes, kind.is_of_people);
}

void replace_own_file(const fs::path& file, std::string_view bytes) {
  replace_file(file, bytes, true);
}

}  // namespace hallux::ui
