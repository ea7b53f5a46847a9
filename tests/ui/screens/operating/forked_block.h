/// A block whose end, which is to come off, is a fork: a broad prong and a thin one.
///
///              cut
///     .---------|--------.
///     |         | broad  |  13 mm
///     |       .-|--------'
///     |       '-|--------.
///     |         | thin   |   3 mm       It is highest at the thin prong, where the entry is.
///     '---------|--------'
#pragma once

#include "ui/jobs/live_attempt.h"

namespace hallux::ui {

/// The scenario of the practice block, with a blade of that width: a broad one parts both prongs in
/// one pass, a narrow one the thin prong before the other.
PreparedCase forked_case(double blade_width_mm);

}  // namespace hallux::ui
