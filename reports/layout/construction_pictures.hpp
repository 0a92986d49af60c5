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

/// True where the panels are steps, one after the other: those of a method that makes a set, and the stages of a tile.
bool has_steps(const ReportConstruction& construction);

/// True for steps of a method that makes a point set, which are many.
bool is_set(const ReportConstruction& construction);

/// The page of the steps.
std::filesystem::path steps_page_of(const ReportConstruction& construction);

/// The scene as pictures have it: of many steps some, from the first to the last.
Scene pictured_scene(const ReportConstruction& construction);

/// Writes construction.svg and construction.png.
void draw_construction_picture(const ReportConstruction& construction, PictureStore& store);

}
