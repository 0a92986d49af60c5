#include "host/tile_construction/tile_construction.hpp"

#include "base/errors/errors.hpp"
#include "host/tile_construction/boundary_stages.hpp"
#include "host/tile_construction/fill_stages.hpp"
#include "host/tile_construction/moments/moment_targets.hpp"
#include "host/tile_construction/piece_choice.hpp"
#include "host/tile_construction/piece_store.hpp"
#include "host/tile_construction/strip_relaxation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>

namespace poissonlab {
namespace {

/// A torus succeeds in one or two attempts or hardly ever.
constexpr std::uint32_t max_piece_attempts = 24;

class Construction
{
public:
    Construction(const PoissonTileParameters& parameters, TileFiller& filler, const ConstructionOptions& options)
        : p_(parameters), filler_(filler), options_(options),
          regions_(regions_of(parameters)), made_{PieceStore(parameters), std::vector<PiecePoints>(parameters.tiles)},
          wanted_(asked_squared_distance(parameters))
    {}

    ConstructedTileSet run(const JointEngines* together)
    {
        make_boundaries();
        std::vector<std::uint32_t> open;
        // The first of template tiles is the master.
        for (std::uint32_t tile = p_.kind == PoissonTileKind::frame; tile < p_.tiles; ++tile) open.push_back(tile);
        for (std::uint32_t round = 0; !open.empty(); ++round) {
            const std::vector<std::uint32_t> failed = fill_tiles(open, round);
            if (failed.empty()) break;
            if (round + 1 == max_rounds) give_up_tile(failed);
            open = remake_boundaries(failed, round + 1);
        }
        if (are_relaxed_together(p_)) relax_together(made_, p_, *together, options_, report_);
        return {tile_set_of(made_, p_), report_};
    }

private:
    // Pieces.

    void make_boundaries()
    {
        if (p_.kind == PoissonTileKind::frame) {
            make_frame(0);
            return;
        }
        stages_ = boundary_stages(p_);
        for (const BoundaryStage& stage : stages_) make_pieces(stage, stage.tori, 0);
    }

    /// Fills tori and takes the best candidates for the pieces that are made there.
    void make_pieces(const BoundaryStage& stage, const std::vector<BoundaryTorus>& tori, std::uint32_t round)
    {
        FillStage fill_stage{.regions = regions_, .number = stage.number};
        fill_stage.active.cells = all_cells(p_.dimension);
        for (const PlacedPiece& piece : tori.front().held)
            fill_stage.active.cells &= ~(CellSet{1} << cell_number(piece, p_.dimension));

        PieceChoice choice(p_, regions_, pieces_, stage.is_last);
        std::vector<std::size_t> open(tori.size());
        std::iota(open.begin(), open.end(), std::size_t{0});
        for (std::uint32_t attempt = 0; !open.empty(); ++attempt) {
            if (attempt == max_piece_attempts) give_up_piece(stage, tori[open.front()], choice.best_failure());
            std::vector<FillProblem> problems;
            for (const std::size_t i : open) problems.push_back(piece_problem(tori[i], i));
            std::vector<FilledTorus> filled = filler_.fill(fill_stage, problems, round * attempts_a_round + attempt);
            count(filled);
            for (std::size_t i = 0; i < open.size(); ++i)
                choice.consider(tori[open[i]], std::move(problems[i]), std::move(filled[i]));
            std::erase_if(open, [&](std::size_t i) { return choice.has_all(tori[i]); });
            tell(stage.name, tori.size() - open.size(), tori.size());
        }
        choice.take(pieces_, options_.record);
    }

    FillProblem piece_problem(const BoundaryTorus& torus, std::size_t number) const
    {
        FillProblem problem;
        problem.held = pieces_.placed(torus.held);
        const std::uint32_t all = p_.points_per_tile << p_.dimension;
        problem.active = all - std::min(all, static_cast<std::uint32_t>(problem.held.size()));
        problem.stream = static_cast<std::uint32_t>(number);
        return problem;
    }

