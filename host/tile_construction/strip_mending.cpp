#include "host/tile_construction/strip_mending.hpp"

#include "host/tile_construction/boundary_stages.hpp"
#include "host/tile_construction/fill_stages.hpp"
#include "host/tile_construction/moments/equal_moments.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

namespace poissonlab {

StripMender::StripMender(StripPieces& pieces, const PoissonTileParameters& parameters, const JointEngines& engines,
                         ConstructionReport& report)
    : p_(parameters), pieces_(pieces), saved_(pieces), engines_(engines), report_(report),
      regions_(regions_of(parameters)), wanted_(mending_settings(parameters).wanted)
{
    const bool edges_first = p_.kind == PoissonTileKind::edge;
    for (std::uint8_t axes = 0; axes < all_axes(p_.dimension); ++axes) border_axes_.push_back(axes);
    std::ranges::stable_sort(border_axes_, [&](std::uint8_t a, std::uint8_t b) {
        return edges_first ? std::popcount(a) > std::popcount(b) : std::popcount(a) < std::popcount(b);
    });
}

void StripMender::mend()
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

void StripMender::mend_borders(const PieceStore& before)
{
    Back back;
    mend_borders(before, back);
}

void StripMender::mend_borders(const PieceStore& before, Back& back)
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
StripMender::Borders StripMender::repel_borders(const Back& back)
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
        for (const std::size_t i : fill(cell_of_axes(axes, p_.dimension), problems, targets, 0, nullptr))
            failed.push_back(open[i]);
        if (!failed.empty()) return failed;
    }
    return {};
}

/// The points near the border of template tiles, which meet themselves around a torus of one tile.
StripMender::Borders StripMender::repel_frame(const Back& back)
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
StripMender::Tiles StripMender::mend_tiles(const Back& back)
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
        open = fill_tiles(open, false, attempt, nullptr);
    return open;
}

StripMender::Tiles StripMender::all_tiles() const
{
    Tiles all(p_.tiles);
    std::iota(all.begin(), all.end(), 0u);
    return all;
}

StripMender::Tiles StripMender::fill_tiles(const Tiles& open, bool are_given, std::uint32_t attempt,
                                           const MomentTargets* moments)
{
    std::vector<FillProblem> problems;
    std::vector<PiecePoints*> targets;
    for (const std::uint32_t tile : open) {
        PiecePoints& interior = pieces_.interiors[tile];
        problems.push_back(problem_around(pieces_around(p_, tile), interior, tile));
        if (!are_given) problems.back().given.clear();
        if (moments) problems.back().moments = moments->left_in_units(own_border_points(pieces_.borders, p_, tile));
        targets.push_back(&interior);
    }
    Tiles failed;
    for (const std::size_t i :
         fill(cell_of_axes(all_axes(p_.dimension), p_.dimension), problems, targets, attempt, moments))
        failed.push_back(open[i]);
    return failed;
}

FillProblem StripMender::problem_around(const std::vector<PlacedPiece>& held, const PiecePoints& points,
                                        std::uint32_t stream) const
{
    FillProblem problem;
    problem.held = pieces_.borders.placed(held);
    for (const TilePosition& point : points) problem.given.push_back(on_torus(point));
    problem.active = static_cast<std::uint32_t>(points.size());
    problem.stream = stream;
    problem.classes.resize(p_.classes.count());
    for (const TilePosition& point : points)
        if (!problem.classes.empty()) ++problem.classes[class_of(point, p_)];
    return problem;
}

bool StripMender::is_good(const FillProblem& problem, const FilledTorus& filled) const
{
    return filled.active.size() == problem.active && (problem.active == 0 || filled.squared_min_distance >= wanted_);
}

/// Fills a cell around the lattice point at 0, and takes over what has the distance. Returns the numbers of the
/// others.
std::vector<std::size_t> StripMender::fill(CellSet cells, const std::vector<FillProblem>& problems,
                                           const std::vector<PiecePoints*>& targets, std::uint32_t attempt,
                                           const MomentTargets* moments)
{
    if (problems.empty()) return {};
    FillStage stage{.regions = regions_, .number = moments ? moment_stage : repair_stage, .keep_tiles = true};
    stage.active.cells = cells;
    stage.equal_moments = moments ? moments->order() : 0;
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

CellSet cell_of_axes(std::uint8_t axes, int dimension) { return CellSet{1} << cell_number(axes, 0, dimension); }

}
