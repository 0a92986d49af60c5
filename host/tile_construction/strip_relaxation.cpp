#include "host/tile_construction/strip_relaxation.hpp"

#include "host/tile_construction/boundary_stages.hpp"
#include "host/tile_construction/fill_stages.hpp"
#include "host/tile_construction/moments/equal_moments.hpp"
#include "host/tile_construction/stored_points.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <compare>
#include <numeric>
#include <set>

namespace poissonlab {
namespace {

/// A piece that tiles share.
struct BorderPiece
{
    std::uint8_t axes = 0;
    std::uint32_t variant = 0;

    auto operator<=>(const BorderPiece&) const = default;
};

/// A position on the torus relative to the lattice point at 0.
TilePosition relative_to_base(const TilePosition& position)
{
    return {shortest(position[0]), shortest(position[1]), shortest(position[2])};
}

/// A position relative to a tile, of a point that is given relative to its piece's base.
TilePosition placed_at(const TilePosition& point, const std::array<std::int8_t, 3>& base)
{
    TilePosition position = point;
    for (std::size_t k = 0; k < 3; ++k) position[k] += base[k] * tile_units;
    return position;
}

bool is_in_tile(const TilePosition& position)
{
    return std::ranges::all_of(position, [](std::int32_t x) { return x >= 0 && x < tile_units; });
}

/// The points of the pieces around a tile that are in it.
std::vector<UnitPosition> own_border_points(const StripPieces& pieces, const PoissonTileParameters& p,
                                            std::uint32_t tile)
{
    std::vector<UnitPosition> points;
    for (const PlacedPiece& piece : pieces_around(p, tile))
        for (const TilePosition& point : pieces.borders.at(piece.axes, piece.variant))
            if (const TilePosition position = placed_at(point, piece.base); is_in_tile(position))
                points.push_back(position);
    return points;
}

TilePosition on_torus(const TilePosition& relative)
{
    return {wrapped(relative[0]), wrapped(relative[1]), wrapped(relative[2])};
}

class StripRelaxation
{
public:
    StripRelaxation(StripPieces& pieces, const PoissonTileParameters& parameters, const JointEngines& engines,
                    const ConstructionOptions& options, ConstructionReport& report)
        : p_(parameters), pieces_(pieces), saved_(pieces), engines_(engines), options_(options), report_(report),
          regions_(regions_of(parameters)), wanted_(mending_settings(parameters).wanted)
    {
        // The order in which they were made.
        const bool edges_first = p_.kind == PoissonTileKind::edge;
        for (std::uint8_t axes = 0; axes < all_axes(p_.dimension); ++axes) border_axes_.push_back(axes);
        std::ranges::stable_sort(border_axes_, [&](std::uint8_t a, std::uint8_t b) {
            return edges_first ? std::popcount(a) > std::popcount(b) : std::popcount(a) < std::popcount(b);
        });
    }

    void run()
    {
        const std::uint32_t last = std::min(p_.joint_iterations, last_joint_iterations);
        const std::uint32_t first = p_.joint_iterations - last;
        for (std::uint32_t iteration = 0; iteration < first; ++iteration) {
            const PieceStore before = pieces_.borders;
            iterate(iteration, true);
            Back back;
            mend_borders(before, back);
        }
        if (first > 0) mend();
        for (std::uint32_t iteration = first; iteration < p_.joint_iterations; ++iteration) {
            const std::vector<PiecePoints> before = pieces_.interiors;
            iterate(iteration, false);
            for (const std::uint32_t tile : repel(all_tiles())) pieces_.interiors[tile] = before[tile];
        }
        if (p_.equal_moments > 0) equalize_moments();
    }

private:
    using Tiles = std::vector<std::uint32_t>;
    using Borders = std::vector<BorderPiece>;
    using Back = std::set<BorderPiece>; ///< pieces that are as they were before

    // Iterations.

