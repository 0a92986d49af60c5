// The integral of x dy around what a square and the region have in common: an edge counts in its own square by its
// distance from the left side, and in those to the left of it in the same row by their width.
#include "base/regions/region_shares.hpp"

#include <algorithm>
#include <functional>

namespace poissonlab {
namespace {

/// Places of a square along each axis by which one tells how much of it margins take.
constexpr std::uint32_t share_places = 8;

class ShareSums
{
public:
    ShareSums(std::uint32_t columns, std::uint32_t rows) : columns_(columns), rows_(rows) {}

    /// An edge, in squares, with the region on its left.
    void add(double x0, double y0, double x1, double y1)
    {
        const auto [low, high] = std::minmax(y0, y1);
        const auto at = [&](double y) { return y1 == y0 ? x0 : x0 + (x1 - x0) * (y - y0) / (y1 - y0); };
        for (std::uint32_t row = row_of(low); row < rows_ && row < high; ++row) {
            const double from = std::max(low, double{1} * row), to = std::min(high, row + 1.0);
            if (y1 > y0)
                add_in_row(row, at(from), at(to), to - from);
            else
                add_in_row(row, at(to), at(from), from - to);
        }
    }

    /// Begins the sums. Ask for the shares of squares in falling order of their numbers, which go row by row.
    void begin()
    {
        std::ranges::stable_sort(pieces_, std::greater{}, &Piece::square);
        next_ = 0;
        last_ = UINT64_MAX;
        share_ = right_ = 0;
    }

    double share_of(std::uint64_t square)
    {
        while (next_ < pieces_.size() && pieces_[next_].square >= square) sum_next();
        if (last_ == square) return std::clamp(share_, 0.0, 1.0);
        return last_ / columns_ == square / columns_ ? std::clamp(right_, 0.0, 1.0) : 0;
    }

private:
    struct Piece
    {
        std::uint64_t square;
        double share, beyond; ///< what an edge adds to the share of its own square, and of each square to its left
    };

    /// Goes on to the next square with edges.
    void sum_next()
    {
        const std::uint64_t square = pieces_[next_].square;
        double share = 0, beyond = 0;
        for (; next_ < pieces_.size() && pieces_[next_].square == square; ++next_) {
            share += pieces_[next_].share;
            beyond += pieces_[next_].beyond;
        }
        if (last_ / columns_ != square / columns_) right_ = 0;
        last_ = square;
        share_ = share + right_;
        right_ += beyond;
    }

    std::uint32_t row_of(double y) const { return static_cast<std::uint32_t>(std::max(0.0, y)); }
    std::uint32_t column_of(double x) const
    {
        return std::min(static_cast<std::uint32_t>(std::max(0.0, x)), columns_ - 1);
    }

    /// A piece that rises by `rise` in a row, cut at the sides of squares.
    void add_in_row(std::uint32_t row, double x0, double x1, double rise)
    {
        const auto [low, high] = std::minmax(x0, x1);
        for (std::uint32_t column = column_of(low); column <= column_of(high); ++column) {
            const double from = std::max(low, double{1} * column);
            const double to = column == columns_ - 1 ? high : std::min(high, column + 1.0);
            const double part = high > low ? (to - from) / (high - low) * rise : rise;
            pieces_.push_back({std::uint64_t{row} * columns_ + column, ((from + to) / 2 - column) * part, part});
        }
    }

    std::uint32_t columns_, rows_;
    std::vector<Piece> pieces_;
    std::size_t next_ = 0;
    std::uint64_t last_ = UINT64_MAX; ///< the last square with edges that was summed
    /// the share of that square, and of the squares between it and the next one to its left
    double share_ = 0, right_ = 0;
};

}

namespace {

ShareSums share_sums(const FixedRegion& region, const ShareLattice& lattice)
{
    ShareSums sums(lattice.columns, lattice.rows);
    const auto place = [&](std::uint32_t position, std::size_t k) {
        return (position - lattice.low[k]) / lattice.side;
    };
    for (const FixedEdge& e : region.directed_boundary())
        sums.add(place(e[0], 0), place(e[1], 1), place(e[2], 0), place(e[3], 1));
    sums.begin();
    return sums;
}

}

std::vector<double> region_shares(const FixedRegion& region, const ShareLattice& lattice)
{
    ShareSums sums = share_sums(region, lattice);
    std::vector<double> shares(std::size_t{lattice.columns} * lattice.rows);
    for (std::size_t square = shares.size(); square-- > 0;) shares[square] = sums.share_of(square);
    return shares;
}

std::vector<double> region_shares(const FixedRegion& region, const ShareLattice& lattice,
                                  std::span<const std::array<std::uint32_t, 2>> squares)
{
    ShareSums sums = share_sums(region, lattice);
    std::vector<double> shares(squares.size());
    for (std::size_t i = squares.size(); i-- > 0;)
        shares[i] = sums.share_of(std::uint64_t{squares[i][1]} * lattice.columns + squares[i][0]);
    return shares;
}

double part_left_by_margins(const FixedRegion& region, const std::array<double, 2>& low, double side)
{
    if (region.squared_margins() == std::array<std::uint64_t, 3>{}) return 1;
    const double step = side / share_places;
    double inside = 0, left = 0;
    for (std::uint32_t y = 0; y < share_places; ++y)
        for (std::uint32_t x = 0; x < share_places; ++x) {
            const TorusPoint<2> place{static_cast<std::uint32_t>(low[0] + (x + 0.5) * step),
                                      static_cast<std::uint32_t>(low[1] + (y + 0.5) * step)};
            inside += region.contains_moved(place);
            left += region.contains(place);
        }
    return inside > 0 ? left / inside : 1;
}

}
