#include "host/tile_construction/strip_relaxation.hpp"

#include "host/tile_construction/boundary_stages.hpp"
#include "host/tile_construction/fill_stages.hpp"
#include "host/tile_construction/joint/stored_points.hpp"
#include "host/tile_construction/moments/equal_moments.hpp"
#include "host/tile_construction/strip_mending.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

class StripRelaxation
{
public:
    StripRelaxation(StripPieces& pieces, const PoissonTileParameters& parameters, const JointEngines& engines,
                    const ConstructionOptions& options, ConstructionReport& report)
        : p_(parameters), pieces_(pieces), engines_(engines), options_(options),
          mender_(pieces, parameters, engines, report)
    {}

    void run()
    {
        const std::uint32_t last = std::min(p_.joint_iterations, last_joint_iterations);
        const std::uint32_t first = p_.joint_iterations - last;
        for (std::uint32_t iteration = 0; iteration < first; ++iteration) {
            const PieceStore before = pieces_.borders;
            iterate(iteration, true);
            mender_.mend_borders(before);
        }
        if (first > 0) mender_.mend();
        for (std::uint32_t iteration = first; iteration < p_.joint_iterations; ++iteration) {
            const std::vector<PiecePoints> before = pieces_.interiors;
            iterate(iteration, false);
            for (const std::uint32_t tile : mender_.repel(mender_.all_tiles())) pieces_.interiors[tile] = before[tile];
        }
        if (p_.equal_moments > 0) equalize_moments();
    }

private:
    using Tiles = StripMender::Tiles;

    // Iterations.

    void iterate(std::uint32_t iteration, bool borders_move)
    {
        StoredPoints stored;
        std::array<std::vector<std::size_t>, 8> numbers; // of pieces, by axes
        for (const std::uint8_t axes : mender_.border_axes()) {
            const std::uint32_t count = piece_count(p_, axes);
            for (std::uint32_t variant = 0; variant < count; ++variant)
                numbers[axes].push_back(stored.add(pieces_.borders.at(axes, variant), 1.0 / count, borders_move));
        }
        const std::uint8_t inside = all_axes(p_.dimension);
        for (const PiecePoints& interior : pieces_.interiors)
            numbers[inside].push_back(stored.add(interior, 1.0 / p_.tiles, true));

        const auto own_pieces = [&](std::uint32_t tile) {
            std::vector<std::size_t> own;
            for (const PlacedPiece& piece : pieces_around(p_, tile))
                if (piece.base == std::array<std::int8_t, 3>{}) own.push_back(numbers[piece.axes][piece.variant]);
            own.push_back(numbers[inside][tile]);
            return own;
        };
        const auto own_points = [&](std::uint32_t tile) {
            std::vector<OwnPoint> own;
            const auto add = [&](std::size_t number, const PiecePoints& points,
                                 const std::array<std::int8_t, 3>& base) {
                for (std::size_t i = 0; i < points.size(); ++i)
                    if (is_in_tile(placed_at(points[i], base)))
                        own.push_back({static_cast<std::uint32_t>(stored.first(number) + i), base});
            };
            for (const PlacedPiece& piece : pieces_around(p_, tile))
                add(numbers[piece.axes][piece.variant], pieces_.borders.at(piece.axes, piece.variant), piece.base);
            add(numbers[inside][tile], pieces_.interiors[tile], {});
            return own;
        };
        const auto displacements = joint_displacements(engines_.joint, stored, own_pieces, own_points, p_, iteration);
        const auto move = [&](PiecePoints& points, std::uint8_t axes, std::size_t number) {
            for (std::size_t i = 0; i < points.size(); ++i)
                points[i] = moved(points[i], axes, displacements[stored.first(number) + i]);
        };
        for (std::uint32_t tile = 0; tile < p_.tiles; ++tile)
            move(pieces_.interiors[tile], inside, numbers[inside][tile]);
        for (const std::uint8_t axes : mender_.border_axes())
            for (std::uint32_t variant = 0; variant < numbers[axes].size() && borders_move; ++variant)
                move(pieces_.borders.at(axes, variant), axes, numbers[axes][variant]);
        if (options_.progress) options_.progress("joint iterations", iteration + 1, p_.joint_iterations);
    }

    /// The end of a movement, at the latest at the border of the point's region or of its tile, which has as many
    /// points as any other.
    TilePosition moved(const TilePosition& point, std::uint8_t axes, const Displacement& by) const
    {
        TilePosition movement{};
        for (std::size_t k = 0; k < 3; ++k) movement[k] = static_cast<std::int32_t>(std::nearbyint(by[k]));
        return relative_to_base(allowed_end({mender_.regions(), cell_of_axes(axes, p_.dimension), {}, true},
                                            on_torus(point), movement, false));
    }

    // Moments.

    void equalize_moments()
    {
        const EvenableTiles tiles{
            [&] { return tile_set_of(pieces_, p_); },
            [&](const MomentTargets& targets, const Tiles& open) {
                return mender_.fill_tiles(open, true, 0, &targets);
            },
            [&](const MomentTargets& targets, const Tiles& open, std::uint32_t round) {
                return mender_.fill_tiles(open, false, round, &targets);
            },
            [&](const MomentTargets& targets, std::uint32_t tile) { return make_exact(targets, tile); },
            [](const Tiles&) { return false; },
            patient_tile_attempts,
            pieces_.interiors,
            {}};
        make_moments_equal(p_, tiles, [&](std::size_t done, std::size_t total) {
            if (options_.progress) options_.progress("equal moments", done, total);
        });
    }

    bool make_exact(const MomentTargets& targets, std::uint32_t tile)
    {
        const unsigned inside = cell_number(all_axes(p_.dimension), 0, p_.dimension);
        return targets.make_exact(pieces_.interiors[tile], own_border_points(pieces_.borders, p_, tile)) &&
               std::ranges::all_of(pieces_.interiors[tile], [&](const TilePosition& point) {
                   return is_in_tile(point) && cell_at(mender_.regions(), point) == inside;
               });
    }

    const PoissonTileParameters& p_;
    StripPieces& pieces_;
    const JointEngines& engines_;
    const ConstructionOptions& options_;
    StripMender mender_;
};

}

void relax_together(StripPieces& pieces, const PoissonTileParameters& parameters, const JointEngines& engines,
                    const ConstructionOptions& options, ConstructionReport& report)
{
    StripRelaxation(pieces, parameters, engines, options, report).run();
}

}
