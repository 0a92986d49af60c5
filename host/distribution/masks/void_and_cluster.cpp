#include "host/distribution/masks/void_and_cluster.hpp"

#include "base/random/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace poissonlab {
namespace {

constexpr double deviation = 1.5;   ///< of the Gaussian, in pixels
constexpr std::int32_t far = 7;     ///< pixels along an axis where it ends: it is below 2^-16 beyond
constexpr double first_share = 0.1; ///< of the pixels that are in the pattern at first
constexpr std::uint32_t block = 16; ///< pixels along an axis whose least value is kept
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// The places of least values of a torus whose values change near one place at a time: of blocks of pixels, and of rows
/// of blocks. Of equal values the first in the order of blocks.
class LeastPlaces
{
public:
    LeastPlaces(std::uint32_t width, std::uint32_t height)
        : width_(width), height_(height), blocks_((width + block - 1) / block), rows_((height + block - 1) / block),
          values_(std::size_t{width} * height, none), of_blocks_(std::size_t{blocks_} * rows_), of_rows_(rows_)
    {}

    void set(std::size_t pixel, std::uint32_t value) { values_[pixel] = value; }

    void update_all()
    {
        for (std::uint32_t row = 0; row < rows_; ++row) {
            for (std::uint32_t column = 0; column < blocks_; ++column) update_block(column, row);
            update_row(row);
        }
    }

    /// Values have changed up to `far` pixels from here.
    void update_near(std::uint32_t x, std::uint32_t y)
    {
        const auto columns = blocks_near(x, width_), rows = blocks_near(y, height_);
        for (const std::uint32_t row : rows) {
            if (row == none) continue;
            for (const std::uint32_t column : columns)
                if (column != none) update_block(column, row);
            update_row(row);
        }
    }

    std::uint32_t least() const
    {
        Least best{none, none};
        for (const Least& of_row : of_rows_)
            if (of_row.value < best.value) best = of_row;
        return best.pixel;
    }

private:
    struct Least
    {
        std::uint32_t value = none, pixel = none;
    };

    /// Blocks of the pixels around one, up to three: the last block of an axis may be narrow.
    static std::array<std::uint32_t, 4> blocks_near(std::uint32_t at, std::uint32_t size)
    {
        std::array<std::uint32_t, 4> found{none, none, none, none};
        std::size_t count = 0;
        for (std::int32_t offset = -far; offset <= far; ++offset) {
            const std::uint32_t of = (at + size + static_cast<std::uint32_t>(offset)) % size / block;
            if (std::ranges::find(found, of) == found.end()) found[count++] = of;
        }
        return found;
    }

    void update_block(std::uint32_t column, std::uint32_t row)
    {
        Least best;
        const std::uint32_t right = std::min(width_, (column + 1) * block), top = std::min(height_, (row + 1) * block);
        for (std::uint32_t y = row * block; y < top; ++y)
            for (std::uint32_t x = column * block; x < right; ++x)
                if (const std::uint32_t value = values_[std::size_t{y} * width_ + x]; value < best.value)
                    best = {value, y * width_ + x};
        of_blocks_[std::size_t{row} * blocks_ + column] = best;
    }

    void update_row(std::uint32_t row)
    {
        Least best;
        for (std::uint32_t column = 0; column < blocks_; ++column)
            if (const Least& of = of_blocks_[std::size_t{row} * blocks_ + column]; of.value < best.value) best = of;
        of_rows_[row] = best;
    }

    std::uint32_t width_, height_, blocks_, rows_;
    std::vector<std::uint32_t> values_;
    std::vector<Least> of_blocks_, of_rows_;
};

/// A pattern of pixels, the influence of all of them at each pixel, its tightest cluster and its largest void.
class Pattern
{
public:
    Pattern(std::uint32_t width, std::uint32_t height)
        : width_(width), height_(height), energies_(std::size_t{width} * height), is_in_(energies_.size()),
          voids_(width, height), clusters_(width, height)
    {
        for (std::int32_t y = -far; y <= far; ++y)
            for (std::int32_t x = -far; x <= far; ++x)
                influence_[static_cast<std::size_t>((y + far) * side + x + far)] = static_cast<std::uint32_t>(
                    std::lround(std::exp(-(x * x + y * y) / (2 * deviation * deviation)) * 0x1p16));
    }

    /// Puts pixels in where there are none yet.
    void start(const std::vector<std::uint32_t>& pixels)
    {
        for (const std::uint32_t pixel : pixels) add_influence(pixel, true);
        watch(true, true);
    }

    /// Says which of the two below are asked for from now on: others take no time.
    void watch(bool voids, bool clusters)
    {
        watches_voids_ = voids;
        watches_clusters_ = clusters;
        for (std::uint32_t pixel = 0; pixel < energies_.size(); ++pixel) write_place(pixel);
        if (voids) voids_.update_all();
        if (clusters) clusters_.update_all();
    }

