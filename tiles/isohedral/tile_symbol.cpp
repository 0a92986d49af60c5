#include "tiles/isohedral/tile_symbol.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

namespace poissonlab {
namespace {

using Symmetry = std::vector<std::size_t>; ///< where each chamber goes

/// The rotations and reflections of a tile that keep the degrees of its vertices; first the one that moves nothing.
std::vector<Symmetry> symmetries_of(const std::vector<int>& degrees)
{
    const std::size_t k = degrees.size();
    std::vector<Symmetry> all;
    for (const bool is_mirror : {false, true})
        for (std::size_t shift = 0; shift < k; ++shift) {
            // Vertex i goes to vertex shift + i, or shift - i.
            const auto vertex = [&](std::size_t i) { return (is_mirror ? shift + k - i : shift + i) % k; };
            bool keeps = true;
            for (std::size_t i = 0; i < k; ++i) keeps &= degrees[i] == degrees[vertex(i)];
            if (!keeps) continue;
            Symmetry symmetry;
            for (std::size_t e = 0; e < k; ++e)
                for (const std::size_t end : {e, (e + 1) % k}) {
                    const std::size_t edge = is_mirror ? vertex((e + 1) % k) : vertex(e);
                    symmetry.push_back(2 * edge + (vertex(end) == edge ? 0 : 1));
                }
            all.push_back(std::move(symmetry));
        }
    return all;
}

Symmetry product(const Symmetry& a, const Symmetry& b)
{
    Symmetry result;
    for (const std::size_t chamber : b) result.push_back(a[chamber]);
    return result;
}

/// All groups that some of the symmetries make: of rotations and reflections, two generators are enough.
std::vector<std::vector<Symmetry>> subgroups_of(const std::vector<Symmetry>& all)
{
    std::set<std::vector<Symmetry>> groups;
    for (const Symmetry& a : all)
        for (const Symmetry& b : all) {
            std::set<Symmetry> group{all[0]};
            for (bool grows = true; grows;) {
                const std::size_t before = group.size();
                for (const Symmetry& member : std::set<Symmetry>(group)) {
                    group.insert(product(member, a));
                    group.insert(product(member, b));
                }
                grows = group.size() > before;
            }
            groups.insert({group.begin(), group.end()});
        }
    return {groups.begin(), groups.end()};
}

/// Numbers the classes of chambers under a group in the order of their first chambers.
std::vector<std::size_t> classes_under(const std::vector<Symmetry>& group, std::size_t chambers)
{
    std::vector<std::size_t> first(chambers), numbers(chambers), class_of(chambers);
    std::size_t count = 0;
    for (std::size_t chamber = 0; chamber < chambers; ++chamber) {
        first[chamber] = chamber;
        for (const Symmetry& symmetry : group) first[chamber] = std::min(first[chamber], symmetry[chamber]);
        if (first[chamber] == chamber) numbers[chamber] = count++;
        class_of[chamber] = numbers[first[chamber]];
    }
    return class_of;
}

TileSymbol symbol_under(const std::vector<int>& degrees, const std::vector<Symmetry>& group)
{
    TileSymbol symbol{degrees, classes_under(group, 2 * degrees.size()), {}, group};
    // The symmetry that moves nothing is the smallest.
    std::ranges::sort(symbol.symmetries);
    symbol.across.assign(1 + std::ranges::max(symbol.class_of), 0);
    return symbol;
}

std::size_t vertex_of(std::size_t chamber, std::size_t edges) { return (chamber + 1) / 2 % edges; }

/// The action of s0 and s1 on classes, and the degree at the vertex of each.
struct ClassMaps
{
    std::vector<std::size_t> half, beside;
    std::vector<int> degree;

