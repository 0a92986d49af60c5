#include "tiles/lattice_rows.hpp"

#include <algorithm>

namespace poissonlab {

const std::uint8_t* LatticeRows::row(unsigned series, const ColorHash& hash, std::int64_t x, std::int64_t y,
                                     std::uint64_t step, std::size_t count)
{
    auto& kept = kept_[series];
    unsigned& newest = newest_[series];
    for (unsigned i = 0; i < 2; ++i) {
        const Row& row = kept[i];
        if (row.x != x || row.y != y || row.step != step || row.count != count) continue;
        newest = i;
        return row.colors.data();
    }
    newest = 1 - newest;
    Row& row = kept[newest];
    row.x = x;
    row.y = y;
    row.step = step;
    row.count = count;
    if (row.colors.size() < count) row.colors.resize(count);
    evaluate(row, hash);
    return row.colors.data();
}

void LatticeRows::evaluate(Row& row, const ColorHash& hash) const
{
    const Torus torus{period_};
    // Hash functions are asked for runs that end where coordinates start again.
    const auto last = static_cast<std::uint64_t>(period_.x == 0 ? INT64_MAX : period_.x - 1);
    const std::int64_t y = torus.y(row.y);
    std::int64_t x = torus.x(row.x);
    std::span<std::uint8_t> left(row.colors.data(), row.count);
    std::visit(
        [&](const auto& h) {
            while (!left.empty()) {
                const std::uint64_t run = (last - static_cast<std::uint64_t>(x)) / row.step + 1;
                const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(left.size(), run));
                h.fill_row(x, static_cast<std::int64_t>(row.step), y, left.first(count));
                left = left.subspan(count);
                x = torus.x(stepped(x, count * row.step));
            }
        },
        hash);
}

}
