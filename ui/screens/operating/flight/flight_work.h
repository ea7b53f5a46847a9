/// The block of the first flight, ready to be sawn. Inside this corner only.
#pragma once

#include "ui/screens/operating/operation_work.h"

namespace hallux::ui {

/// Makes the block, its plan and its picture; reads nothing of the course and stores nothing in it.
/// errors  DatabaseError; Cancelled
/// thread  any but the window's
PreparedOperation prepare_flight(SignedInSession& signed_in, WorkReport& report);

}  // namespace hallux::ui
