// Fills tori with points of several classes one after the other: the plain twin of kernels/class_tiles.cl.
#include "host/tile_construction/classes/class_torus.hpp"
#include "host/tile_construction/reference/filling_steps.hpp"

namespace poissonlab::reference {
namespace {

/// Throws the darts of a torus. Returns whether all points fit.
bool throw_darts(ClassTorus& torus, const ClassFillSettings& settings, const FillStage& stage,
                 const ClassFillProblem& problem, std::uint32_t attempt)
{
    std::size_t level = 0;
    std::uint32_t failures = 0, dart = 0;
    for (const std::uint32_t own : settings.order) {
        for (std::uint32_t placed = 0; placed < problem.active[own];) {
            if (level == settings.parts.size() || dart == contract::tile_filling::MAX_DARTS) return false;
            TilePosition position = dart_at(stage.active, stage.regions.dimension,
                                            {dart++, problem.stream, attempt, stage.number}, settings.stream);
            position[2] = static_cast<std::int32_t>(own);
            if (!is_allowed(torus.zone(), position)) continue;
            if (torus.part_kept(position) >= settings.parts[level]) {
                torus.add(position);
                ++placed;
                failures = 0;
            } else if (++failures == settings.attempts) {
                failures = 0;
                ++level;
            }
        }
    }
    return true;
}

class ReferenceClassFiller final : public ClassTileFiller
{
public:
    explicit ReferenceClassFiller(const ClassFillSettings& settings) : settings_(settings) {}

    std::vector<ClassFilledTorus> fill(const FillStage& stage, std::span<const ClassFillProblem> problems,
                                       std::uint32_t attempt) override
    {
        std::vector<ClassFilledTorus> results;
        for (const ClassFillProblem& problem : problems) {
            ClassTorus torus(settings_, {stage.regions, stage.active.cells}, with_classes(problem.held));
            ClassFilledTorus result;
            if (throw_darts(torus, settings_, stage, problem, attempt)) {
                result.part = torus.push();
                result.active = by_class(torus.active(), settings_.classes());
            }
            results.push_back(std::move(result));
        }
        return results;
    }

private:
    ClassFillSettings settings_;
};

}

std::unique_ptr<ClassTileFiller> make_class_tile_filler(const ClassFillSettings& settings)
{
    return std::make_unique<ReferenceClassFiller>(settings);
}

}
