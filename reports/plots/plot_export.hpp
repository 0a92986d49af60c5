// Plots for papers: their numbers as comma-separated values, and as LaTeX for the package pgfplots.
#pragma once

#include "reports/plots/plot.hpp"

#include <string>

namespace poissonlab {

/// A line for each place of each curve: its label, x, y, low and high end of its error or range, and its dot. What a
/// curve does not have, or has not there, is empty. Labels are quoted as RFC 4180 has it.
std::string plot_csv(const Plot& plot);

/// A tikzpicture with the same curves, axes, marks and colours, and a legend where there are several. It holds its own
/// numbers and needs \usepackage{pgfplots} and \pgfplotsset{compat=1.18} alone; TikZ 3.1.10 has both.
std::string plot_latex(const Plot& plot);

/// Words for LaTeX: characters that command it are escaped, subscripts as gnuplot has them and Greek letters are set as
/// mathematics.
std::string latex_words(const std::string& words);

}
