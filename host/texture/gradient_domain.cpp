#include "host/texture/gradient_domain.hpp"

#include "host/device/device.hpp"
#include "host/device/kernel_program.hpp"
#include "kernels/common/fields/gradient_domain.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

std::size_t pixels_of(const GradientDomain& domain)
{
    return static_cast<std::size_t>(domain.size) * static_cast<std::size_t>(domain.size);
}

void relax_channel(const GradientDomain& domain, const std::uint8_t* inside, double* values)
{
    const auto pixels = static_cast<int>(pixels_of(domain));
    const double relaxation = domain.relaxation();
    for (int sweep = 0; sweep < 2 * domain.sweeps(); ++sweep)
        for (int pixel = 0; pixel < pixels; ++pixel) {
            if (inside[pixel] == 0 || (pixel % domain.size + pixel / domain.size + sweep) % 2 != 0) continue;
            const double mean = ((values[pixel - 1] + values[pixel + 1]) +
                                 (values[pixel - domain.size] + values[pixel + domain.size])) *
                                0.25;
            values[pixel] += relaxation * (mean - values[pixel]);
        }
}

/// True for pixels with a neighbour inside.
bool is_beside(const std::vector<std::uint8_t>& taken, int size, int x, int y)
{
    const auto is_taken = [&](int column, int row) {
        return column >= 0 && row >= 0 && column < size && row < size &&
               taken[static_cast<std::size_t>(row * size + column)] != 0;
    };
    return is_taken(x - 1, y) || is_taken(x + 1, y) || is_taken(x, y - 1) || is_taken(x, y + 1);
}

}

double GradientDomain::relaxation() const { return 2 / (1 + std::numbers::pi / size); }

void relax_reference(GradientDomain& domain)
{
    const std::size_t pixels = pixels_of(domain);
    for (std::size_t i = 0; i < domain.values.size() / pixels; ++i)
        relax_channel(domain, &domain.inside[i / static_cast<std::size_t>(domain.channels) * pixels],
                      &domain.values[i * pixels]);
}

GradientDomain gradient_domain(const PngPixels& exemplar, const std::vector<PngPixels>& tiles,
                               const std::vector<FittedPiece>& pieces)
{
    GradientDomain domain{tiles[0].width, exemplar.channels, {}, {}};
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const std::vector<std::uint8_t>& taken = pieces[i].cut.taken;
        domain.inside.insert(domain.inside.end(), taken.begin(), taken.end());
        for (int c = 0; c < domain.channels; ++c)
            for (int y = 0; y < domain.size; ++y)
                for (int x = 0; x < domain.size; ++x) {
                    const bool is_known = taken[static_cast<std::size_t>(y * domain.size + x)] == 0 &&
                                          is_beside(taken, domain.size, x, y);
                    const ExemplarWindow& window = pieces[i].window;
                    domain.values.push_back(is_known ? tiles[i].values[tiles[i].at(x, y, c)] -
                                                           exemplar.values[exemplar.at(window.x + x, window.y + y, c)]
                                                     : 0);
                }
    }
    return domain;
}

GradientDomain bow_tie_domain(const PngPixels& exemplar, int size, const BowTies& ties)
{
    GradientDomain domain{size, exemplar.channels, {}, {}};
    const auto pixels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
    for (std::size_t first = 0; first < ties.shown.size(); first += pixels) {
        const std::vector<std::uint8_t> shown(ties.shown.begin() + static_cast<std::ptrdiff_t>(first),
                                              ties.shown.begin() + static_cast<std::ptrdiff_t>(first + pixels));
        const auto is_border = [&](int x, int y) { return x == 0 || y == 0 || x == size - 1 || y == size - 1; };
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                domain.inside.push_back(shown[static_cast<std::size_t>(y * size + x)] != 0 && !is_border(x, y));
        for (int c = 0; c < domain.channels; ++c)
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x) {
                    const auto pixel = static_cast<std::size_t>(y * size + x);
                    const bool is_known = shown[pixel] != 0 ? is_border(x, y) : is_beside(shown, size, x, y);
                    const SourcePixel around = ties.horizontal[first + pixel], own = ties.vertical[first + pixel];
                    domain.values.push_back(is_known ? exemplar.values[exemplar.at(around.x, around.y, c)] -
                                                           exemplar.values[exemplar.at(own.x, own.y, c)]
                                                     : 0);
                }
    }
    return domain;
}

void add_to_tiles(const GradientDomain& domain, std::vector<PngPixels>& tiles)
{
    const std::size_t pixels = pixels_of(domain);
    const auto channels = static_cast<std::size_t>(domain.channels);
    for (std::size_t tile = 0; tile < tiles.size(); ++tile)
        for (std::size_t c = 0; c < channels; ++c)
            for (std::size_t i = 0; i < pixels; ++i) {
                if (domain.inside[tile * pixels + i] == 0) continue;
                std::uint8_t& value = tiles[tile].values[i * channels + c];
                const double smoothed = value + domain.values[(tile * channels + c) * pixels + i];
                value = static_cast<std::uint8_t>(std::clamp(std::floor(smoothed + 0.5), 0.0, 255.0));
            }
}

void relax_on(Device& device, GradientDomain& domain, std::size_t work_group_size)
{
    const std::size_t pixels = static_cast<std::size_t>(domain.size) * static_cast<std::size_t>(domain.size);
    Buffer<std::uint8_t> inside = device.buffer<std::uint8_t>(domain.inside.size());
    Buffer<double> values = device.buffer<double>(domain.values.size());
    inside.write(domain.inside);
    values.write(domain.values);
    const contract::gradient_domain::GradientDomainSizes sizes{domain.size, domain.channels, domain.sweeps(),
                                                               domain.relaxation()};
    Kernel kernel = device.kernel(kernel_program("gradient_domain.cl", {}), "relax_gradient_domain");
    kernel.run(domain.values.size() / pixels * work_group_size, work_group_size, sizes, inside, values);
    values.read(domain.values);
}

}
