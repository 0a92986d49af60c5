#include "host/tile_construction/classes/class_construction.hpp"

#include "base/errors/errors.hpp"
#include "host/tile_construction/boundary_stages.hpp"
#include "host/tile_construction/classes/class_mending.hpp"
#include "host/tile_construction/classes/class_piece_choice.hpp"
#include "host/tile_construction/fill_stages.hpp"
#include "host/tile_construction/piece_store.hpp"
#include "host/tile_construction/strip_relaxation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <stdexcept>

namespace poissonlab {
namespace {

/// Fillings of each torus that candidates for pieces are taken from, and the most until there is one.
constexpr std::uint32_t candidate_attempts = 4, most_piece_attempts = 32;

/// The parameters of what tiles share. Template tiles are corner tiles of a single colour with several insides: the
/// strips of one such tile fit around themselves.
PoissonTileParameters border_parameters(PoissonTileParameters p)
{
    if (p.kind != PoissonTileKind::frame) return p;
    p.kind = PoissonTileKind::corner;
    p.tiles = 1;
    return p;
}

class ClassConstruction
{
public:
    ClassConstruction(const PoissonTileParameters& parameters, ClassTileFiller& filler,
                      const ConstructionOptions& options)
        : p_(parameters), shared_(border_parameters(parameters)), filler_(filler), options_(options),
          regions_(regions_of(shared_)), stages_(boundary_stages(shared_)),
          pieces_(p_.classes.count(), PieceStore(shared_)),
          interiors_(p_.classes.count(), std::vector<PiecePoints>(parameters.tiles))
    {}

    ConstructedTileSet run(JointEngine* joint)
    {
        for (const BoundaryStage& stage : stages_) make_pieces(stage, stage.tori, 0);
        std::vector<std::uint32_t> open(p_.tiles);
        std::iota(open.begin(), open.end(), 0U);
        for (std::uint32_t round = 0; !open.empty(); ++round) {
            const std::vector<std::uint32_t> failed = fill_tiles(open, round);
            if (failed.empty()) break;
            if (round + 1 == max_rounds)
                give_up(fmt::format("tile {}", failed.front()), max_rounds * max_tile_attempts,
                        reached_[failed.front()]);
            open = remake_pieces(failed, round + 1);
        }
        StripPieces made = made_pieces();
        if (are_relaxed_together(p_)) {
            const auto mender = make_class_mender(p_, filler_);
            relax_together(made, p_, {*mender, *joint}, options_, report_);
        }
        ConstructedTileSet constructed{tile_set_of(made, p_), report_};
        constructed.set.class_squared_distances.resize(class_pair_count(p_.classes.count()));
        return constructed;
    }

private:
    // Pieces.

    /// Fills tori and takes the best candidates for the pieces that are made there.
    void make_pieces(const BoundaryStage& stage, const std::vector<BoundaryTorus>& tori, std::uint32_t round)
    {
        FillStage fill_stage{.regions = regions_, .number = stage.number};
        fill_stage.active.cells = all_cells(p_.dimension);
        for (const PlacedPiece& piece : tori.front().held)
            fill_stage.active.cells &= ~(CellSet{1} << cell_number(piece, p_.dimension));

        ClassPieceChoice choice(shared_, regions_, pieces_, stage.is_last);
        std::vector<std::size_t> open(tori.size());
        std::iota(open.begin(), open.end(), std::size_t{0});
        for (std::uint32_t attempt = 0; !open.empty(); ++attempt) {
            if (attempt == most_piece_attempts)
                give_up(fmt::format("one of the {} (number {})", stage.name, tori[open.front()].made.front().variant),
                        attempt, choice.best_failure());
            std::vector<ClassFillProblem> problems;
            for (const std::size_t i : open) problems.push_back(piece_problem(tori[i], i));
            const auto filled = filled_tori(fill_stage, problems, round * attempts_a_round + attempt);
            for (std::size_t i = 0; i < open.size(); ++i) choice.consider(tori[open[i]], filled[i]);
            if (attempt + 1 < candidate_attempts) continue;
            std::erase_if(open, [&](std::size_t i) { return choice.has_all(tori[i]); });
            tell(stage.name, tori.size() - open.size(), tori.size());
        }
        choice.take(pieces_);
    }

    ClassFillProblem piece_problem(const BoundaryTorus& torus, std::size_t number) const
    {
        ClassFillProblem problem{
            .held = placed(torus.held), .active = {}, .stream = static_cast<std::uint32_t>(number)};
        for (std::size_t of = 0; of < pieces_.size(); ++of) {
            const std::uint32_t all = p_.classes.points[of] << p_.dimension;
            problem.active.push_back(all - std::min(all, static_cast<std::uint32_t>(problem.held[of].size())));
        }
        return problem;
    }

