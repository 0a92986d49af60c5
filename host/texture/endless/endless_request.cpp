#include "host/texture/endless/endless_request.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {

int EndlessRequest::cell_of(const PngPixels& exemplar) const
{
    const int side = std::min(exemplar.width, exemplar.height);
    // 2 sqrt 3 = 3.4641...
    const int pixels = cell.value_or(method == EndlessMethod::offsets ? side / 3 : side * 1000 / 3464);
    return std::clamp(pixels - pixels % 2, least_endless_cell, most_endless_cell);
}

int EndlessRequest::row_of(const PngPixels& exemplar) const
{
    const int side = cell_of(exemplar);
    if (!has_hexagons()) return side;
    return static_cast<int>((std::int64_t{side} * 866'025 + 500'000) / 1'000'000); // sqrt 3 / 2
}

void check(const EndlessRequest& request, const PngPixels& exemplar)
{
    const int side = std::min(exemplar.width, exemplar.height);
    if (request.method == EndlessMethod::quilted) {
        if (request.block > side)
            throw invalid_value({}, "block", std::to_string(request.block),
                                fmt::format("must be at most the exemplar's side, {} pixels", side));
        return;
    }
    if (request.method == EndlessMethod::repeated) return;
    // Pieces reach one cell to either side of a lattice point, turned ones two pixels more, squares three quarters of a
    // cell.
    const int beyond = request.turn > 0 ? 2 : 0;
    const int most = request.tileable ? side : request.has_hexagons() ? (side - 1) / 2 - beyond : 2 * (side - 3) / 3;
    if (most < least_endless_cell)
        throw InputError(fmt::format("exemplar: {} x {} pixels: must have more for pieces of {} pixels", exemplar.width,
                                     exemplar.height, least_endless_cell));
    if (request.cell_of(exemplar) > most)
        throw invalid_value(
            {}, "cell", std::to_string(request.cell_of(exemplar)),
            fmt::format("must be at most {}, so that pieces of the exemplar, {} x {} pixels, are inside "
                        "of it{}",
                        most - most % 2, exemplar.width, exemplar.height,
                        request.tileable ? "" : ", unless it is tileable"));
}

std::optional<int> fetches_of(const EndlessRequest& request, int channels)
{
    switch (request.method) {
    case EndlessMethod::repeated:
        return 1;
    case EndlessMethod::offsets:
        return 4;
    case EndlessMethod::hexagons:
        return 3;
    case EndlessMethod::blended:
        return 3 + channels;
    case EndlessMethod::quilted:
        return std::nullopt;
    }
    return std::nullopt;
}

}
