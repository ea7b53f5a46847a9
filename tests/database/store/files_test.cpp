#include "database/store/files.h"

#include <gtest/gtest.h>

#include <cerrno>

namespace hallux::database {

namespace {

TEST(Files, AFullOrClosedDiskIsAStorageFailure) {
  for (const int error_number : {ENOSPC, EDQUOT, EROFS, EACCES, EPERM, EIO}) {
    EXPECT_TRUE(is_storage_failure(file_error("hallux.db", "make", error_number).kind()));
  }
}

TEST(Files, ADataDirectoryThatCannotBeIsMendedWithData) {
  for (const int error_number : {ENOENT, EISDIR, ENOTDIR, EEXIST, ENAMETOOLONG, EACCES, EROFS}) {
    const DatabaseError error = file_error("course", "make the directory", error_number);
    EXPECT_NE(std::string{error.what()}.find("--data"), std::string::npos) << error.what();
  }
}

TEST(Files, WhatSomebodyNamedIsMendedByAnotherName) {
  for (const int error_number :
       {ENOENT, ENOTDIR, EEXIST, ENOTEMPTY, ENAMETOOLONG, ELOOP, EACCES, EROFS, ENOSPC}) {
    const DatabaseError error = named_file_error("exported", "write", error_number);
    EXPECT_EQ(std::string{error.what()}.find("--data"), std::string::npos) << error.what();
  }
  EXPECT_TRUE(is_storage_failure(named_file_error("exported", "write", ENOSPC).kind()));
  EXPECT_EQ(named_file_error("exported", "write", ENOTDIR).kind(), DatabaseErrorKind::BadInput);
}

}  // namespace

}  // namespace hallux::database
