#include "host/tile_construction/piece_choice.hpp"

#include <algorithm>

namespace poissonlab {

PieceChoice::PieceChoice(const PoissonTileParameters& parameters, const TileRegions& regions, const PieceStore& pieces,
                         bool is_last)
    : parameters_(parameters), regions_(regions),
      balance_(parameters.points_per_tile, parameters, regions, pieces, is_last),
      wanted_(asked_squared_distance(parameters))
{}

void PieceChoice::consider(const BoundaryTorus& torus, FillProblem problem, FilledTorus filled)
{
    if (filled.squared_min_distance < wanted_) {
        best_failure_ = std::max(best_failure_, filled.squared_min_distance);
        return;
    }
    const auto source = std::make_shared<const Source>(Source{torus, std::move(problem), std::move(filled)});
    for (const PlacedPiece& piece : torus.made) {
        candidates_[{piece.axes, piece.variant}].push_back(
            {cut_out(source->filled.active, regions_, piece.axes, piece.base, false), piece.base, source});
    }
}

bool PieceChoice::has_all(const BoundaryTorus& torus) const
{
    return std::ranges::all_of(torus.made, [&](const PlacedPiece& piece) {
        return candidates_.contains({piece.axes, piece.variant});
    });
}

void PieceChoice::take(PieceStore& pieces, const std::function<void(const ConstructionRecord&)>& record) const
{
    std::array<double, 8> surplus{}; // of the pieces so far, by their axes
    for (const auto& [piece, candidates] : candidates_) {
        const auto axes = piece.first;
        const auto variant = piece.second;
        const double mean = balance_.mean(axes);
        const auto cost = [&](const Candidate& candidate) {
            const double total = surplus[axes] + static_cast<double>(candidate.points.size()) - mean;
            return balance_.uneven(axes, variant, candidate.points) + total * total;
        };
        const auto best = std::ranges::min_element(candidates, {}, cost);
        surplus[axes] += static_cast<double>(best->points.size()) - mean;
        pieces.at(axes, variant) = best->points;
        if (record) {
            const Source& source = *best->source;
            record({axes, variant, best->base, source.torus.held, &source.problem, &source.filled});
        }
    }
}

}