    /// The pixel of the pattern where it is densest, and the one out of it where there are fewest around.
    std::uint32_t tightest_cluster() const { return clusters_.least(); }
    std::uint32_t largest_void() const { return voids_.least(); }

    void put_in(std::uint32_t pixel) { change(pixel, true); }
    void take_out(std::uint32_t pixel) { change(pixel, false); }

private:
    static constexpr std::int32_t side = 2 * far + 1;

    template <typename What>
    void for_each_near(std::uint32_t pixel, const What& what)
    {
        const std::uint32_t x = pixel % width_, y = pixel / width_;
        std::array<std::uint32_t, side> columns;
        for (std::int32_t dx = -far; dx <= far; ++dx)
            columns[static_cast<std::size_t>(dx + far)] = (x + width_ + static_cast<std::uint32_t>(dx)) % width_;
        const std::uint32_t* influence = influence_.data();
        for (std::int32_t dy = -far; dy <= far; ++dy) {
            const std::uint32_t row = (y + height_ + static_cast<std::uint32_t>(dy)) % height_ * width_;
            for (const std::uint32_t column : columns) what(row + column, *influence++);
        }
    }

    void add_influence(std::uint32_t pixel, bool in)
    {
        is_in_[pixel] = in;
        for_each_near(pixel, [&](std::uint32_t other, std::uint32_t influence) {
            energies_[other] += in ? influence : 0u - influence;
        });
    }

    void write_place(std::uint32_t pixel)
    {
        // Clusters are least, too: of what energies lack to the most that there can be.
        if (watches_voids_) voids_.set(pixel, is_in_[pixel] ? none : energies_[pixel]);
        if (watches_clusters_) clusters_.set(pixel, is_in_[pixel] ? none - 1 - energies_[pixel] : none);
    }

    void change(std::uint32_t pixel, bool in)
    {
        add_influence(pixel, in);
        for_each_near(pixel, [&](std::uint32_t other, std::uint32_t) { write_place(other); });
        if (watches_voids_) voids_.update_near(pixel % width_, pixel / width_);
        if (watches_clusters_) clusters_.update_near(pixel % width_, pixel / width_);
    }

    std::uint32_t width_, height_;
    std::array<std::uint32_t, side * side> influence_{};
    std::vector<std::uint32_t> energies_;
    std::vector<std::uint8_t> is_in_;
    LeastPlaces voids_, clusters_;
    bool watches_voids_ = true, watches_clusters_ = true;
};

/// Pixels by chance.
std::vector<std::uint32_t> random_pixels(std::uint32_t pixels, std::uint32_t count, std::uint64_t seed)
{
    const StreamKey key = stream_key(seed, Purpose::dither_mask, 0);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> keyed;
    for (std::uint32_t i = 0; i < pixels; ++i) keyed.emplace_back(philox({i, 0, 0, 0}, key)[0], i);
    std::ranges::sort(keyed);
    std::vector<std::uint32_t> chosen;
    for (std::uint32_t i = 0; i < count; ++i) chosen.push_back(keyed[i].second);
    return chosen;
}

}

std::vector<std::uint32_t> void_and_cluster(std::uint32_t width, std::uint32_t height, std::uint64_t seed,
                                            const std::function<void(double part)>& on_part)
{
    const std::uint32_t pixels = width * height;
    const auto first = std::max<std::uint32_t>(1, static_cast<std::uint32_t>(first_share * pixels));
    Pattern pattern(width, height);
    pattern.start(random_pixels(pixels, first, seed));
    const auto tell = [&](std::uint32_t done) {
        if (on_part && done % 4096 == 0) on_part(static_cast<double>(done) / pixels);
    };
    // The first pattern is even when its tightest cluster, taken out, leaves its largest void. Each exchange lowers the
    // sum of all energies, but for equal ones: so many are enough for any.
    for (std::uint32_t exchanges = 0; exchanges < 8 * first; ++exchanges) {
        tell(0);
        const std::uint32_t cluster = pattern.tightest_cluster();
        pattern.take_out(cluster);
        const std::uint32_t hole = pattern.largest_void();
        pattern.put_in(hole);
        if (hole == cluster) break;
    }
    std::vector<std::uint32_t> ranks(pixels), taken;
    pattern.watch(false, true);
    for (std::uint32_t rank = first; rank-- > 0;) {
        tell(first - rank);
        taken.push_back(pattern.tightest_cluster());
        pattern.take_out(taken.back());
        ranks[taken.back()] = rank;
    }
    for (const std::uint32_t pixel : taken) pattern.put_in(pixel);
    pattern.watch(true, false);
    for (std::uint32_t rank = first; rank < pixels; ++rank) {
        tell(rank);
        const std::uint32_t hole = pattern.largest_void();
        pattern.put_in(hole);
        ranks[hole] = rank;
    }
    return ranks;
}

}