    explicit ClassMaps(const TileSymbol& s) : half(s.classes()), beside(s.classes()), degree(s.classes())
    {
        for (std::size_t chamber = 0; chamber < s.class_of.size(); ++chamber) {
            const std::size_t its = s.class_of[chamber];
            half[its] = s.class_of[other_half(chamber)];
            beside[its] = s.class_of[beside_vertex(chamber, s.edges())];
            degree[its] = s.degrees[vertex_of(chamber, s.edges())];
        }
    }
};

/// True if the tiles around each vertex have one degree there, and their chambers repeat after a number of tiles that
/// divides it.
bool closes_at_vertices(const TileSymbol& s, const ClassMaps& maps)
{
    for (std::size_t start = 0; start < s.classes(); ++start) {
        std::size_t at = start;
        int tiles = 0;
        do {
            if (maps.degree[at] != maps.degree[start]) return false;
            at = maps.beside[s.across[at]];
            ++tiles;
        } while (at != start);
        if (maps.degree[start] % tiles != 0) return false;
    }
    return true;
}

/// A text that is the same for symbols that differ in names only: classes numbered in the order in which s0, s1 and s2
/// reach them from each class, and of these the smallest.
std::vector<std::size_t> canonical_form(const TileSymbol& s, const ClassMaps& maps)
{
    std::vector<std::size_t> smallest;
    for (std::size_t start = 0; start < s.classes(); ++start) {
        std::map<std::size_t, std::size_t> number{{start, 0}};
        std::vector<std::size_t> order{start}, form;
        for (std::size_t i = 0; i < order.size(); ++i) {
            const std::size_t at = order[i];
            for (const std::size_t next : {maps.half[at], maps.beside[at], s.across[at]}) {
                const auto [place, is_new] = number.try_emplace(next, number.size());
                if (is_new) order.push_back(next);
                form.push_back(place->second);
            }
            form.push_back(static_cast<std::size_t>(maps.degree[at]));
        }
        if (smallest.empty() || form < smallest) smallest = std::move(form);
    }
    return smallest;
}

/// Tries all involutions s2 that commute with s0, and hands those that close at vertices to `found`.
class AcrossFinder
{
public:
    template <class Found>
    static void find(TileSymbol symbol, const Found& found)
    {
        const ClassMaps maps(symbol);
        constexpr auto open = static_cast<std::size_t>(-1);
        symbol.across.assign(symbol.classes(), open);
        extend(symbol, maps, open, found);
    }

private:
    template <class Found>
    static void extend(TileSymbol& symbol, const ClassMaps& maps, std::size_t open, const Found& found)
    {
        const auto next = std::ranges::find(symbol.across, open);
        if (next == symbol.across.end()) {
            if (closes_at_vertices(symbol, maps)) found(symbol, maps);
            return;
        }
        const auto at = static_cast<std::size_t>(next - symbol.across.begin());
        for (std::size_t to = 0; to < symbol.classes(); ++to) {
            // Both halves of an edge go across together.
            const std::size_t half = maps.half[at], to_half = maps.half[to];
            if (symbol.across[to] != open || (at == half) != (to == to_half) || maps.degree[at] != maps.degree[to] ||
                maps.degree[half] != maps.degree[to_half])
                continue;
            const std::vector<std::size_t> before = symbol.across;
            symbol.across[at] = to;
            symbol.across[to] = at;
            symbol.across[half] = to_half;
            symbol.across[to_half] = half;
            extend(symbol, maps, open, found);
            symbol.across = before;
        }
    }
};

}

const std::vector<LavesTiling>& laves_tilings()
{
    static const std::vector<LavesTiling> all{
        {"3^6", {3, 3, 3, 3, 3, 3}},    {"3^4.6", {3, 3, 3, 3, 6}}, {"3^3.4^2", {3, 3, 3, 4, 4}},
        {"3^2.4.3.4", {3, 3, 4, 3, 4}}, {"3.4.6.4", {3, 4, 6, 4}},  {"3.6.3.6", {3, 6, 3, 6}},
        {"3.12^2", {3, 12, 12}},        {"4^4", {4, 4, 4, 4}},      {"4.6.12", {4, 6, 12}},
        {"4.8^2", {4, 8, 8}},           {"6^3", {6, 6, 6}}};
    return all;
}

const char* name_of(EdgeShape shape)
{
    constexpr std::array names{"J", "S", "U", "I"};
    return names[static_cast<std::size_t>(shape)];
}

std::size_t TileSymbol::chamber_of(std::size_t its_class) const
{
    return static_cast<std::size_t>(std::ranges::find(class_of, its_class) - class_of.begin());
}

EdgeShape TileSymbol::shape(std::size_t edge) const
{
    const std::size_t here = class_of[2 * edge], half = class_of[2 * edge + 1], there = across[here];
    if (there == here) return EdgeShape::straight;
    if (half == here) return EdgeShape::mirrored;
    return there == half ? EdgeShape::turned : EdgeShape::free;
}

std::string TileSymbol::incidence(std::size_t first_edge, bool is_clockwise) const
{
    // The class where the arrow of each letter starts.
    std::vector<std::size_t> letters;
    std::string text;
    const auto letter_at = [&](std::size_t start, std::size_t end) {
        const auto place = [&](std::size_t its_class) {
            return static_cast<std::size_t>(std::ranges::find(letters, its_class) - letters.begin());
        };
        const bool is_directed = start != end;
        std::size_t letter = place(start);
        const char* sign = "+";
        if (letter == letters.size() && place(end) < letters.size()) {
            letter = place(end);
            sign = "-";
        }
        return std::pair(letter, is_directed ? std::string(sign) : std::string());
    };
    for (std::size_t i = 0; i < edges(); ++i) {
        const std::size_t edge = (is_clockwise ? first_edge + edges() - i : first_edge + i) % edges();
        const std::size_t start = class_of[2 * edge + (is_clockwise ? 1 : 0)];
        const std::size_t end = class_of[2 * edge + (is_clockwise ? 0 : 1)];
        const auto [letter, sign] = letter_at(start, end);
        if (letter == letters.size()) letters.push_back(start);
        text += static_cast<char>('a' + letter) + sign;
    }
    text += ";";
    for (std::size_t i = 0; i < letters.size(); ++i) {
        // Arrows that start at the same vertex on both sides run in the same direction, which is a minus.
        const std::size_t start = across[letters[i]];
        const std::size_t end = class_of[other_half(chamber_of(start))];
        const auto [letter, sign] = letter_at(start, end);
        text += static_cast<char>('a' + letter) + (sign.empty() ? "" : sign == "+" ? std::string("-") : "+");
    }
    return text;
}

std::vector<std::string> TileSymbol::incidences() const
{
    std::set<std::string> all;
    for (std::size_t edge = 0; edge < edges(); ++edge)
        for (const bool is_clockwise : {false, true}) all.insert(incidence(edge, is_clockwise));
    return {all.begin(), all.end()};
}

namespace {

/// The symbol with its edges numbered from `first` on. Where this is clockwise, the tile is reflected.
TileSymbol renumbered(const TileSymbol& symbol, std::size_t first, bool is_clockwise)
{
    const std::size_t k = symbol.edges();
    std::vector<std::size_t> before(2 * k), after(2 * k); // numbers of chambers
    TileSymbol result{{}, std::vector<std::size_t>(2 * k), symbol.across, symbol.symmetries};
    for (std::size_t chamber = 0; chamber < 2 * k; ++chamber) {
        const std::size_t edge = chamber / 2, half = chamber % 2;
        before[chamber] = is_clockwise ? 2 * ((first + k - edge) % k) + 1 - half : 2 * ((first + edge) % k) + half;
        after[before[chamber]] = chamber;
        result.class_of[chamber] = symbol.class_of[before[chamber]];
        if (half == 0) result.degrees.push_back(symbol.degrees[vertex_of(before[chamber], k)]);
    }
    for (std::size_t i = 0; i < result.symmetries.size(); ++i)
        for (std::size_t chamber = 0; chamber < 2 * k; ++chamber)
            result.symmetries[i][chamber] = after[symbol.symmetries[i][before[chamber]]];
    return result;
}

}

TileSymbol read_from(const TileSymbol& symbol, const std::string& incidence)
{
    for (std::size_t first = 0; first < symbol.edges(); ++first)
        for (const bool is_clockwise : {false, true})
            if (symbol.incidence(first, is_clockwise) == incidence) return renumbered(symbol, first, is_clockwise);
    throw std::logic_error("a tile has no incidence symbol " + incidence);
}

TileSymbol mirror_image(const TileSymbol& symbol) { return renumbered(symbol, 0, true); }

bool is_own_mirror_image(const TileSymbol& symbol)
{
    const TileSymbol mirrored = mirror_image(symbol);
    for (std::size_t first = 0; first < symbol.edges(); ++first) {
        const TileSymbol turned = renumbered(mirrored, first, false);
        if (turned.degrees == symbol.degrees && turned.incidence(0, false) == symbol.incidence(0, false)) return true;
    }
    return false;
}

std::vector<TileSymbol> tile_symbols(const LavesTiling& laves)
{
    std::vector<TileSymbol> symbols;
    std::set<std::vector<std::size_t>> forms;
    for (const auto& group : subgroups_of(symmetries_of(laves.degrees)))
        AcrossFinder::find(symbol_under(laves.degrees, group), [&](const TileSymbol& found, const ClassMaps& maps) {
            if (forms.insert(canonical_form(found, maps)).second) symbols.push_back(found);
        });
    return symbols;
}

std::vector<TileSymbol> more_symmetric(const TileSymbol& symbol)
{
    std::vector<TileSymbol> result;
    for (const auto& group : subgroups_of(symmetries_of(symbol.degrees))) {
        if (group.size() <= symbol.symmetries.size()) continue;
        TileSymbol larger = symbol_under(symbol.degrees, group);
        // Classes of the larger group are made of whole classes of the smaller one, and s2 keeps them together.
        bool fits = std::ranges::all_of(symbol.symmetries, [&](const Symmetry& symmetry) {
            return std::ranges::find(group, symmetry) != group.end();
        });
        constexpr auto open = static_cast<std::size_t>(-1);
        std::ranges::fill(larger.across, open);
        for (std::size_t chamber = 0; chamber < symbol.class_of.size() && fits; ++chamber) {
            std::size_t& to = larger.across[larger.class_of[chamber]];
            const std::size_t its = larger.class_of[symbol.chamber_across(chamber)];
            fits = to == open || to == its;
            to = its;
        }
        if (fits) result.push_back(std::move(larger));
    }
    return result;
}

}
