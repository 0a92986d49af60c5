// The pictures of constructions of a report.
#pragma once

#include "reports/images/picture_store.hpp"
#include "results/stored_results.hpp"

#include <filesystem>

namespace poissonlab {

/// One picture of a construction.
struct ReportConstruction
{
    const StoredRun* run = nullptr; ///< the runs outlive this
    const StoredConstruction* stored = nullptr;
    StoredScene scene;
    std::filesystem::path pictures; ///< folder of its picture
};

/// Writes construction.svg and construction.png.
void draw_construction_picture(const ReportConstruction& construction, PictureStore& store);

}
