// Verdicts say in words what the numbers of a series mean, and which series can be judged at all.
#pragma once

#include "reports/layout/report_layout.hpp"

#include <optional>
#include <string>

namespace poissonlab {

/// True where the closest pairs of sets that were made elsewhere say that these are not periodic, see
/// results/series.hpp.
bool is_not_periodic(const ReportSeries& series);

/// The words for readers of such a series, and the way to measure it within its square (cube); empty for others.
std::string border_notice(const ReportSeries& series);

/// The anisotropy that stands out of chance, dB; 0: none does. Nothing where it was not measured.
std::optional<double> anisotropy_above_chance(const ReportSeries& series);

/// True where it is known to be more than 0.
bool has_directions(const ReportSeries& series);

/// "Strengths: all points keep apart (ρ = 0.75); no preferred directions. Weaknesses: noise at low frequencies, 6.2 %
/// of
/// ...". Of series that follow a density, and of sets that are not periodic, it says that.
std::string sentence_about(const ReportSeries& series);

}
