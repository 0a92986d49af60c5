#include "tiles/aperiodic/beatty_tiling.hpp"

#include "base/errors/errors.hpp"
#include "base/random/random.hpp"
#include "tiles/aperiodic/aperiodic_sets.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace poissonlab {
namespace {

using BigInteger = boost::multiprecision::cpp_int;
__extension__ using Wide = unsigned __int128;

constexpr int slope_bits = 62;    // of row 0, after the point
constexpr int fraction_bits = 96; // of a FixedPoint

/// The bounds that decide which machine a row has: alpha is in (lowest, highest], and the first machine takes what is
/// not above `middle`; all in thirds.
struct SlopeRange
{
    int lowest, middle, highest;
};

constexpr SlopeRange range_of(BeattySet set)
{
    return set == BeattySet::kari ? SlopeRange{2, 3, 6} : SlopeRange{1, 2, 6};
}

/// alpha of a row over that of row 0: 2^twos 3^threes.
struct RowFactor
{
    std::int64_t twos = 0;
    std::int64_t threes = 0;
};

/// A non-negative rational.
struct Ratio
{
    BigInteger numerator;
    BigInteger denominator;

    bool is_above(int thirds) const { return numerator * 3 > denominator * thirds; }

    FixedPoint rounded() const
    {
        const BigInteger number = ((numerator << fraction_bits) + denominator / 2) / denominator;
        const BigInteger mask = (BigInteger(1) << 64) - 1;
        return {static_cast<std::uint64_t>((number >> 64) & mask), static_cast<std::uint64_t>(number & mask)};
    }
};

/// Goes from row to row southwards, and keeps the power of three.
class RowWalk
{
public:
    RowWalk(BeattySet set, std::uint64_t slope, std::uint64_t offset, std::int64_t y)
        : set_(set), slope_(slope), offset_(offset)
    {
        start(-y);
    }

    BeattyRow row()
    {
        const Ratio slope = scaled(slope_);
        machine_ = slope.is_above(range_of(set_).middle) ? 1 : 0;
        return {slope.rounded(), scaled(offset_).rounded(), machine_};
    }

    /// Moves to the row below that of the last call of row().
    void step()
    {
        const bool is_first = machine_ == 0;
        if (set_ == BeattySet::kari) {
            ++factor_.twos;
            if (!is_first) change_threes(-1);
        } else if (is_first) {
            change_threes(1);
        } else {
            --factor_.twos;
        }
    }

private:
    /// The factor after so many rows southwards: of all with the right number of steps, the one that leaves alpha in
    /// its range. Logarithms find it, and exact numbers decide.
    void start(std::int64_t steps)
    {
        const bool is_kari = set_ == BeattySet::kari;
        const SlopeRange range = range_of(set_);
        const double slope = std::ldexp(static_cast<double>(slope_), -slope_bits);
        // Kari: 2^steps 3^threes; Culik: 6^threes 2^-steps.
        const double threes =
            (std::log2(range.highest / 3.0 / slope) - (is_kari ? 1.0 : -1.0) * static_cast<double>(steps)) /
            std::log2(is_kari ? 3.0 : 6.0);
        set_threes(steps, static_cast<std::int64_t>(std::floor(threes)));
        while (scaled(slope_).is_above(range.highest)) set_threes(steps, factor_.threes - 1);
        while (!scaled(slope_).is_above(range.lowest)) set_threes(steps, factor_.threes + 1);
    }

    void set_threes(std::int64_t steps, std::int64_t threes)
    {
        factor_ = {set_ == BeattySet::kari ? steps : threes - steps, threes};
        power_ = boost::multiprecision::pow(BigInteger(3), static_cast<unsigned>(std::abs(threes)));
    }

    void change_threes(int by)
    {
        const bool grows = factor_.threes == 0 || (factor_.threes > 0) == (by > 0);
        factor_.threes += by;
        if (grows)
            power_ *= 3;
        else
            power_ /= 3;
    }

    Ratio scaled(std::uint64_t value) const
    {
        Ratio ratio{value, 1};
        (factor_.threes >= 0 ? ratio.numerator : ratio.denominator) *= power_;
        const std::int64_t twos = factor_.twos - slope_bits;
        if (twos >= 0)
            ratio.numerator <<= static_cast<unsigned>(twos);
        else
            ratio.denominator <<= static_cast<unsigned>(-twos);
        return ratio;
    }

