// The normal distribution by nothing but sums and products, whose last bits are the same on all machines.
#pragma once

namespace poissonlab {

/// The probability of at most `deviations` standard deviations; error below 1e-12 up to four of them, and below the
/// probability beyond.
double normal_probability(double deviations);

}
