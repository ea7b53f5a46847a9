#include "ui/jobs/files/output_error.h"

#include <cerrno>
#include <system_error>

namespace hallux::ui {

namespace {

struct Meaning {
  OutputErrorKind kind;
  const char* mend;
};

Meaning meaning_of(int error_number) {
  switch (error_number) {
    case ENOENT:
      return {OutputErrorKind::Name, "its folder does not exist; make it, or name another"};
    case EISDIR:
      return {OutputErrorKind::Name, "a folder has this name; name another"};
    case ENOTDIR:
    case EEXIST:
      return {OutputErrorKind::Name, "a file is where a folder should be; name another"};
    case ENAMETOOLONG:
      return {OutputErrorKind::Name, "the name is too long; give a shorter one"};
    case EROFS:
    case EACCES:
    case EPERM:
      return {OutputErrorKind::Storage,
              "it cannot be written there; choose a folder with room and permission"};
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return {OutputErrorKind::Storage, "the disk is full; free some space"};
    default:
      return {OutputErrorKind::Storage, "check the disk"};
  }
}

}  // namespace

OutputError output_error(const std::filesystem::path& file, int error_number) {
  const Meaning meaning = meaning_of(error_number);
  return {meaning.kind, "could not write " + file.string() + ": " + meaning.mend + " (" +
                            std::generic_category().message(error_number) + ")"};
}

}  // namespace hallux::ui
