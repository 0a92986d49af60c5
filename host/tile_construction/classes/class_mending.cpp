#include "host/tile_construction/classes/class_mending.hpp"

#include "host/tile_construction/classes/class_torus.hpp"
#include "host/tile_construction/moments/moment_targets.hpp"

#include <tbb/parallel_for.h>

#include <limits>

namespace poissonlab {
namespace {

/// The settings of pushing: equal moments need a little more than the distances that are asked for.
ClassFillSettings class_mending_settings(PoissonTileParameters p)
{
    ClassDistances& distances = p.classes.distances;
    const double margin = moment_margin(p) / tile_units;
    for (std::size_t i = 0; i < p.classes.count(); ++i)
        for (std::size_t j = 0; j <= i; ++j) distances.set(i, j, distances.at(i, j) + margin);
    return class_fill_settings(p);
}

class ClassMender final : public TileFiller
{
public:
    ClassMender(const PoissonTileParameters& p, ClassTileFiller& filler)
        : settings_(class_mending_settings(p)), filler_(filler)
    {}

    std::vector<FilledTorus> fill(const FillStage& stage, std::span<const FillProblem> problems,
                                  std::uint32_t attempt) override
    {
        std::vector<std::vector<TilePosition>> points = thrown(stage, problems, attempt);
        std::vector<FilledTorus> filled(problems.size());
        tbb::parallel_for(std::size_t{0}, problems.size(), [&](std::size_t i) {
            if (!problems[i].given.empty()) points[i] = problems[i].given;
            if (points[i].size() == problems[i].active) filled[i] = pushed(stage, problems[i], points[i]);
        });
        return filled;
    }

private:
    /// The points of tori that have none yet; others get no list.
    std::vector<std::vector<TilePosition>> thrown(const FillStage& stage, std::span<const FillProblem> problems,
                                                  std::uint32_t attempt)
    {
        std::vector<std::size_t> empty;
        std::vector<ClassFillProblem> classed;
        for (std::size_t i = 0; i < problems.size(); ++i) {
            if (!problems[i].given.empty() || problems[i].active == 0) continue;
            empty.push_back(i);
            classed.push_back(
                {by_class(problems[i].held, settings_.classes()), problems[i].classes, problems[i].stream});
        }
        std::vector<std::vector<TilePosition>> points(problems.size());
        if (empty.empty()) return points;
        const std::vector<ClassFilledTorus> filled = filler_.fill(stage, classed, attempt);
        for (std::size_t i = 0; i < empty.size(); ++i) points[empty[i]] = with_classes(filled[i].active);
        return points;
    }

    FilledTorus pushed(const FillStage& stage, const FillProblem& problem,
                       const std::vector<TilePosition>& points) const
    {
        ClassTorus torus(settings_, {stage.regions, stage.active.cells, {}, stage.keep_tiles}, problem.held,
                         stage.is_one_tile);
        for (const TilePosition& point : points) torus.add(point);
        const ClassMoments moments{monomials_up_to(stage.equal_moments, 2), problem.moments};
        const std::uint32_t part = torus.push(stage.equal_moments > 0 ? &moments : nullptr);
        FilledTorus filled;
        filled.active.assign(torus.active().begin(), torus.active().end());
        filled.squared_min_distance = part >= whole_part ? std::numeric_limits<std::uint32_t>::max() : 0;
        return filled;
    }

    ClassFillSettings settings_;
    ClassTileFiller& filler_;
};

}

std::unique_ptr<TileFiller> make_class_mender(const PoissonTileParameters& parameters, ClassTileFiller& filler)
{
    return std::make_unique<ClassMender>(parameters, filler);
}

}
