/// Columns as residuals of a predictor, Rice-coded. Inside this corner only.
///
///   coded  = for each column a head, then one stream of bits that holds the columns from the
///            last to the first
///   head   = 1 byte: guess * 64 + order; then the first row's rest as a varint
///   column = for each further row its rest in the Rice code of that order
///            (database/recording/rice_bits.h); no bits where the order is 63: then each rest is 0
///   rest   = zigzag of (number - guessed number), modulo 2^64
///
/// Guesses, where v is the column, i the row, t the same column of the tape of the same window:
///   0  v[i-1]
///   1  2 v[i-1] - v[i-2]
///   2  v[i-1] + t[i] - t[i-1]
///   3  the root of 10^12 less the squares of the next three columns, to the nearest: the real part
///      of a unit quaternion in millionths
/// What stands before the first row is 0; in its second row guess 1 is guess 0.
///
/// A hand in the air holds a tool that is where the hand is: then guess 2 leaves nothing of the
/// samples' poses.
/// source  docs/data_format.md; docs/decisions/0007-chunks-hold-what-a-guess-leaves.md
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "database/recording/columns.h"

namespace hallux::database {

/// Appends the columns as coded, each with the guess and the order that take the fewest bits.
/// needs   `tape`, where there is one, is of the same window
void append_coded(std::vector<std::byte>& coded, const Columns& columns, const Columns* tape);

/// Reads `columns`, which says how many and how long.
/// needs   at least one row
/// errors  DatabaseError Damaged: not exactly that many numbers, or a guess from a tape that is not
///         there or not as long
void read_coded(std::span<const std::byte> coded, const Columns* tape, Columns& columns);

}  // namespace hallux::database
