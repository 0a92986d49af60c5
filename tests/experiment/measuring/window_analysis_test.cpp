// Windows of the plane are analysed as such: by their sampler or by the config.
#include "experiment/measuring/series_analysis.hpp"

#include "base/geometry/relative_radius.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

/// Two points that are near each other across the border, and some others.
const PointSet points{2, {0.01, 0.5, 0.99, 0.5, 0.5, 0.1, 0.5, 0.9, 0.5, 0.5}};

Series analysed(bool is_window)
{
    AnalysisOptions options;
    options.window = is_window;
    SeriesAnalysis analysis("s", false, options);
    analysis.add(points);
    analysis.measure_first();
    return analysis.result();
}

TEST(WindowAnalysis, TakesNoDistanceAcrossBordersAndLeavesOutWhatNeedsATorus)
{
    const Series torus = analysed(false), window = analysed(true);
    EXPECT_FALSE(torus.is_window);
    EXPECT_NEAR(torus.min_distance->mean, 0.02, 1e-12);
    EXPECT_TRUE(torus.measures.voronoi && torus.measures.largest_empty && !torus.measures.integration.empty());
    EXPECT_TRUE(window.is_window);
    EXPECT_NEAR(window.min_distance->mean, 0.4, 1e-12);
    EXPECT_NEAR(window.relative_radius->mean, relative_radius(0.4, 5, 2), 1e-12);
    EXPECT_FALSE(window.measures.voronoi || window.measures.largest_empty || !window.measures.integration.empty());
}

}
}
