/// Waiting of a connection while another one writes. Inside this corner only.
#pragma once

namespace SQLite {
class Database;
}

namespace hallux::database {

/// Waits for about `timeout_ms` in steps of 1 to 3 ms. SQLite's own waiting doubles its steps up to
/// 100 ms: beside seven writers without a pause it finds the moment between two of them so rarely
/// that one in 16,000 writes waited for five seconds (measured), and was told that the database is
/// locked.
void wait_when_busy(SQLite::Database& connection, int timeout_ms);

/// Does not wait at all, until wait_when_busy is called again.
void never_wait(SQLite::Database& connection);

}  // namespace hallux::database
