// A drawing as SVG and as PNG.
#pragma once

#include "reports/drawings/drawing.hpp"
#include "reports/images/picture_store.hpp"

#include <filesystem>
#include <string>

namespace poissonlab {

/// Writes stem.svg and stem.png, so many pixels wide (max_drawing_pixels at most); the PNG only where the SVG is
/// another one than that which it was drawn with. Returns the SVG.
std::string write_drawing(const std::filesystem::path& stem, const Drawing& drawing, double pixels_wide,
                          PictureStore& store);

}
