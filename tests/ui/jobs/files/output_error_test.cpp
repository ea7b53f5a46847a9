#include "ui/jobs/files/output_error.h"

#include <gtest/gtest.h>

#include <cerrno>

namespace hallux::ui {
namespace {

TEST(OutputError, ANameThatLeadsNowhereIsTheNamesFault) {
  for (const int error_number : {ENOENT, EISDIR, ENOTDIR, EEXIST, ENAMETOOLONG}) {
    EXPECT_EQ(output_error("page.html", error_number).kind(), OutputErrorKind::Name);
  }
}

TEST(OutputError, AFullOrClosedDiskIsTheStorages) {
  for (const int error_number : {ENOSPC, EDQUOT, EFBIG, EROFS, EACCES, EPERM, EIO}) {
    EXPECT_EQ(output_error("page.html", error_number).kind(), OutputErrorKind::Storage);
  }
}

TEST(OutputError, NamesTheFileAndAMendThatIsNotTheDataDirectorys) {
  for (const int error_number :
       {ENOENT, EISDIR, ENOTDIR, EEXIST, ENAMETOOLONG, ENOSPC, EROFS, EACCES, EPERM, EIO}) {
    const std::string sentence = output_error("pages/page.html", error_number).what();
    EXPECT_EQ(sentence.find("could not write pages/page.html: "), 0U) << sentence;
    EXPECT_EQ(sentence.find("--data"), std::string::npos) << sentence;
  }
}

}  // namespace
}  // namespace hallux::ui