    BeattySet set_;
    std::uint64_t slope_, offset_;
    RowFactor factor_;
    BigInteger power_ = 1; ///< of three, with the exponent's absolute value
    std::uint32_t machine_ = 0;
};

/// The places of tiles by what they multiply. Digits of Culik's set are 0 for 0' too.
BeattyTable table_of(BeattySet set)
{
    constexpr Color marked_zero = 3;
    const WangList list = set == BeattySet::kari ? kari_tiles() : culik_tiles();
    const Color second = set == BeattySet::kari ? 2 : 3; // the first carry of the second machine
    BeattyTable table;
    table.fill(no_beatty_tile);
    for (std::size_t place = 0; place < list.tiles.size(); ++place) {
        const WangTile& tile = list.tiles[place];
        const std::size_t machine = tile.west < second ? 0 : 1;
        const Color first_carry = machine == 0 ? 0 : second;
        const auto digit = [](Color color) { return color == marked_zero ? 0 : color; };
        for (std::size_t next = 0; next < 2; ++next) {
            // A zero of Culik's is marked where the row below it has the second machine, and only there.
            if (set == BeattySet::culik && digit(tile.south) == 0 && (tile.south == marked_zero) != (next == 1))
                continue;
            const std::size_t digits = ((machine * 2 + next) * 3 + digit(tile.north)) * 3 + digit(tile.south);
            table[(digits * 4 + tile.west - first_carry) * 4 + tile.east - first_carry] =
                static_cast<std::uint8_t>(place);
        }
    }
    return table;
}

Wide wide(const FixedPoint& number) { return Wide{number.high} << 64 | number.low; }

/// floor(i slope + offset) modulo 2^32.
std::uint32_t floor_at(std::int64_t i, const BeattyRow& row)
{
    const Wide x = static_cast<Wide>(i) * wide(row.slope) + wide(row.offset);
    return static_cast<std::uint32_t>(x >> fraction_bits);
}

/// The place of tile i of a row with the machine of `north`, above the row `south`.
std::uint8_t beatty_tile(const BeattyTiling& tiling, const BeattyRow& north, const BeattyRow& south, std::int64_t i)
{
    const std::uint32_t f = floor_at(i, north), next_f = floor_at(i + 1, north);
    const std::uint32_t g = floor_at(i, south), next_g = floor_at(i + 1, south);
    const BeattyMachine& m = tiling.machines()[north.machine];
    const auto carry = [&](std::uint32_t above, std::uint32_t below) {
        return static_cast<std::uint32_t>(m.factor) * above - static_cast<std::uint32_t>(m.divisor) * below +
               static_cast<std::uint32_t>(m.shift);
    };
    const std::uint32_t west = carry(f, g), east = carry(next_f, next_g);
    const std::uint32_t north_digit = next_f - f, south_digit = next_g - g;
    if (north_digit > 2 || south_digit > 2 || west > 3 || east > 3) return no_beatty_tile;
    const std::uint32_t digits = ((north.machine * 2 + south.machine) * 3 + north_digit) * 3 + south_digit;
    return tiling.table()[(digits * 4 + west) * 4 + east];
}

}

BeattyTiling::BeattyTiling(BeattySet set, std::uint64_t seed) : set_(set), table_(table_of(set))
{
    const auto words = philox({0, 0, 0, 0}, stream_key(seed, Purpose::beatty_tiling, 0));
    const SlopeRange range = range_of(set);
    const auto share = [&](std::size_t word) { return std::uint64_t{words[word]} << 32 | words[word + 1]; };
    const auto length = (std::uint64_t{1} << slope_bits) / 3;
    // lowest + (0, 1] (highest - lowest), in thirds of 2^62 rounded down.
    const Wide extent = Wide{length} * static_cast<unsigned>(range.highest - range.lowest);
    slope_ = length * static_cast<unsigned>(range.lowest) + 1 + static_cast<std::uint64_t>(extent * share(0) >> 64);
    offset_ = share(2) >> (64 - slope_bits);
    if (set == BeattySet::kari)
        machines_ = {{{2, 1, 1}, {2, 3, 1}}};
    else
        machines_ = {{{3, 1, 2}, {1, 2, 0}}};
}

std::vector<BeattyRow> BeattyTiling::rows(std::int64_t y, std::size_t count) const
{
    const auto southmost = y - static_cast<std::int64_t>(count);
    if (y >= beatty_row_limit || southmost < -beatty_row_limit - 2)
        throw InputError(fmt::format("rows {} to {}: must be from -{} to {}", southmost + 1, y, beatty_row_limit,
                                     beatty_row_limit - 1));
    std::vector<BeattyRow> rows;
    rows.reserve(count);
    for (RowWalk walk(set_, slope_, offset_, y); rows.size() < count; walk.step()) rows.push_back(walk.row());
    return rows;
}

void check_beatty_window(const TileWindow& window)
{
    const auto is_inside = [](std::int64_t first, std::uint64_t size, std::int64_t limit) {
        return first >= -limit && first < limit && size <= static_cast<std::uint64_t>(limit - first);
    };
    if (!is_inside(window.y, window.height, beatty_row_limit))
        throw InputError(fmt::format("rows of a tiling by Beatty sequences are from {} to {}", -beatty_row_limit,
                                     beatty_row_limit - 1));
    if (!is_inside(window.x, window.width, beatty_column_limit))
        throw InputError(fmt::format("columns of a tiling by Beatty sequences are from {} to {}", -beatty_column_limit,
                                     beatty_column_limit - 1));
}

std::vector<std::uint8_t> reference::beatty_tiles(const BeattyTiling& tiling, const TileWindow& window)
{
    check_beatty_window(window);
    const auto rows = tiling.rows(window.y + static_cast<std::int64_t>(window.height) - 1,
                                  static_cast<std::size_t>(window.height) + 1);
    std::vector<std::uint8_t> tiles;
    tiles.reserve(static_cast<std::size_t>(window.width * window.height));
    for (std::size_t row = 0; row < window.height; ++row)
        for (std::uint64_t column = 0; column < window.width; ++column) {
            const auto i = window.x + static_cast<std::int64_t>(column);
            tiles.push_back(beatty_tile(tiling, rows[row], rows[row + 1], i));
            if (tiles.back() == no_beatty_tile) throw std::logic_error("a tile by Beatty sequences is not in its set");
        }
    return tiles;
}

}
