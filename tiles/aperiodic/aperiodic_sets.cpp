#include "tiles/aperiodic/aperiodic_sets.hpp"

#include <algorithm>
#include <array>

namespace poissonlab {
namespace {

/// A machine that multiplies by numerator / denominator. Its carries are `first_carry` to `last_carry` over the
/// denominator; their vertical colours begin with `first_color`.
struct Multiplier
{
    int numerator, denominator;
    int first_carry, last_carry;
    int first_color;
    int most_north;
    int least_south, most_south;
};

/// Calls `add(north, east, south, west)` for all digits and carries with q N + W = S + E.
template <class Add>
void for_each_product(const Multiplier& m, const Add& add)
{
    for (int north = 0; north <= m.most_north; ++north)
        for (int west = m.first_carry; west <= m.last_carry; ++west)
            for (int south = m.least_south; south <= m.most_south; ++south) {
                const int east = m.numerator * north + west - m.denominator * south;
                if (east < m.first_carry || east > m.last_carry) continue;
                add(north, m.first_color + east - m.first_carry, south, m.first_color + west - m.first_carry);
            }
}

WangTile tile_of(int north, int east, int south, int west)
{
    return {static_cast<Color>(north), static_cast<Color>(east), static_cast<Color>(south), static_cast<Color>(west)};
}

/// Four digits of a hexadecimal number a tile, in the order that `places` says: of north, east, south and west.
template <std::size_t N>
WangList listed(const std::array<const char*, N>& digits, const std::array<std::size_t, 4>& places)
{
    std::vector<WangTile> tiles;
    for (const char* text : digits) {
        const auto digit = [&](std::size_t edge) {
            const char c = text[places[edge]];
            return c <= '9' ? c - '0' : c - 'a' + 10;
        };
        tiles.push_back(tile_of(digit(0), digit(1), digit(2), digit(3)));
    }
    return renumbered(std::move(tiles));
}

}

WangList kari_tiles()
{
    std::vector<WangTile> tiles;
    const auto add = [&](int north, int east, int south, int west) {
        tiles.push_back(tile_of(north, east, south, west));
    };
    for_each_product({2, 1, -1, 0, 0, 1, 1, 2}, add);
    const auto add_third = [&](int north, int east, int south, int west) {
        if (north > 0) add(north, east, south, west);
    };
    for_each_product({2, 3, -1, 2, 2, 2, 0, 2}, add_third);
    return {std::move(tiles), {3, 6}};
}

WangList culik_tiles()
{
    constexpr int marked_zero = 3;
    std::vector<WangTile> tiles;
    for_each_product({3, 1, 0, 2, 0, 1, 1, 2}, [&](int north, int east, int south, int west) {
        tiles.push_back(tile_of(north, east, south, west));
    });
    for_each_product({1, 2, 0, 1, 3, 2, 0, 1}, [&](int north, int east, int south, int west) {
        tiles.push_back(tile_of(north == 0 ? marked_zero : north, east, south, west));
        // Where the next row is multiplied by 1/2 again, its zeros are marked.
        if (north == 1 && south == 0) tiles.push_back(tile_of(north, east, marked_zero, west));
    });
    return {std::move(tiles), {4, 5}};
}

WangList ammann_tiles()
{
    constexpr std::array west_north_east_south{"0110", "3223", "2442", "5335", "2423", "5323", "3242", "3235",
                                               "4031", "2051", "4020", "3151", "1502", "1304", "1513", "0204"};
    return listed(west_north_east_south, {1, 2, 3, 0});
}

WangList robinson_tiles()
{
    constexpr std::array north_east_south_west{"00aa", "1100", "1220", "1370", "13a9", "2644", "3a16", "4033",
                                               "409b", "40b5", "4753", "53aa", "5544", "5b66", "5ba4", "6647",
                                               "7648", "8916", "9416", "a411", "a452", "a682", "a853", "b850"};
    return listed(north_east_south_west, {0, 1, 2, 3});
}

WangList jeandel_rao_tiles()
{
    constexpr std::array east_north_west_south{"2021", "2220", "1131", "1232", "3133", "0131",
                                               "0001", "3102", "0212", "1210", "3312"};
    return listed(east_north_west_south, {1, 0, 3, 2});
}

const std::vector<AperiodicSet>& aperiodic_sets()
{
    constexpr auto only_printed = "printed as a picture only: Grünbaum and Shephard 1986, page 593";
    static const std::vector<AperiodicSet> sets{
        {"culik", "Culik 13/5", "Culik 1996", culik_tiles, "8.5"},
        {"kari", "Kari 14/6", "Kari 1996", kari_tiles, "8.4"},
        {"ammann", "Ammann 16/6", "Grünbaum and Shephard 1986 after Ammann, as listed by Stam 1997", ammann_tiles,
         "8.3"},
        {"robinson", "Robinson 24/24", "Robinson 1977, derived anew from Ammann's tiles A2", robinson_tiles, "8.2"},
        {"", "Penrose 32/16", "Penrose", nullptr, "8.1", only_printed},
        {"jeandel-rao", "Jeandel and Rao 11/4", "Jeandel and Rao 2015, two of five colours merged", jeandel_rao_tiles}};
    return sets;
}

std::vector<std::string> aperiodic_set_names()
{
    std::vector<std::string> names;
    for (const AperiodicSet& set : aperiodic_sets())
        if (!set.name.empty()) names.push_back(set.name);
    return names;
}

const AperiodicSet* find_aperiodic_set(const std::string& name)
{
    if (name.empty()) return nullptr;
    const auto found = std::ranges::find(aperiodic_sets(), name, &AperiodicSet::name);
    return found == aperiodic_sets().end() ? nullptr : &*found;
}

}
