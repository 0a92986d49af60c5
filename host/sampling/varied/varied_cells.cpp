#include "host/sampling/varied/varied_cells.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {

using contract::varied_darts::OpenCell;

namespace {

constexpr std::uint32_t saturation_tries = 512; // of which half count, nearly

/// Single positions are not split, so that a fineness beyond the largest distance's says no more.
constexpr std::uint32_t most_fineness = 31;

void append_quarters(std::vector<OpenCell>& to, const OpenCell& cell)
{
    const std::uint32_t bits = cell.bits - 1, half = 1u << bits;
    for (std::uint32_t i = 0; i < 4; ++i) to.push_back({cell.x + i % 2 * half, cell.y + i / 2 * half, bits, 0});
}

/// Rounds a ratio to units of 2^-16, away from 1, as far as whole numbers go.
std::uint32_t rounded_ratio(double ratio)
{
    const double units = ratio * 0x1p16;
    return static_cast<std::uint32_t>(std::clamp(ratio < 1 ? std::floor(units) : std::ceil(units), 0.0, 0x1p31));
}

}

/// No place has a distance of less than 2, so that this cell is split.
VariedCells::VariedCells() { cells_.push_back({0, 0, 31, 1}); }

bool VariedCells::is_coarse(const OpenCell& cell) const
{
    return cell.bits > 0 && std::uint64_t{1} << (cell.bits + fineness_) > cell.least;
}

void VariedCells::refine(const CellLook& look)
{
    if (is_begun_) fineness_ = std::min(fineness_ + 1, most_fineness);
    is_begun_ = true;
    split_coarse(look, true);
    while (std::ranges::any_of(cells_, [&](const OpenCell& cell) { return is_coarse(cell); }))
        split_coarse(look, false);
}

/// Cells keep their order, quarters stand where they came from.
void VariedCells::split_coarse(const CellLook& look, bool looks_at_all)
{
    std::vector<OpenCell> looked_at;
    for (const OpenCell& cell : cells_) {
        if (is_coarse(cell))
            append_quarters(looked_at, cell);
        else if (looks_at_all)
            looked_at.push_back(cell);
    }
    look(looked_at);
    std::vector<OpenCell> next;
    std::size_t at = 0;
    const auto take = [&](std::size_t count) {
        for (const std::size_t end = at + count; at < end; ++at)
            if (looked_at[at].least > 0) next.push_back(looked_at[at]);
    };
    for (const OpenCell& cell : cells_) {
        if (is_coarse(cell))
            take(4);
        else if (looks_at_all)
            take(1);
        else
            next.push_back(cell);
    }
    cells_ = std::move(next);
}

std::uint64_t cell_quotient(std::uint32_t bits, std::uint32_t fineness, std::uint32_t distance)
{
    using contract::varied_darts::QUOTIENT_BITS;
    return std::min((std::uint64_t{1} << (bits + QUOTIENT_BITS + fineness)) / distance,
                    std::uint64_t{1} << QUOTIENT_BITS);
}

std::optional<VariedPlace> varied_dart(const VariedDartRequest& request, const VariedCells& cells, std::uint32_t slot,
                                       std::uint64_t number)
{
    const auto words =
        philox({slot, static_cast<std::uint32_t>(number), static_cast<std::uint32_t>(number >> 32), 0}, request.stream);
    const OpenCell& cell = cells.cells()[std::uint64_t{words[0]} * cells.cells().size() >> 32];
    VariedPlace dart;
    dart.place = {cell.x + static_cast<std::uint32_t>(std::uint64_t{words[2]} >> (32 - cell.bits)),
                  cell.y + static_cast<std::uint32_t>(std::uint64_t{words[3]} >> (32 - cell.bits))};
    dart.distance = request.field->at(dart.place);
    const std::uint64_t quotient = cell_quotient(cell.bits, cells.fineness(), dart.distance);
    if (words[1] >= quotient * quotient >> (2 * contract::varied_darts::QUOTIENT_BITS - 32)) return {};
    if (!request.region->contains(dart.place)) return {};
    return dart;
}

VariedCells first_varied_cells(const VariedDartRequest& request)
{
    VariedCells cells;
    cells.refine([&](std::vector<OpenCell>& all) {
        for (OpenCell& cell : all) cell.least = least_distance_in(request, cell);
    });
    return cells;
}

std::uint32_t least_distance_in(const VariedDartRequest& request, const OpenCell& cell)
{
    const std::uint32_t extent = (1u << cell.bits) - 1;
    const FixedBox box{{cell.x, cell.y}, {cell.x + extent, cell.y + extent}};
    if (request.region->side_of(box) == RegionSide::outside) return 0;
    return request.field->least_in(box.low, cell.bits);
}

/// The rule follows from two places that are too near to each other: their distance t is below the smaller of their
/// distances a and b, or below their mean, and these differ by no more than slope * t: so b is at most (1 + slope) a,
/// or (1 + slope / 2) / (1 - slope / 2) a, and as much the other way round.
contract::varied_darts::DistanceRule distance_rule(const VariedDartRequest& request)
{
    const double half = request.slope / 2;
    const double most = !request.is_mean ? 1 + request.slope : half < 1 ? (1 + half) / (1 - half) : HUGE_VAL;
    const auto nodes = request.field->nodes();
    return {.columns = request.field->columns(),
            .rows = request.field->rows(),
            .is_mean = request.is_mean,
            .scale = 1u << contract::varied_darts::SCALE_BITS,
            .below = rounded_ratio(1 / most),
            .above = rounded_ratio(most),
            .least = request.field->least() - 1,
            .most = std::ranges::max(nodes),
            .buckets = 0,
            .shift = request.field->shift()};
}

std::uint32_t reduced_scale(std::uint32_t scale, double factor) { return static_cast<std::uint32_t>(scale * factor); }

std::uint32_t tries_of(const VariedDartRequest& request)
{
    return request.attempts > 0 ? request.attempts : saturation_tries;
}

}
