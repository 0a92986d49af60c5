#include "host/distribution/self_similar_search.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"
#include "host/device/needed_buffers.hpp"
#include "kernels/common/tiles/self_similar.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <numbers>

namespace poissonlab {
namespace {

using namespace contract::self_similar;

constexpr std::uint32_t found_capacity = 1'000'000;
constexpr std::size_t items_at_once = std::size_t{1} << 13; ///< a second of work or less

std::uint32_t rotated(std::uint32_t word, std::uint32_t bits)
{
    return (word << 1 | word >> (bits - 1)) & ((1u << bits) - 1);
}

/// The least of a word's rotations and of those of its complement, its mirror image.
std::uint32_t least_word(std::uint32_t word, std::uint32_t bits)
{
    std::uint32_t least = word;
    for (std::uint32_t k = 0; k < bits; ++k) {
        word = rotated(word, bits);
        least = std::min({least, word, ~word & ((1u << bits) - 1)});
    }
    return least;
}

/// The squared distance of a relative radius, in squared units.
double squared_of_radius(double radius, std::uint32_t points)
{
    const double side = (1u << points) - 1.0;
    return radius * radius * 2 / (std::numbers::sqrt3 * points) * side * side;
}

struct SearchBuffers
{
    Buffer<std::uint32_t> firsts, seconds, classes, count, found;

    NeededBuffers needed(std::size_t first_count, std::size_t second_count)
    {
        return {{firsts, first_count},
                {seconds, second_count},
                {classes, second_count},
                {count, 1},
                {found, 2 * std::size_t{found_capacity}}};
    }
};

/// One start of each class, and all second ones but mirror images, with their classes.
struct SearchedStarts
{
    std::vector<std::uint32_t> firsts, seconds, classes;

    explicit SearchedStarts(std::uint32_t bits)
    {
        for (const std::uint32_t word : balanced_words(bits)) {
            const std::uint32_t least = least_word(word, bits);
            if (least == word) firsts.push_back(word);
            if (word >> (bits - 1) != 0) continue;
            seconds.push_back(word);
            classes.push_back(least);
        }
    }
};

}

double balanced_share(std::uint32_t bits)
{
    double share = 1;
    for (std::uint32_t k = 2; k <= bits; k += 2) share *= (k - 1.0) / k;
    return share;
}

std::vector<std::uint32_t> balanced_words(std::uint32_t bits)
{
    std::vector<std::uint32_t> words;
    for (std::uint32_t word = 0; word < 1u << bits; ++word)
        if (2 * static_cast<std::uint32_t>(std::popcount(word)) == bits) words.push_back(word);
    return words;
}

SelfSimilarStarts least_symmetric(const SelfSimilarStarts& starts, std::uint32_t points)
{
    const std::uint32_t all = (1u << points) - 1;
    SelfSimilarStarts least = starts, turned = starts;
    for (std::uint32_t k = 0; k < points; ++k) {
        turned = {rotated(turned.x, points), rotated(turned.y, points)};
        for (const std::uint32_t x : {turned.x, ~turned.x & all})
            for (const std::uint32_t y : {turned.y, ~turned.y & all})
                least = std::min({least, SelfSimilarStarts{x, y}, SelfSimilarStarts{y, x}});
    }
    return least;
}

std::vector<FoundStarts> sorted_starts(std::vector<SelfSimilarStarts> found, std::uint32_t points, double least_radius)
{
    for (SelfSimilarStarts& starts : found) starts = least_symmetric(starts, points);
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    const double least = squared_of_radius(least_radius, points);
    std::vector<FoundStarts> sorted;
    for (const SelfSimilarStarts& starts : found) {
        const std::uint64_t squared = squared_min_distance(starts, points);
        if (static_cast<double>(squared) >= least) sorted.push_back({starts, squared});
    }
    std::ranges::stable_sort(sorted, std::ranges::greater(), &FoundStarts::squared);
    return sorted;
}

DeviceMemory self_similar_memory(std::uint32_t points)
{
    double words = 1; // the middle binomial coefficient
    for (std::uint32_t i = 1; i <= points / 2; ++i) words = words * (points / 2 + i) / i;
    const auto seconds = static_cast<std::size_t>(words / 2);
    return memory_of(SearchBuffers{}.needed(seconds, seconds));
}

std::vector<FoundStarts> search_self_similar(Device& device, std::uint32_t points, double least_radius,
                                             const SearchListener& on_progress, std::size_t work_group_size)
{
    const SearchedStarts starts(points);
    SearchBuffers buffers;
    reserve(device, buffers.needed(starts.firsts.size(), starts.seconds.size()));
    buffers.seconds.write(starts.seconds);
    buffers.classes.write(starts.classes);
    const std::uint32_t none = 0;
    buffers.count.write(std::span(&none, 1));
    Kernel kernel = device.kernel(kernel_program("self_similar.cl", {}), "search_starts");
    const std::size_t blocks = (starts.seconds.size() + SECOND_STARTS - 1) / SECOND_STARTS;
    const std::size_t step = std::max<std::size_t>(1, items_at_once / blocks);
    StartSearch search{points, 0, static_cast<std::uint32_t>(starts.seconds.size()),
                       static_cast<float>(squared_of_radius(least_radius, points) * (1 - 1e-5)), found_capacity};
    std::uint32_t count = 0;
    for (std::size_t first = 0; first < starts.firsts.size(); first += step) {
        stop_if_interrupted();
        search.firsts = static_cast<std::uint32_t>(std::min(step, starts.firsts.size() - first));
        buffers.firsts.write(std::span(starts.firsts).subspan(first, search.firsts));
        kernel.run(search.firsts * blocks, work_group_size > 0 ? work_group_size : default_work_group_size, search,
                   buffers.firsts, buffers.seconds, buffers.classes, buffers.count, buffers.found);
        count = buffers.count.read(0, 1).front();
        if (count > found_capacity)
            throw InputError(fmt::format("more than {} tiles of {} points have a relative radius of {}: ask for more",
                                         found_capacity, points, least_radius));
        if (on_progress) on_progress(static_cast<double>(first) / static_cast<double>(starts.firsts.size()));
    }
    std::vector<SelfSimilarStarts> found;
    const std::vector<std::uint32_t> words = buffers.found.read(0, 2 * std::size_t{count});
    for (std::size_t i = 0; i < words.size(); i += 2) found.push_back({words[i], words[i + 1]});
    return sorted_starts(std::move(found), points, least_radius);
}

}
