#include "host/tile_sampling/recursive/recursive_plane.hpp"

#include "base/errors/errors.hpp"
#include "tiles/poisson/tile_lookup.hpp"
#include "tiles/tilings/even_wang_tiles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace poissonlab {
namespace {

constexpr std::uint64_t whole_turn = std::uint64_t{1} << 32;

std::uint32_t low_word(std::int64_t v) { return static_cast<std::uint32_t>(static_cast<std::uint64_t>(v)); }
std::uint32_t high_word(std::int64_t v) { return static_cast<std::uint32_t>(static_cast<std::uint64_t>(v) >> 32); }

/// The bit at a corner of tiles of level 0.
std::uint32_t corner_bit(std::uint32_t seed, std::int64_t x, std::int64_t y)
{
    return ptiles_mix(ptiles_hash(seed, low_word(x), low_word(y), high_word(x)) + 1 + high_word(y)) & 1;
}

RecursiveFrame frame_of(const RecursiveWindow& window)
{
    std::vector<std::array<std::uint8_t, 2>> digits;
    for (std::size_t i = 0; i < window.corner[0].digits.size(); ++i)
        digits.push_back({window.corner[0].digits[i], window.corner[1].digits[i]});
    return {std::move(digits), {window.size[0], window.size[1]}};
}

}

RecursiveAddress read_recursive_address(const std::string& text)
{
    const auto refused = [&] {
        return InputError(fmt::format("\"{}\": must be a tile from -2^52 to 2^52, such as -5, or -5:0132 with up to {} "
                                      "digits from 0 to 3 after a colon",
                                      printable(text), deepest_recursive_level));
    };
    RecursiveAddress address;
    const std::size_t colon = std::min(text.find(':'), text.size());
    const auto [end, error] = std::from_chars(text.data(), text.data() + colon, address.base);
    if (error != std::errc() || end != text.data() + colon || address.base < -farthest_recursive_tile ||
        address.base > farthest_recursive_tile || colon + 1 == text.size() ||
        text.size() - colon > deepest_recursive_level + 1)
        throw refused();
    for (std::size_t i = colon + 1; i < text.size(); ++i) {
        if (text[i] < '0' || text[i] > '3') throw refused();
        address.digits.push_back(static_cast<std::uint8_t>(text[i] - '0'));
    }
    return address;
}

std::string text_of(const RecursiveAddress& address)
{
    std::string text = std::to_string(address.base);
    if (!address.digits.empty()) text += ':';
    for (const std::uint8_t digit : address.digits) text += static_cast<char>('0' + digit);
    return text;
}

RecursiveAddress moved(RecursiveAddress address, std::int64_t tiles)
{
    for (std::size_t i = address.digits.size(); i-- > 0 && tiles != 0;) {
        tiles += address.digits[i];
        address.digits[i] = static_cast<std::uint8_t>(tiles & 3);
        tiles >>= 2; // rounds down
    }
    address.base += tiles;
    return address;
}

RecursiveRoot plane_root(std::uint32_t seed, std::int64_t x, std::int64_t y)
{
    const auto bit = [&](int right, int up) { return corner_bit(seed, x + right, y + up); };
    const std::uint32_t sw = bit(0, 0), se = bit(1, 0), nw = bit(0, 1), ne = bit(1, 1);
    RecursiveRoot root{static_cast<std::uint8_t>(even_wang_tile({nw ^ ne, se ^ ne, sw ^ se, sw ^ nw})), whole_turn};
    for (int level = 7; level >= 0; --level) // 32 bits in eight steps
        root.turn =
            turn_of_cell(static_cast<std::uint32_t>((x >> 2 * level & 3) | (y >> 2 * level & 3) << 2), root.turn);
    return root;
}

std::vector<RecursivePoint> window_points(const RecursiveTileSet& tiles, const RecursiveRoots& roots,
                                          const RecursiveWindow& window, const RecursiveDensity& density)
{
    const RecursiveFrame frame = frame_of(window);
    std::vector<RecursiveNode> nodes;
    for (std::uint64_t y = 0; y < frame.sizes.front()[1]; ++y)
        for (std::uint64_t x = 0; x < frame.sizes.front()[0]; ++x) {
            const RecursiveRoot root = roots(window.corner[0].base + static_cast<std::int64_t>(x),
                                             window.corner[1].base + static_cast<std::int64_t>(y));
            nodes.push_back({root.tile, {x, y}, root.turn});
        }
    return points_in_frame(tiles, frame, std::move(nodes), density);
}

std::array<std::uint32_t, 2> low_bits(const RecursiveWindow& window, int level)
{
    std::array<std::uint32_t, 2> low{};
    for (std::size_t k = 0; k < 2; ++k) {
        const auto& [base, digits] = window.corner[k];
        low[k] = low_word(base);
        for (std::size_t i = 0; i < static_cast<std::size_t>(level); ++i)
            low[k] = low[k] << 2 | (i < digits.size() ? digits[i] : 0U);
    }
    return low;
}

std::uint32_t point_bits(std::uint32_t seed, const RecursiveWindow& window, const RecursiveOrigin& origin)
{
    const auto low = low_bits(window, origin.level);
    return ptiles_mix(ptiles_hash(seed, low[0] + static_cast<std::uint32_t>(origin.tile[0]),
                                  low[1] + static_cast<std::uint32_t>(origin.tile[1]),
                                  static_cast<std::uint32_t>(origin.level)) +
                      1 + origin.rank);
}

std::array<double, 2> place_in_window(const RecursiveWindow& window, const RecursivePoint& point)
{
    const int down = 2 * (point.level - static_cast<int>(window.corner[0].digits.size()));
    std::array<double, 2> place{};
    for (std::size_t k = 0; k < 2; ++k)
        place[k] = std::ldexp(static_cast<double>(point.cell[k]) + point.place[k] * 0x1p-32, -down);
    return place;
}

}
