#include "database/store/file_system.h"

#include <gtest/gtest.h>

#include "tests/database/some_database.h"

namespace hallux::database {

namespace {

constexpr std::string_view mount_table =
    "21 1 8:1 / / rw,relatime shared:1 - ext4 /dev/sda1 rw\n"
    "30 21 0:24 / /people rw shared:2 master:1 - nfs4 server:/people rw,vers=4.2\n"
    "31 30 0:25 / /people/ada/local rw - tmpfs tmpfs rw\n"
    "32 21 0:26 / /far/two\\040words rw - cifs //server/share rw\n"
    "33 21 0:27 / /far/box rw - ext4 /dev/sdb1 rw\n"
    "34 21 0:28 / /far/box rw - fuse.sshfs ada@server: rw\n"
    "a line that is none\n";

TEST(FileSystem, IsThatOfTheLastMountAbove) {
  EXPECT_EQ(file_system_in(mount_table, "/var/lib/hallux"), "ext4");
  EXPECT_EQ(file_system_in(mount_table, "/people/ada/records"), "nfs4");
  EXPECT_EQ(file_system_in(mount_table, "/people"), "nfs4");
  EXPECT_EQ(file_system_in(mount_table, "/peoples/ada"), "ext4") << "another name";
  EXPECT_EQ(file_system_in(mount_table, "/people/ada/local/x"), "tmpfs");
  EXPECT_EQ(file_system_in(mount_table, "/far/two words/x"), "cifs");
  EXPECT_EQ(file_system_in(mount_table, "/far/box/x"), "fuse.sshfs") << "the later one hides";
  EXPECT_EQ(file_system_in("", "/x"), "");
}

TEST(FileSystem, IsKnownWhereThisTestRunsAndNoShare) {
  const TemporaryDirectory temporary;
  EXPECT_FALSE(file_system_of(temporary.data()).empty());
  EXPECT_FALSE(is_network_share(file_system_of(temporary.data())));
}

TEST(FileSystem, ANetworkShareIsRefusedForWritingWithTheReason) {
  for (const char* share : {"nfs", "nfs4", "cifs", "smb3", "fuse.sshfs"}) {
    const TemporaryDirectory temporary;
    OpenOptions options;
    options.file_system = share;
    try {
      Database::open(temporary.data(), options);
      ADD_FAILURE() << "it was opened on " << share;
    } catch (const DatabaseError& error) {
      EXPECT_EQ(error.kind(), DatabaseErrorKind::ReadOnly);
      const std::string sentence = error.what();
      EXPECT_NE(sentence.find(std::string("network share (") + share), std::string::npos)
          << sentence;
      EXPECT_NE(sentence.find("--data"), std::string::npos) << sentence;
    }
    EXPECT_FALSE(std::filesystem::exists(temporary.data())) << "and nothing was made there";
  }
}

TEST(FileSystem, WhatIsOnAShareCanStillBeRead) {
  const TemporaryDirectory temporary;
  { Database::open(temporary.data()); }
  OpenOptions options;
  options.access = Access::ReadOnly;
  options.file_system = "nfs4";
  EXPECT_NO_THROW(Database::open(temporary.data(), options));
}

}  // namespace

}  // namespace hallux::database
