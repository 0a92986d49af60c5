#include "host/distribution/runs/lookup_costs.hpp"

#include "base/programs/interrupt.hpp"
#include "host/distribution/tabled_noise.hpp"

#include <algorithm>
#include <array>
#include <ctime>
#include <random>
#include <vector>

namespace poissonlab {
namespace {

constexpr std::size_t timed_places = 1 << 14;
constexpr int timed_repeats = 9;
constexpr double noise_cells_a_tile = 8; ///< so that a cell of noise is about as large as an object of 64 in a tile

using TimedPlaces = std::vector<std::array<double, 3>>;

TimedPlaces random_places()
{
    std::mt19937 random(2);
    TimedPlaces places(timed_places);
    for (auto& place : places)
        for (double& number : place) number = static_cast<double>(random() % (1 << 24)) / (1 << 14);
    return places;
}

/// Rows of 256 pixels of which a tile has 180 along each side.
TimedPlaces places_in_rows()
{
    TimedPlaces places;
    for (std::size_t i = 0; i < timed_places; ++i)
        places.push_back({static_cast<double>(i % 256) / 180, static_cast<double>(i / 256) / 180, 0.37});
    return places;
}

/// Calls a second of processor time of what is called for each place: other programs that run do not count. The sum
/// keeps compilers from leaving calls out.
template <class Call>
double calls_a_second(const TimedPlaces& places, Call call)
{
    std::vector<double> seconds;
    volatile double kept = 0;
    for (int repeat = 0; repeat < timed_repeats; ++repeat) {
        stop_if_interrupted();
        const std::clock_t start = std::clock();
        double sum = 0;
        for (const auto& place : places) sum += call(place);
        kept = kept + sum;
        seconds.push_back(static_cast<double>(std::max<std::clock_t>(1, std::clock() - start)) / CLOCKS_PER_SEC);
    }
    std::ranges::nth_element(seconds, seconds.begin() + timed_repeats / 2);
    return static_cast<double>(places.size()) / seconds[timed_repeats / 2];
}

}

LookupCosts lookup_costs(const ObjectTileSet& tiles)
{
    const pobjects distribution = tiles.distribution({1, 0});
    const bool is_in_space = tiles.tiles().parameters.dimension == 3;
    const TabledNoise noise;
    const auto look_up = [&](const std::array<double, 3>& place, pobjects_cursor* cursor) {
        return static_cast<double>(pobjects_at(&distribution, place.data(), cursor).point.id);
    };
    const auto call_noise = [&](const std::array<double, 3>& place) {
        const double x = place[0] * noise_cells_a_tile, y = place[1] * noise_cells_a_tile;
        return is_in_space ? noise.at(x, y, place[2] * noise_cells_a_tile) : noise.at(x, y);
    };
    const TimedPlaces anywhere = random_places(), rows = places_in_rows();
    pobjects_cursor cursor{};
    LookupCosts costs;
    costs.lookups_anywhere = calls_a_second(anywhere, [&](const auto& place) { return look_up(place, nullptr); });
    costs.lookups_in_rows = calls_a_second(rows, [&](const auto& place) { return look_up(place, &cursor); });
    costs.noise_anywhere = calls_a_second(anywhere, call_noise);
    costs.noise_in_rows = calls_a_second(rows, call_noise);
    return costs;
}

}