    /// A toroidal master tile, whose points near the border all tiles have.
    void make_frame(std::uint32_t round)
    {
        FillStage stage{.regions = regions_, .number = frame_stage, .is_one_tile = true};
        stage.active = {all_cells(2), 0, tile_units};
        std::vector<FillProblem> problems(master_tiles);
        for (std::size_t i = 0; i < master_tiles; ++i) {
            problems[i].active = p_.points_per_tile;
            problems[i].stream = static_cast<std::uint32_t>(i);
        }
        const double expected = p_.points_per_tile * (1 - regions_.volume(all_axes(2)));
        double best = 1e300;
        std::uint64_t reached = 0;
        for (std::uint32_t attempt = 0; attempt < max_piece_attempts && best == 1e300; ++attempt) {
            const std::vector<FilledTorus> filled = filler_.fill(stage, problems, round * attempts_a_round + attempt);
            count(filled);
            for (std::size_t i = 0; i < filled.size(); ++i) {
                reached = std::max(reached, filled[i].squared_min_distance);
                if (filled[i].squared_min_distance < wanted_) continue;
                const PiecePoints interior = cut_out(filled[i].active, regions_, all_axes(2), {}, true);
                const double miss = std::abs(static_cast<double>(p_.points_per_tile - interior.size()) - expected);
                if (miss >= best) continue;
                best = miss;
                interiors_[0] = interior;
                for (const std::uint8_t axes : std::array<std::uint8_t, 3>{0, 1, 2})
                    pieces_.at(axes, 0) = cut_out(filled[i].active, regions_, axes, {}, true);
                master_ = {problems[i], filled[i]};
            }
        }
        if (best == 1e300) give_up("master tile", max_piece_attempts, reached);
        if (options_.record) options_.record({all_axes(2), 0, {}, {}, &master_.first, &master_.second});
        tell("master tile", 1, 1);
    }

    // Interiors.

    /// Returns those that could not be filled.
    std::vector<std::uint32_t> fill_tiles(std::vector<std::uint32_t> open, std::uint32_t round)
    {
        const std::size_t total = open.size();
        FillStage stage = interior_fill_stage(open.front());
        for (std::uint32_t attempt = 0; attempt < max_tile_attempts && !open.empty(); ++attempt) {
            std::vector<FillProblem> problems;
            for (const std::uint32_t tile : open) problems.push_back(interior_problem(tile));
            const std::vector<FilledTorus> filled = filler_.fill(stage, problems, round * attempts_a_round + attempt);
            count(filled);
            std::vector<std::uint32_t> left;
            for (std::size_t i = 0; i < open.size(); ++i) {
                if (filled[i].squared_min_distance < wanted_ || too_many_held_.contains(open[i])) {
                    left.push_back(open[i]);
                    reached_[open[i]] = std::max(reached_[open[i]], filled[i].squared_min_distance);
                    continue;
                }
                interiors_[open[i]] = cut_out(filled[i].active, regions_, all_axes(p_.dimension), {}, false);
                if (options_.record) {
                    options_.record(
                        {all_axes(p_.dimension), open[i], {}, pieces_around(p_, open[i]), &problems[i], &filled[i]});
                }
            }
            open = left;
            tell("tiles", total - open.size(), total);
        }
        return open;
    }

    FillStage interior_fill_stage(std::uint32_t any_tile) const
    {
        FillStage stage{.regions = regions_, .number = interior_stage};
        CellSet held = 0;
        for (const PlacedPiece& piece : pieces_around(p_, any_tile))
            held |= CellSet{1} << cell_number(piece, p_.dimension);
        const CellSet interior = CellSet{1} << cell_number(all_axes(p_.dimension), 0, p_.dimension);
        const auto inside = static_cast<std::uint32_t>(tile_units - 2 * regions_.width + 1);
        stage.active = {interior, regions_.width, inside};
        stage.surroundings = {all_cells(p_.dimension) & ~held & ~interior, -margin(),
                              static_cast<std::uint32_t>(tile_units + 2 * margin())};
        stage.surroundings_move = p_.dimension == 2;
        return stage;
    }

    std::int32_t margin() const { return surroundings_margin(regions_, p_.dimension); }

    FillProblem interior_problem(std::uint32_t tile)
    {
        FillProblem problem;
        problem.held = pieces_.placed(pieces_around(p_, tile));
        problem.stream = tile;
        const auto inside = static_cast<std::uint32_t>(std::ranges::count_if(problem.held, [&](const TilePosition& h) {
            return h[0] < tile_units && h[1] < tile_units && h[2] < tile_units;
        }));
        if (inside > p_.points_per_tile) too_many_held_.insert(tile);
        problem.active = p_.points_per_tile - std::min(inside, p_.points_per_tile);
        if (p_.lloyd_iterations == 0) return problem;
        // The surroundings of the tile get as many points as the density asks for.
        const double side = 1 + 2.0 * margin() / tile_units;
        const double around = p_.points_per_tile * (std::pow(side, p_.dimension) - 1);
        const double missing = around - static_cast<double>(problem.held.size() - inside);
        problem.surroundings = static_cast<std::uint32_t>(std::max(0.0, std::round(missing)));
        return problem;
    }

