#include "results/pictures/construction_scene.hpp"

#include <algorithm>

namespace poissonlab {

const char* name_of(PointClass kind)
{
    constexpr ByPointClass<const char*> names{"surroundings", "outer", "held", "inner"};
    return names.at(static_cast<std::size_t>(kind));
}

ShapeVector shape_vector(const TilePosition& position)
{
    return {static_cast<double>(position[0]), static_cast<double>(position[1]), static_cast<double>(position[2])};
}

std::vector<ShapeVector> shape_vectors(const std::vector<TilePosition>& positions)
{
    std::vector<ShapeVector> vectors;
    for (const TilePosition& position : positions) vectors.push_back(shape_vector(position));
    return vectors;
}

ShapeVector SceneBox::high_corner() const
{
    ShapeVector high = low_corner();
    for (std::size_t k = 0; k < high.size(); ++k) high[k] += size[k];
    return high;
}

bool SceneBox::holds(const TilePosition& position, int dimension) const
{
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k)
        if (position[k] < low[k] || position[k] >= low[k] + size[k]) return false;
    return true;
}

bool ScenePanel::has_points() const
{
    return std::ranges::any_of(points, [](const auto& list) { return !list.empty(); });
}

SceneSummary summary_of(const Scene& scene)
{
    SceneSummary summary;
    summary.panels = scene.panels.size();
    for (const ScenePanel& panel : scene.panels)
        for (std::size_t i = 0; i < summary.points.size(); ++i) summary.points[i] += panel.points[i].size();
    return summary;
}

}