    ClassedPositions placed(const std::vector<PlacedPiece>& pieces) const
    {
        ClassedPositions points;
        for (const PieceStore& own : pieces_) points.push_back(own.placed(pieces));
        return points;
    }

    // Interiors.

    /// Returns those that could not be filled.
    std::vector<std::uint32_t> fill_tiles(std::vector<std::uint32_t> open, std::uint32_t round)
    {
        const std::size_t total = open.size();
        std::vector<std::uint32_t> failed; // whose borders have too many points of a class
        std::erase_if(open, [&](std::uint32_t tile) {
            const bool is_too_full = !interior_problem(tile);
            if (is_too_full) failed.push_back(tile);
            return is_too_full;
        });
        const FillStage stage = interior_fill_stage();
        for (std::uint32_t attempt = 0; attempt < max_tile_attempts && !open.empty(); ++attempt) {
            std::vector<ClassFillProblem> problems;
            for (const std::uint32_t tile : open) problems.push_back(*interior_problem(tile));
            const auto filled = filled_tori(stage, problems, round * attempts_a_round + attempt);
            std::vector<std::uint32_t> left;
            for (std::size_t i = 0; i < open.size(); ++i) {
                if (!filled[i].is_good()) {
                    left.push_back(open[i]);
                    reached_[open[i]] = std::max(reached_[open[i]], filled[i].part);
                    continue;
                }
                for (std::size_t of = 0; of < pieces_.size(); ++of)
                    interiors_[of][open[i]] =
                        cut_out(filled[i].active[of], regions_, all_axes(p_.dimension), {}, false);
            }
            open = left;
            tell("tiles", total - open.size() - failed.size(), total);
        }
        failed.insert(failed.end(), open.begin(), open.end());
        std::ranges::sort(failed);
        return failed;
    }

    FillStage interior_fill_stage() const
    {
        FillStage stage{.regions = regions_, .number = interior_stage};
        const auto inside = static_cast<std::uint32_t>(tile_units - 2 * regions_.width + 1);
        stage.active = {CellSet{1} << cell_number(all_axes(p_.dimension), 0, p_.dimension), regions_.width, inside};
        return stage;
    }

    /// Returns nothing where there are too many points of a class around the interior.
    std::optional<ClassFillProblem> interior_problem(std::uint32_t tile) const
    {
        ClassFillProblem problem{.held = placed(border_of(tile)), .active = {}, .stream = tile};
        for (std::size_t of = 0; of < pieces_.size(); ++of) {
            const auto inside = static_cast<std::uint32_t>(std::ranges::count_if(problem.held[of], is_in_tile));
            if (inside > p_.classes.points[of]) return {};
            problem.active.push_back(p_.classes.points[of] - inside);
        }
        return problem;
    }

    /// New last pieces for tiles that could not be filled, one each. Returns all tiles that have these.
    std::vector<std::uint32_t> remake_pieces(const std::vector<std::uint32_t>& failed, std::uint32_t round)
    {
        std::set<std::pair<std::uint8_t, std::uint32_t>> remade;
        for (const std::uint32_t tile : failed) {
            const std::vector<PlacedPiece> last = last_pieces(tile);
            const PlacedPiece& piece = last[(tile + round) % last.size()];
            remade.emplace(piece.axes, piece.variant);
        }
        report_.remade += remade.size();
        const BoundaryStage& stage = stages_.back();
        std::vector<BoundaryTorus> tori;
        for (BoundaryTorus torus : stage.tori) {
            std::erase_if(torus.made, [&](const PlacedPiece& m) { return !remade.contains({m.axes, m.variant}); });
            if (!torus.made.empty()) tori.push_back(torus);
        }
        make_pieces(stage, tori, round);
        std::vector<std::uint32_t> open;
        for (std::uint32_t tile = 0; tile < p_.tiles; ++tile)
            if (std::ranges::any_of(last_pieces(tile), [&](const PlacedPiece& e) {
                    return remade.contains({e.axes, e.variant});
                }))
                open.push_back(tile);
        return open;
    }

    std::vector<PlacedPiece> border_of(std::uint32_t tile) const
    {
        return pieces_around(shared_, tile % shared_.tiles);
    }

