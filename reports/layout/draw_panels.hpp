// Drawing of panels: each from its own value, so that no order matters and several threads may draw at once.
#pragma once

#include "reports/images/picture_store.hpp"
#include "reports/layout/panel.hpp"
#include "reports/plots/gnuplot.hpp"

#include <filesystem>
#include <vector>

namespace poissonlab {

/// Writes a panel's files and its thumbnail into the folder, but for what the store has; of plots the thumbnail alone,
/// as gnuplot draws many at once. Throws InputError when stored files are not what results.json says.
void draw_panel(const Panel& panel, const std::filesystem::path& folder, PictureStore& store);

/// Adds the panel's plot, where it is one, to those for gnuplot.
void add_plot(const Panel& panel, const std::filesystem::path& folder, std::vector<GnuplotPicture>& plots);

}
