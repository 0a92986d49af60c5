// Stamps on paper: pictures that are turned, made smaller and laid over each other, in light.
#include "base/images/linear_picture.hpp"
#include "base/images/srgb_light.hpp"
#include "base/programs/interrupt.hpp"
#include "host/distribution/recursive_tiles/recursive_tile_run.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

/// Red, green and blue in light, multiplied by the fourth number, what is covered.
using Paint = std::array<float, 4>;

struct Stamp
{
    int width = 0, height = 0;
    std::vector<Paint> pixels; ///< row by row from the top
    double wide = 0, high = 0; ///< what the picture takes of them, from the top left

    const Paint& at(int column, int row) const
    {
        return pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(column)];
    }
    double longest() const { return std::max(wide, high); }
};

Stamp stamp_of(const LinearPicture& picture)
{
    Stamp stamp{picture.width, picture.height, {}, 1.0 * picture.width, 1.0 * picture.height};
    const std::size_t colors = picture.channels.size() - (picture.alpha ? 1 : 0);
    for (int row = 0; row < picture.height; ++row)
        for (int column = 0; column < picture.width; ++column) {
            Paint paint{0, 0, 0, cover_at(picture, column, row)};
            for (std::size_t k = 0; k < 3; ++k) {
                const float light = picture.at(column, row, colors >= 3 ? k : 0);
                paint[k] = light > 0 ? std::min(light, 1.F) : 0; // no number is no light
            }
            stamp.pixels.push_back(paint);
        }
    return stamp;
}

/// A black dot, half as wide as its square.
Stamp dot_stamp()
{
    constexpr int side = 64;
    Stamp stamp{side, side, {}, side, side};
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const double away = std::hypot(column - (side - 1) / 2.0, row - (side - 1) / 2.0);
            stamp.pixels.push_back({0, 0, 0, static_cast<float>(std::clamp(side / 4.0 + 0.5 - away, 0.0, 1.0))});
        }
    return stamp;
}

/// A stamp of half the size, for stamps that are drawn smaller than they are.
Stamp halved(const Stamp& stamp)
{
    Stamp half{(stamp.width + 1) / 2, (stamp.height + 1) / 2, {}, stamp.wide / 2, stamp.high / 2};
    for (int row = 0; row < half.height; ++row)
        for (int column = 0; column < half.width; ++column) {
            Paint sum{};
            for (int k = 0; k < 4; ++k) {
                const int x = 2 * column + k % 2, y = 2 * row + k / 2;
                if (x >= stamp.width || y >= stamp.height) continue; // nothing is there
                for (std::size_t channel = 0; channel < 4; ++channel) sum[channel] += stamp.at(x, y)[channel] / 4;
            }
            half.pixels.push_back(sum);
        }
    return half;
}

/// The paint of a place of a stamp in its pixels, from the top left: linear between the middles of pixels.
Paint paint_at(const Stamp& stamp, double x, double y)
{
    const double column = std::floor(x - 0.5), row = std::floor(y - 0.5);
    const auto right = static_cast<float>(x - 0.5 - column), down = static_cast<float>(y - 0.5 - row);
    Paint sum{};
    for (int k = 0; k < 4; ++k) {
        const int at_column = static_cast<int>(column) + k % 2, at_row = static_cast<int>(row) + k / 2;
        if (at_column < 0 || at_row < 0 || at_column >= stamp.width || at_row >= stamp.height) continue;
        const float part = (k % 2 == 1 ? right : 1 - right) * (k / 2 == 1 ? down : 1 - down);
        for (std::size_t channel = 0; channel < 4; ++channel)
            sum[channel] += part * stamp.at(at_column, at_row)[channel];
    }
    return sum;
}

/// The paper, and the stamps in all sizes.
class Paper
{
public:
    Paper(int width, int height) : width_(width), height_(height)
    {
        light_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), {1, 1, 1});
    }

    /// Lays a stamp around a place in pixels, from the top left; its longest side is `size` pixels.
    void lay(const std::vector<Stamp>& sizes, double x, double y, double size, double turn)
    {
        std::size_t which = 0;
        while (which + 1 < sizes.size() && sizes[which].longest() >= 2 * size) ++which;
        const Stamp& stamp = sizes[which];
        const double scale = stamp.longest() / size, reach = size * 0.7072 + 1;
        const double c = std::cos(turn) * scale, s = std::sin(turn) * scale;
        const auto first = [](double v) { return std::max(0, static_cast<int>(std::floor(v))); };
        const int last_column = std::min(width_ - 1, static_cast<int>(std::floor(x + reach)));
        const int last_row = std::min(height_ - 1, static_cast<int>(std::floor(y + reach)));
        for (int row = first(y - reach); row <= last_row; ++row) {
            stop_if_interrupted();
            for (int column = first(x - reach); column <= last_column; ++column) {
                Paint mean{};
                for (int k = 0; k < 4; ++k) { // a quarter of a pixel each
                    const double dx = column + 0.25 + 0.5 * (k % 2) - x, up = y - (row + 0.25 + 0.5 * (k / 2));
                    const Paint paint =
                        paint_at(stamp, stamp.wide / 2 + c * dx + s * up, stamp.high / 2 - (c * up - s * dx));
                    for (std::size_t channel = 0; channel < 4; ++channel) mean[channel] += paint[channel] / 4;
                }
                auto& light = light_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                                     static_cast<std::size_t>(column)];
                for (std::size_t channel = 0; channel < 3; ++channel)
                    light[channel] = light[channel] * (1 - mean[3]) + mean[channel];
            }
        }
    }

    PngPixels pixels() const
    {
        PngPixels png{width_, height_, 3, {}};
        for (const auto& light : light_)
            for (const float v : light) png.values.push_back(byte_of_light(65535 * std::clamp(v, 0.F, 1.F)));
        return png;
    }

private:
    int width_, height_;
    std::vector<std::array<float, 3>> light_;
};

}

int painting_height(const RecursiveWindow& window, int pixels)
{
    return std::max(1, static_cast<int>(std::lround(static_cast<double>(pixels) * window.size[1] / window.size[0])));
}

PngPixels painting(const RecursiveTileSettings& settings, const StampedWindow& window, int pixels)
{
    std::vector<std::vector<Stamp>> stamps;
    for (const std::filesystem::path& file : settings.stamps) stamps.push_back({stamp_of(read_linear_picture(file))});
    if (stamps.empty()) stamps.push_back({dot_stamp()});
    for (auto& sizes : stamps)
        while (sizes.back().longest() > 2) sizes.push_back(halved(sizes.back()));
    const auto& size = settings.window.size;
    const double tile = static_cast<double>(pixels) / size[0];
    Paper paper(pixels, painting_height(settings.window, pixels));
    for (const StampedPoint& point : window.points) {
        paper.lay(stamps[point.stamp], point.place[0] * tile, (size[1] - point.place[1]) * tile,
                  settings.stamp_size * window.spacing * tile * point.size, point.turn);
    }
    return paper.pixels();
}

}
