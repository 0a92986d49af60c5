#include "host/texture/salience.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace poissonlab {
namespace {

/// Numbers at the places of a rectangle, row by row.
struct PlaceMap
{
    int columns = 0;
    int rows = 0;
    std::vector<float> values;

    float& at(int x, int y)
    {
        return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x)];
    }
    float at(int x, int y) const
    {
        return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x)];
    }
};

/// Sums over all squares of a side, of one channel.
std::vector<std::int64_t> square_sums(const PngPixels& exemplar, ColumnRange range, int channel, int side)
{
    const int width = range.end - range.first, columns = width - side + 1, rows = exemplar.height - side + 1;
    std::vector<std::int64_t> column_sums(static_cast<std::size_t>(width)), sums;
    const auto value = [&](int x, int y) { return exemplar.values[exemplar.at(range.first + x, y, channel)]; };
    for (int y = 0; y < exemplar.height; ++y) {
        std::int64_t sum = 0;
        for (int x = 0; x < width; ++x) {
            std::int64_t& column = column_sums[static_cast<std::size_t>(x)];
            column += value(x, y) - (y >= side ? value(x, y - side) : 0);
            sum += column - (x >= side ? column_sums[static_cast<std::size_t>(x - side)] : 0);
            if (y >= side - 1 && x >= side - 1) sums.push_back(sum);
        }
    }
    sums.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    return sums;
}

/// By how many standard deviations of all such squares each one differs from their mean, in the channel where it is
/// most.
PlaceMap square_deviations(const PngPixels& exemplar, ColumnRange range, int side)
{
    PlaceMap map{range.end - range.first - side + 1, exemplar.height - side + 1, {}};
    map.values.resize(static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows));
    for (int channel = 0; channel < exemplar.channels; ++channel) {
        const std::vector<std::int64_t> sums = square_sums(exemplar, range, channel, side);
        double sum = 0, squares = 0;
        for (const std::int64_t one : sums) sum += static_cast<double>(one);
        const double mean = sum / static_cast<double>(sums.size());
        for (const std::int64_t one : sums) squares += std::pow(static_cast<double>(one) - mean, 2);
        const double spread = std::sqrt(squares / static_cast<double>(sums.size()));
        if (spread == 0) continue;
        for (std::size_t i = 0; i < sums.size(); ++i)
            map.values[i] =
                std::max(map.values[i], static_cast<float>(std::abs(static_cast<double>(sums[i]) - mean) / spread));
    }
    return map;
}

/// The largest value in each square of `side` places.
PlaceMap square_maxima(const PlaceMap& map, int side)
{
    PlaceMap along{map.columns - side + 1, map.rows, {}}, both{along.columns, map.rows - side + 1, {}};
    along.values.resize(static_cast<std::size_t>(along.columns) * static_cast<std::size_t>(along.rows));
    for (int y = 0; y < along.rows; ++y)
        for (int x = 0; x < along.columns; ++x) {
            const float* const first = &map.values[static_cast<std::size_t>(y) * static_cast<std::size_t>(map.columns) +
                                                   static_cast<std::size_t>(x)];
            along.at(x, y) = *std::max_element(first, first + side);
        }
    both.values.resize(static_cast<std::size_t>(both.columns) * static_cast<std::size_t>(both.rows));
    for (int y = 0; y < both.rows; ++y)
        for (int k = 0; k < side; ++k)
            for (int x = 0; x < both.columns; ++x) both.at(x, y) = std::max(both.at(x, y), along.at(x, y + k));
    return both;
}

}

Salience::Salience(const PngPixels& exemplar, ColumnRange columns, int size, int reach)
    : columns_(columns), places_a_row_(columns.end - columns.first - size + 1)
{
    const int rows = exemplar.height - size + 1;
    salience_.resize(static_cast<std::size_t>(places_a_row_) * static_cast<std::size_t>(rows));
    for (int side = 2; side <= reach; side *= 2) {
        // The squares that lie in the middle of a window, which begins at half its side less the reach.
        const PlaceMap maxima = square_maxima(square_deviations(exemplar, columns, side), 2 * reach - side + 1);
        const int margin = size / 2 - reach;
        for (int y = 0; y < rows; ++y)
            for (int x = 0; x < places_a_row_; ++x) {
                float& value = salience_[static_cast<std::size_t>(y) * static_cast<std::size_t>(places_a_row_) +
                                         static_cast<std::size_t>(x)];
                value = std::max(value, maxima.at(x + margin, y + margin));
            }
    }
    sorted_ = salience_;
    std::ranges::sort(sorted_);
}

double Salience::rank(const ExemplarWindow& window) const
{
    const float value = salience_[static_cast<std::size_t>(window.y) * static_cast<std::size_t>(places_a_row_) +
                                  static_cast<std::size_t>(window.x - columns_.first)];
    const auto below = std::ranges::lower_bound(sorted_, value) - sorted_.begin();
    return static_cast<double>(below) / static_cast<double>(sorted_.size());
}

}
