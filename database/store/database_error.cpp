#include "database/store/database_error.h"

namespace hallux::database {

bool is_storage_failure(DatabaseErrorKind kind) noexcept {
  switch (kind) {
    case DatabaseErrorKind::Full:
    case DatabaseErrorKind::ReadOnly:
    case DatabaseErrorKind::Damaged:
    case DatabaseErrorKind::InputOutput:
    case DatabaseErrorKind::Newer:
    case DatabaseErrorKind::Locked:
      return true;
    case DatabaseErrorKind::Refused:
    case DatabaseErrorKind::NotFound:
    case DatabaseErrorKind::BadInput:
      return false;
  }
  return true;
}

}  // namespace hallux::database
