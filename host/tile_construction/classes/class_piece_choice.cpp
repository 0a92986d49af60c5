#include "host/tile_construction/classes/class_piece_choice.hpp"

#include "host/tile_construction/piece_choice.hpp"

#include <algorithm>
#include <array>

namespace poissonlab {

void ClassPieceChoice::consider(const BoundaryTorus& torus, const ClassFilledTorus& filled)
{
    if (!filled.is_good()) {
        best_failure_ = std::max(best_failure_, filled.part);
        return;
    }
    for (const PlacedPiece& piece : torus.made) {
        Candidate& candidate = candidates_[{piece.axes, piece.variant}].emplace_back();
        for (const std::vector<TilePosition>& own : filled.active)
            candidate.push_back(cut_out(own, regions_, piece.axes, piece.base, false));
    }
}

bool ClassPieceChoice::has_all(const BoundaryTorus& torus) const
{
    return std::ranges::all_of(torus.made, [&](const PlacedPiece& piece) {
        return candidates_.contains({piece.axes, piece.variant});
    });
}

void ClassPieceChoice::take(ClassPieceStores& pieces) const
{
    const std::vector<std::uint32_t>& points = parameters_.classes.points;
    std::vector<PieceBalance> balances;
    for (std::size_t of = 0; of < points.size(); ++of)
        balances.emplace_back(points[of], parameters_, regions_, pieces_[of], is_last_);
    std::vector<std::array<double, 8>> surplus(points.size()); // of the pieces so far, by their axes
    for (const auto& [piece, candidates] : candidates_) {
        const auto [axes, variant] = piece;
        const auto excess = [&, axes = axes](const Candidate& candidate, std::size_t of) {
            return static_cast<double>(candidate[of].size()) - balances[of].mean(axes);
        };
        const auto cost = [&, axes = axes, variant = variant](const Candidate& candidate) {
            double sum = 0;
            for (std::size_t of = 0; of < points.size(); ++of) {
                const double total = surplus[of][axes] + excess(candidate, of);
                sum += (balances[of].uneven(axes, variant, candidate[of]) + total * total) / points[of];
            }
            return sum;
        };
        const Candidate& best = *std::ranges::min_element(candidates, {}, cost);
        for (std::size_t of = 0; of < points.size(); ++of) {
            surplus[of][axes] += excess(best, of);
            pieces[of].at(axes, variant) = best[of];
        }
    }
}

}
