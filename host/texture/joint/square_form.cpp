#include "host/texture/joint/square_form.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace poissonlab {

double product(const Quarters& a, const Quarters& b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::inner_product(a[i].begin(), a[i].end(), b[i].begin(), 0.0);
    return sum;
}

void add_times(Quarters& sums, double times, const Quarters& others)
{
    for (std::size_t i = 0; i < sums.size(); ++i)
        for (std::size_t k = 0; k < 4; ++k) sums[i][k] += times * others[i][k];
}

double middle_at(int place, int size, int ring)
{
    const double from_ring = std::min(place, size - 1 - place) - ring + 0.5,
                 turn = 2 * std::numbers::pi * from_ring / size;
    if (from_ring < 0) return 0;
    return 4 * from_ring < size ? std::sin(turn) * std::sin(turn) : 1;
}

SquareForm::SquareForm(const SetParts& parts, int size, int ring) : parts_(parts), size_(size)
{
    for (int x = 0; 2 * x < size; ++x) {
        const double middle = middle_at(x, size, ring);
        const std::array<double, 2> hats{1 - middle, middle};
        for (std::size_t i = 0; i < 2; ++i) {
            means_[i] += hats[i] * 2 / size;
            for (std::size_t j = 0; j < 2; ++j) products_[i][j] += hats[i] * hats[j] * 2 / size;
        }
    }
    sites_ = sites_of(SetCover(parts, size, 1));
    for (const Site& site : sites_)
        shown_[static_cast<std::size_t>(site.kind)] += static_cast<double>(site.tiles.size());
}

Quarters SquareForm::applied(const Quarters& quarters) const
{
    Quarters result(quarters.size(), {0, 0, 0, 0});
    for (const Site& site : sites_) apply_at(site, quarters, result);
    return result;
}

std::array<std::size_t, 4> SquareForm::hats_at(std::size_t tile, std::size_t quarter) const
{
    const TileParts& t = parts_.tiles[tile];
    const std::size_t vertical = parts_.corners, horizontal = vertical + parts_.vertical.size(),
                      tiles = horizontal + parts_.horizontal.size();
    return {t.corners[quarter], vertical + (quarter % 2 == 0 ? t.west : t.east),
            horizontal + (quarter < 2 ? t.north : t.south), tiles + tile};
}

Quarters SquareForm::field(const std::vector<double>& heights) const
{
    Quarters means(parts_.tiles.size());
    for (std::size_t tile = 0; tile < means.size(); ++tile)
        for (std::size_t k = 0; k < 4; ++k)
            for (std::size_t i = 0; i < 4; ++i) means[tile][k] += weights()[i] * heights[hats_at(tile, k)[i]];
    return means;
}

/// The transpose of field().
std::vector<double> SquareForm::gathered(const Quarters& quarters) const
{
    std::vector<double> sums(hats());
    for (std::size_t tile = 0; tile < quarters.size(); ++tile)
        for (std::size_t k = 0; k < 4; ++k)
            for (std::size_t i = 0; i < 4; ++i) sums[hats_at(tile, k)[i]] += weights()[i] * quarters[tile][k];
    return sums;
}

std::vector<double> SquareForm::best_heights(const Quarters& quarters, double weight) const
{
    std::vector<double> heights(hats()), rest = gathered(applied(quarters));
    for (double& each : rest) each = -each;
    std::vector<double> direction = rest;
    const auto dot = [](const std::vector<double>& a, const std::vector<double>& b) {
        return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
    };
    const double first = dot(rest, rest);
    double now = first;
    for (int step = 0; step < 100 && now > 1e-16 * first; ++step) {
        std::vector<double> image = gathered(applied(field(direction)));
        add_field_squares(direction, weight, image);
        const double length = now / dot(direction, image);
        for (std::size_t i = 0; i < heights.size(); ++i) {
            heights[i] += length * direction[i];
            rest[i] -= length * image[i];
        }
        const double next = dot(rest, rest);
        for (std::size_t i = 0; i < heights.size(); ++i) direction[i] = rest[i] + next / now * direction[i];
        now = next;
    }
    return heights;
}

/// The means of the hats of hats_at() over their quarter.
std::array<double, 4> SquareForm::weights() const
{
    return {means_[0] * means_[0], means_[0] * means_[1], means_[1] * means_[0], means_[1] * means_[1]};
}

/// Adds the slope of half of the mean square of a field, times a weight.
void SquareForm::add_field_squares(const std::vector<double>& heights, double weight, std::vector<double>& slopes) const
{
    const double part = weight / static_cast<double>(4 * parts_.tiles.size());
    for (std::size_t tile = 0; tile < parts_.tiles.size(); ++tile)
        for (std::size_t k = 0; k < 4; ++k) {
            const std::array<std::size_t, 4> at = hats_at(tile, k);
            // The hats 1 and 3 are in the middle along y, 2 and 3 along x.
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t j = 0; j < 4; ++j)
                    slopes[at[i]] += part * products_[i / 2][j / 2] * products_[i % 2][j % 2] * heights[at[j]];
        }
}

/// True if the square around a site shows a quarter of a tile.
bool SquareForm::shows(const PlacedTile& tile, std::size_t quarter) const
{
    const int half = size_ / 2, x = tile.x + static_cast<int>(quarter % 2) * half,
              y = tile.y + static_cast<int>(quarter / 2) * half;
    return x >= -half && x < half && y >= -half && y < half;
}

/// Tiles at one place are as likely as each other, and independent of those at other places. The mean square of a
/// sum over places is then the square of the sum of their means, and the sum of their variances.
void SquareForm::apply_at(const Site& site, const Quarters& quarters, Quarters& result) const
{
    const auto place_of = [&](const PlacedTile& tile) {
        return (tile.y == -size_ ? 2u : 0u) + (tile.x == -size_ ? 1u : 0u);
    };
    const auto part_of = [&](const PlacedTile& tile) {
        double part = 0;
        for (std::size_t k = 0; k < 4; ++k) part += shows(tile, k) ? quarters[tile.tile][k] / 4 : 0;
        return part;
    };
    std::array<double, 4> means{}, counts{};
    for (const PlacedTile& tile : site.tiles) {
        means[place_of(tile)] += part_of(tile);
        ++counts[place_of(tile)];
    }
    double sum = 0;
    for (std::size_t place = 0; place < 4; ++place)
        if (counts[place] > 0) sum += means[place] /= counts[place];
    const double weight = static_cast<double>(site.tiles.size()) / shown_[static_cast<std::size_t>(site.kind)] / 4;
    for (const PlacedTile& tile : site.tiles) {
        const std::size_t place = place_of(tile);
        const double slope = weight / counts[place] * (part_of(tile) + sum - means[place]);
        for (std::size_t k = 0; k < 4; ++k) result[tile.tile][k] += shows(tile, k) ? slope / 4 : 0;
    }
}

}
