// Pictures of marks: dots, strokes and words.
#pragma once

#include "reports/drawings/drawing.hpp"
#include "results/pictures/mark_picture.hpp"

#include <filesystem>

namespace poissonlab {

/// The picture of marks, a unit a pixel of its width. `folder` has its ground, where it has one: such a drawing is for
/// PNG files only. Throws InputError for a ground that cannot be read.
Drawing draw_marks(const MarkPicture& picture, const std::filesystem::path& folder);

}
