#include "host/tile_construction/piece_choice.hpp"

#include <algorithm>
#include <bit>

namespace poissonlab {

double PieceBalance::mean_in_part(std::uint8_t axes) const
{
    const int across = parameters_.dimension - std::popcount(axes);
    return mean(axes) / (1 << across);
}

double PieceBalance::uneven(std::uint8_t axes, std::uint32_t variant, const PiecePoints& points) const
{
    const PartCounts counts = part_counts(points, axes, parameters_.dimension);
    std::vector<PlacedPiece> neighbours;
    if (is_last_) neighbours = earlier_neighbours(parameters_, axes, variant);
    double sum = 0;
    for (unsigned part = 0; part < 1u << parameters_.dimension; ++part) {
        if (part & axes) continue;
        std::array<int, 3> tile{};
        for (int k = 0; k < parameters_.dimension; ++k) tile[k] = (axes | part) >> k & 1 ? 0 : -1;
        const double excess = counts[part] - mean_in_part(axes) + carried(neighbours, tile);
        sum += excess * excess;
    }
    return sum;
}

double PieceBalance::carried(const std::vector<PlacedPiece>& neighbours, const std::array<int, 3>& tile) const
{
    double sum = 0;
    for (const PlacedPiece& piece : neighbours) {
        bool touches = true;
        unsigned part = 0;
        for (int k = 0; k < parameters_.dimension; ++k) {
            const bool extends = piece.axes >> k & 1;
            touches &= piece.base[k] == tile[k] || (!extends && piece.base[k] == tile[k] + 1);
            if (!extends && piece.base[k] == tile[k]) part |= 1u << k;
        }
        if (!touches) continue;
        const PartCounts counts = part_counts(pieces_.at(piece.axes, piece.variant), piece.axes, parameters_.dimension);
        // A corner touches two edges of its tile (three faces), an edge two corners (two faces).
        const int sharing =
            parameters_.kind == PoissonTileKind::edge ? 2 : parameters_.dimension - std::popcount(piece.axes);
        sum += (counts[part] - mean_in_part(piece.axes)) / sharing;
    }
    return sum;
}

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