    /// New last pieces for tiles that could not be filled, one each. Returns all tiles that have these.
    std::vector<std::uint32_t> remake_boundaries(const std::vector<std::uint32_t>& failed, std::uint32_t round)
    {
        too_many_held_.clear();
        std::vector<std::uint32_t> open;
        if (p_.kind == PoissonTileKind::frame) {
            make_frame(round);
            ++report_.remade;
            for (std::uint32_t tile = 1; tile < p_.tiles; ++tile) open.push_back(tile);
            return open;
        }
        std::set<std::pair<std::uint8_t, std::uint32_t>> remade;
        for (const std::uint32_t tile : failed) {
            const std::vector<PlacedPiece> last = last_pieces(tile);
            const PlacedPiece& piece = last[(tile + round) % last.size()];
            remade.emplace(piece.axes, piece.variant);
        }
        report_.remade += remade.size();
        for (const BoundaryStage& stage : stages_) {
            if (!stage.is_last) continue;
            std::vector<BoundaryTorus> tori;
            for (BoundaryTorus torus : stage.tori) {
                std::erase_if(torus.made, [&](const PlacedPiece& m) { return !remade.contains({m.axes, m.variant}); });
                if (!torus.made.empty()) tori.push_back(torus);
            }
            if (!tori.empty()) make_pieces(stage, tori, round);
        }
        for (std::uint32_t tile = 0; tile < p_.tiles; ++tile) {
            const std::vector<PlacedPiece> last = last_pieces(tile);
            if (std::ranges::any_of(last, [&](const PlacedPiece& l) { return remade.contains({l.axes, l.variant}); }))
                open.push_back(tile);
        }
        return open;
    }

    /// The pieces around a tile that are made last.
    std::vector<PlacedPiece> last_pieces(std::uint32_t tile) const
    {
        std::vector<PlacedPiece> pieces = pieces_around(p_, tile);
        const auto is_last = [&](const PlacedPiece& piece) {
            if (p_.kind == PoissonTileKind::edge) return piece.axes == 0;
            return std::popcount(piece.axes) == p_.dimension - 1;
        };
        std::erase_if(pieces, [&](const PlacedPiece& piece) { return !is_last(piece); });
        return pieces;
    }

    // Telling, and giving up.

    void count(const std::vector<FilledTorus>& filled)
    {
        report_.tori += filled.size();
        report_.failures += static_cast<std::size_t>(std::ranges::count_if(
            filled, [&](const FilledTorus& torus) { return torus.squared_min_distance < wanted_; }));
    }

    void tell(const std::string& stage, std::size_t done, std::size_t total) const
    {
        if (options_.progress) options_.progress(stage, done, total);
    }

    [[noreturn]] void give_up(const std::string& what, std::uint32_t attempts, std::uint64_t squared_reached) const
    {
        const std::string reached = squared_reached == 0
                                        ? "its points did not fit"
                                        : fmt::format("reached {:.4f}", relative_radius_of(squared_reached, p_));
        const std::string advice = p_.repulsion
                                       ? "a smaller relative radius"
                                       : "repulsion, more iterations of Lloyd's method or a smaller relative radius";
        throw InputError(fmt::format("a relative radius of {}: {} of the {} tile set {} after {} attempts; {} may help",
                                     p_.relative_radius, what, kind_name(p_), reached, attempts, advice));
    }

    [[noreturn]] void give_up_piece(const BoundaryStage& stage, const BoundaryTorus& torus,
                                    std::uint64_t squared_reached) const
    {
        give_up(fmt::format("one of the {} (number {})", stage.name, torus.made.front().variant), max_piece_attempts,
                squared_reached);
    }

    [[noreturn]] void give_up_tile(const std::vector<std::uint32_t>& failed) const
    {
        give_up(fmt::format("tile {}", failed.front()), max_rounds * max_tile_attempts, reached_.at(failed.front()));
    }

    const PoissonTileParameters p_;
    TileFiller& filler_;
    const ConstructionOptions& options_;
    TileRegions regions_;
    StripPieces made_;
    PieceStore& pieces_ = made_.borders;
    std::vector<PiecePoints>& interiors_ = made_.interiors;
    std::vector<BoundaryStage> stages_;
    std::pair<FillProblem, FilledTorus> master_;
    std::set<std::uint32_t> too_many_held_;
    std::uint64_t wanted_;
    std::map<std::uint32_t, std::uint64_t> reached_; ///< squared distances of tiles that failed
    ConstructionReport report_;
};

}

FillSettings mending_settings(const PoissonTileParameters& parameters)
{
    PoissonTileParameters p = parameters;
    p.repulsion = true;
    p.lloyd_iterations = 0;
    const double distance = asked_min_distance(p) * tile_units;
    if (p.equal_moments > 0) p.relative_radius *= (distance + moment_margin(p)) / distance;
    return fill_settings(p);
}

ConstructedTileSet construct_tile_set(const PoissonTileParameters& parameters, TileFiller& filler,
                                      const ConstructionOptions& options, const JointEngines* together)
{
    check(parameters);
    if (are_relaxed_together(parameters) && !together) throw std::logic_error("joint iterations need their engines");
    return Construction(parameters, filler, options).run(together);
}

}