    void iterate(std::uint32_t iteration, bool borders_move)
    {
        StoredPoints stored;
        std::array<std::vector<std::size_t>, 8> numbers; // of pieces, by axes
        for (const std::uint8_t axes : border_axes_) {
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
        for (const std::uint8_t axes : border_axes_)
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
        return relative_to_base(allowed_end({regions_, cell_of(axes), {}, true}, on_torus(point), movement, false));
    }

    CellSet cell_of(std::uint8_t axes) const { return CellSet{1} << cell_number(axes, 0, p_.dimension); }

    // Mending.

    /// Brings back the minimum distance: borders first, then tiles between them.
    void mend()
    {
        Back back;
        for (;;) {
            mend_borders(saved_.borders, back);
            const Tiles failed = mend_tiles(back);
            for (const std::uint32_t tile : failed)
                for (const PlacedPiece& piece : pieces_around(p_, tile)) back.insert({piece.axes, piece.variant});
            if (failed.empty()) return;
            report_.remade += failed.size();
        }
    }

    /// Pieces that cannot be pushed apart go back to where they were, with those that they were made around.
    void mend_borders(const PieceStore& before, Back& back)
    {
        for (;;) {
            for (const BorderPiece& piece : back)
                pieces_.borders.at(piece.axes, piece.variant) = before.at(piece.axes, piece.variant);
            const Borders failed = p_.kind == PoissonTileKind::frame ? repel_frame(back) : repel_borders(back);
            if (failed.empty()) return;
            for (const BorderPiece& piece : failed) {
                back.insert(piece);
                for (const PlacedPiece& earlier : earlier_neighbours(p_, piece.axes, piece.variant))
                    back.insert({earlier.axes, earlier.variant});
            }
        }
    }

    /// Returns those that do not get the distance, of the first stage that has any.
    Borders repel_borders(const Back& back)
    {
        for (const std::uint8_t axes : border_axes_) {
            Borders open;
            std::vector<FillProblem> problems;
            std::vector<PiecePoints*> targets;
            for (std::uint32_t variant = 0; variant < piece_count(p_, axes); ++variant) {
                if (back.contains({axes, variant})) continue;
                PiecePoints& points = pieces_.borders.at(axes, variant);
                problems.push_back(problem_around(earlier_neighbours(p_, axes, variant), points, variant));
                targets.push_back(&points);
                open.push_back({axes, variant});
            }
            Borders failed;
            for (const std::size_t i : fill(cell_of(axes), problems, targets, 0)) failed.push_back(open[i]);
            if (!failed.empty()) return failed;
        }
        return {};
    }

    /// The points near the border of template tiles, which meet themselves around a torus of one tile.
    Borders repel_frame(const Back& back)
    {
        Borders frame;
        for (const std::uint8_t axes : border_axes_) frame.push_back({axes, 0});
        if (back.contains(frame.front())) return {};
        FillStage stage{.regions = regions_, .number = repair_stage, .is_one_tile = true, .keep_tiles = true};
        for (unsigned cell = 0; cell < 16; ++cell)
            if ((cell & all_axes(2)) != all_axes(2)) stage.active.cells |= CellSet{1} << cell;
        PiecePoints points;
        for (const BorderPiece& piece : frame)
            for (const TilePosition& point : pieces_.borders.at(piece.axes, 0)) points.push_back(point);
        const std::vector<FillProblem> problem{problem_around({}, points, 0)};
        const FilledTorus filled = engines_.mender.fill(stage, problem, 0).front();
        ++report_.tori;
        if (!is_good(problem.front(), filled)) {
            ++report_.failures;
            return frame;
        }
        for (const BorderPiece& piece : frame)
            pieces_.borders.at(piece.axes, 0) = cut_out(filled.active, regions_, piece.axes, {}, true);
        return {};
    }

    /// Pushes the points of tiles apart, or fills them anew. Returns those where neither helps.
    Tiles mend_tiles(const Back& back)
    {
        Tiles open;
        for (std::uint32_t tile = 0; tile < p_.tiles; ++tile) {
            const bool is_as_before = std::ranges::all_of(pieces_around(p_, tile), [&](const PlacedPiece& piece) {
                return back.contains({piece.axes, piece.variant});
            });
            if (is_as_before)
                pieces_.interiors[tile] = saved_.interiors[tile];
            else
                open.push_back(tile);
        }
        open = repel(open);
        for (std::uint32_t attempt = 0; attempt < patient_tile_attempts && !open.empty(); ++attempt)
            open = fill_tiles(open, false, attempt);
        return open;
    }

    Tiles all_tiles() const
    {
        Tiles all(p_.tiles);
        std::iota(all.begin(), all.end(), 0u);
        return all;
    }

    Tiles repel(const Tiles& open) { return fill_tiles(open, true, 0); }

    /// Pushes the points of tiles apart that are there, or throws as many anew. Returns those that do not get the
    /// distance, which stay as they are.
    Tiles fill_tiles(const Tiles& open, bool are_given, std::uint32_t attempt)
    {
        std::vector<FillProblem> problems;
        std::vector<PiecePoints*> targets;
        for (const std::uint32_t tile : open) {
            PiecePoints& interior = pieces_.interiors[tile];
            problems.push_back(problem_around(pieces_around(p_, tile), interior, tile));
            if (!are_given) problems.back().given.clear();
            if (targets_) problems.back().moments = targets_->left_in_units(own_border_points(pieces_, p_, tile));
            targets.push_back(&interior);
        }
        Tiles failed;
        for (const std::size_t i : fill(cell_of(all_axes(p_.dimension)), problems, targets, attempt))
            failed.push_back(open[i]);
        return failed;
    }

    FillProblem problem_around(const std::vector<PlacedPiece>& held, const PiecePoints& points,
                               std::uint32_t stream) const
    {
        FillProblem problem;
        problem.held = pieces_.borders.placed(held);
        for (const TilePosition& point : points) problem.given.push_back(on_torus(point));
        problem.active = static_cast<std::uint32_t>(points.size());
        problem.stream = stream;
        return problem;
    }

    bool is_good(const FillProblem& problem, const FilledTorus& filled) const
    {
        return filled.active.size() == problem.active &&
               (problem.active == 0 || filled.squared_min_distance >= wanted_);
    }

    /// Fills a cell around the lattice point at 0, and takes over what has the distance. Returns the numbers of the
    /// others.
    std::vector<std::size_t> fill(CellSet cells, const std::vector<FillProblem>& problems,
                                  const std::vector<PiecePoints*>& targets, std::uint32_t attempt)
    {
        if (problems.empty()) return {};
        FillStage stage{.regions = regions_, .number = targets_ ? moment_stage : repair_stage, .keep_tiles = true};
        stage.active.cells = cells;
        stage.equal_moments = targets_ ? targets_->order() : 0;
        const std::vector<FilledTorus> filled = engines_.mender.fill(stage, problems, attempt);
        report_.tori += filled.size();
        std::vector<std::size_t> failed;
        for (std::size_t i = 0; i < filled.size(); ++i) {
            if (!is_good(problems[i], filled[i])) {
                ++report_.failures;
                failed.push_back(i);
                continue;
            }
            targets[i]->clear();
            for (const TilePosition& point : filled[i].active) targets[i]->push_back(relative_to_base(point));
        }
        return failed;
    }

    // Moments.

    void equalize_moments()
    {
        const auto using_targets = [this](const MomentTargets& targets, const Tiles& open, bool are_given,
                                          std::uint32_t attempt) {
            targets_ = &targets;
            const Tiles failed = fill_tiles(open, are_given, attempt);
            targets_ = nullptr;
            return failed;
        };
        const EvenableTiles tiles{
            [&] { return tile_set_of(pieces_, p_); },
            [&](const MomentTargets& targets, const Tiles& open) { return using_targets(targets, open, true, 0); },
            [&](const MomentTargets& targets, const Tiles& open, std::uint32_t round) {
                return using_targets(targets, open, false, round);
            },
            [&](const MomentTargets& targets, std::uint32_t tile) { return make_exact(targets, tile); },
            [](const Tiles&) { return false; },
            patient_tile_attempts};
        make_moments_equal(p_, tiles, [&](std::size_t done, std::size_t total) {
            if (options_.progress) options_.progress("equal moments", done, total);
        });
    }

    bool make_exact(const MomentTargets& targets, std::uint32_t tile)
    {
        const unsigned inside = cell_number(all_axes(p_.dimension), 0, p_.dimension);
        return targets.make_exact(pieces_.interiors[tile], own_border_points(pieces_, p_, tile)) &&
               std::ranges::all_of(pieces_.interiors[tile], [&](const TilePosition& point) {
                   return is_in_tile(point) && cell_at(regions_, point) == inside;
               });
    }

    const PoissonTileParameters& p_;
    StripPieces& pieces_;
    const StripPieces saved_;
    const JointEngines& engines_;
    const ConstructionOptions& options_;
    ConstructionReport& report_;
    const TileRegions regions_;
    const std::uint64_t wanted_;
    std::vector<std::uint8_t> border_axes_;
    const MomentTargets* targets_ = nullptr; ///< of the moments that fillings get, if they do
};

}

PoissonTileSet tile_set_of(const StripPieces& pieces, const PoissonTileParameters& p)
{
    PoissonTileSet set{p, 0, {}};
    const auto append = [&](const TilePosition& point) {
        for (std::size_t k = 0; k < static_cast<std::size_t>(p.dimension); ++k)
            set.points.push_back(static_cast<std::uint16_t>(point[k]));
    };
    for (std::uint32_t tile = 0; tile < p.tiles; ++tile) {
        for (const UnitPosition& point : own_border_points(pieces, p, tile)) append(point);
        for (const TilePosition& point : pieces.interiors[tile]) append(point);
    }
    return set;
}

void relax_together(StripPieces& pieces, const PoissonTileParameters& parameters, const JointEngines& engines,
                    const ConstructionOptions& options, ConstructionReport& report)
{
    StripRelaxation(pieces, parameters, engines, options, report).run();
}

}
