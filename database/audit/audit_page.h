/// Pages of the audit as an administrator reads them, with names. Inside this room only.
#pragma once

#include "database/records/audit_line.h"
#include "database/store/connection.h"

namespace hallux::database {

/// Newest first, with names where they can still be named. The chain is not checked: that is
/// verify's.
/// errors  DatabaseError
AuditPage read_audit_page(Database& database, const AuditRequest& request);

}  // namespace hallux::database
