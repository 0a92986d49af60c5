// The pictures of constructions of a report.
#pragma once

#include "reports/images/picture_store.hpp"
#include "results/run.hpp"

#include <filesystem>

namespace poissonlab {

/// One picture of a construction.
struct ReportConstruction
{
    const Run* run = nullptr; ///< the runs outlive this
    const ConstructionResult* stored = nullptr;
    Scene scene;
    std::filesystem::path pictures; ///< folder of its picture
};

/// Writes construction.svg and construction.png.
void draw_construction_picture(const ReportConstruction& construction, PictureStore& store);

}