    /// The pieces around a tile that are made last: edges, of edge tiles corners.
    std::vector<PlacedPiece> last_pieces(std::uint32_t tile) const
    {
        std::vector<PlacedPiece> pieces = border_of(tile);
        const int extent = p_.kind == PoissonTileKind::edge ? 0 : 1;
        std::erase_if(pieces, [&](const PlacedPiece& piece) { return std::popcount(piece.axes) != extent; });
        return pieces;
    }

    /// All pieces, whose points know their class.
    StripPieces made_pieces() const
    {
        const auto add = [](PiecePoints& all, const PiecePoints& own, std::size_t of) {
            for (const TilePosition& point : own) all.push_back({point[0], point[1], static_cast<std::int32_t>(of)});
        };
        StripPieces made{PieceStore(shared_), std::vector<PiecePoints>(p_.tiles)};
        for (std::size_t of = 0; of < pieces_.size(); ++of) {
            for (std::uint8_t axes = 0; axes < all_axes(p_.dimension); ++axes)
                for (std::uint32_t variant = 0; variant < piece_count(shared_, axes); ++variant)
                    add(made.borders.at(axes, variant), pieces_[of].at(axes, variant), of);
            for (std::uint32_t tile = 0; tile < p_.tiles; ++tile) add(made.interiors[tile], interiors_[of][tile], of);
        }
        return p_.kind == PoissonTileKind::frame ? in_frame(made) : made;
    }

    /// The pieces by the regions of template tiles, whose corners are smaller.
    StripPieces in_frame(const StripPieces& made) const
    {
        const TileRegions frame = regions_of(p_);
        StripPieces framed{PieceStore(p_), {}};
        std::vector<TilePosition> points = made.borders.placed(border_of(0));
        for (const std::uint8_t axes : std::array<std::uint8_t, 3>{0, 1, 2})
            framed.borders.at(axes, 0) = cut_out(points, frame, axes, {}, false);
        const PiecePoints border_inside = cut_out(points, frame, all_axes(2), {}, false);
        for (const PiecePoints& interior : made.interiors) {
            framed.interiors.push_back(border_inside);
            framed.interiors.back().insert(framed.interiors.back().end(), interior.begin(), interior.end());
        }
        return framed;
    }

    // Filling, telling, and giving up.

    std::vector<ClassFilledTorus> filled_tori(const FillStage& stage, const std::vector<ClassFillProblem>& problems,
                                              std::uint32_t attempt)
    {
        std::vector<ClassFilledTorus> filled = filler_.fill(stage, problems, attempt);
        report_.tori += filled.size();
        report_.failures += static_cast<std::size_t>(
            std::ranges::count_if(filled, [](const ClassFilledTorus& torus) { return !torus.is_good(); }));
        return filled;
    }

    void tell(const std::string& stage, std::size_t done, std::size_t total) const
    {
        if (options_.progress) options_.progress(stage, done, total);
    }

    [[noreturn]] void give_up(const std::string& what, std::uint32_t attempts, std::uint32_t part) const
    {
        const std::string reached = part == 0 ? "has no room for its points"
                                              : fmt::format("reached {:.4f} of the distances",
                                                            std::sqrt(static_cast<double>(part) / whole_part));
        throw InputError(fmt::format("tiles with {} points of classes: {} {} after {} attempts; a smaller "
                                     "relative_radius or smaller distances may help",
                                     fmt::join(p_.classes.points, ", "), what, reached, attempts));
    }

    const PoissonTileParameters p_, shared_; ///< of tiles, and of what they share
    ClassTileFiller& filler_;
    const ConstructionOptions& options_;
    TileRegions regions_;
    std::vector<BoundaryStage> stages_;
    ClassPieceStores pieces_;
    std::vector<std::vector<PiecePoints>> interiors_; ///< by class and tile
    std::map<std::uint32_t, std::uint32_t> reached_;  ///< parts of squared distances, of tiles that failed
    ConstructionReport report_;
};

}

ConstructedTileSet construct_class_tiles(const PoissonTileParameters& parameters, ClassTileFiller& filler,
                                         const ConstructionOptions& options, JointEngine* joint)
{
    check(parameters);
    if (are_relaxed_together(parameters) && !joint) throw std::logic_error("joint iterations need their engine");
    return ClassConstruction(parameters, filler, options).run(joint);
}

DeviceMemory class_construction_memory(const PoissonTileParameters& p)
{
    std::size_t tori = p.tiles;
    for (const BoundaryStage& stage : boundary_stages(border_parameters(p))) tori = std::max(tori, stage.tori.size());
    return class_filling_memory(p.classes.count(), tori, std::size_t{p.points_per_tile} << p.dimension) +
           joint_memory_of(p);
}

}
