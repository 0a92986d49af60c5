// gnuplot as a child process: many plots in one go, each as SVG and, for print, as PNG. Its bytes are stable and its
// axes good, which libraries for plots (PLplot, Matplotlib) do no better.
#pragma once

#include "reports/images/picture_store.hpp"
#include "reports/plots/print_pictures.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// One picture. `commands` set everything but terminal and output, and end with the plot command.
struct GnuplotPicture
{
    std::string commands;
    int width = 0; ///< of the SVG; the PNG has twice as many pixels
    int height = 0;
    std::filesystem::path stem; ///< its files are stem.svg and stem.png
};

/// Draws all pictures, but for those that the store has, without a shell: with as many gnuplot processes for each kind
/// of file as there are cores. The bytes depend on the commands only: no dates, no user settings. Throws StorageError
/// when gnuplot is not installed or fails, with what it said.
void draw_with_gnuplot(const std::vector<GnuplotPicture>& pictures, PrintPictures print, PictureStore* store = nullptr);

/// A text as a gnuplot string; control characters become blanks.
std::string gnuplot_quoted(const std::string& text);

}
