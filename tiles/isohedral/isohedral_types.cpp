#include "tiles/isohedral/isohedral_types.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>

namespace poissonlab {
namespace {

struct NumberedSymbol
{
    int number;
    const char* symbol;
};

/// The types that shapes can tell, by topology: a symbol alone does not tell it (IH31 and IH33).
const std::vector<std::vector<NumberedSymbol>>& numbered_symbols()
{
    static const std::vector<std::vector<NumberedSymbol>> symbols{
        {{1, "a+b+c+d+e+f+;d+e+f+a+b+c+"},
         {2, "a+b+c+d+e+f+;b-a-f+e-d-c+"},
         {3, "a+b+c+d+e+f+;c-e+a-f-b+d-"},
         {4, "a+b+c+d+e+f+;a+e+c+d+b+f+"},
         {5, "a+b+c+d+e+f+;a+e+d-c-b+f+"},
         {6, "a+b+c+d+e+f+;a+e-c+f-b-d-"},
         {7, "a+b+c+d+e+f+;b+a+d+c+f+e+"},
         {8, "a+b+c+a+b+c+;a+b+c+"},
         {9, "a+b+c+a+b+c+;a+c-b-"},
         {10, "a+b+a+b+a+b+;b+a+"},
         {11, "a+a+a+a+a+a+;a+"},
         {12, "ab+c+dc-b-;dc-b-a"},
         {13, "ab+c+dc-b-;db+c+a"},
         {14, "a+b+b-a-c+c-;a-c+b+"},
         {15, "a+b+c+c-b-a-;a+b-c+"},
         {16, "a+b+c+c-b-a-;a-c+b+"},
         {17, "ab+b-ab+b-;ab+"},
         {18, "ababab;ba"},
         {20, "aaaaaa;a"}},
        {{21, "a+b+c+d+e+;a+c+b+e+d+"}},
        {{22, "a+b+c+d+e+;b-a-e+d-c+"},
         {23, "a+b+c+d+e+;a+b+e+d+c+"},
         {24, "a+b+c+d+e+;a+b+e+d-c+"},
         {25, "a+b+c+d+e+;b-a-e+d+c+"},
         {26, "a+a-b+cb-;a+b-c"}},
        {{27, "a+b+c+d+e+;a+d-e-b-c-"}, {28, "a+b+c+d+e+;a+c+b+e+d+"}, {29, "ab+c+c-b-;ac+b+"}},
        {{30, "a+b+c+d+;d+b-c-a+"}, {31, "a+b+c+d+;d+c+b+a+"}, {32, "a+b+b-a-;a-b-"}},
        {{33, "a+b+c+d+;d+c+b+a+"}, {34, "a+b+a+b+;b+a+"}, {36, "a+a-b+b-;b-a-"}, {37, "a+a-a+a-;a-"}},
        {{38, "a+b+c+;c+b-a+"}, {39, "a+b+c+;c+b+a+"}, {40, "a+ba-;a-b"}},
        {{41, "a+b+c+d+;c+d+a+b+"}, {42, "a+b+c+d+;c+b-a+d-"}, {43, "a+b+c+d+;c+d-a+b-"},
         {44, "a+b+c+d+;b-a-d-c-"}, {45, "a+b+c+d+;c-b-a-d-"}, {46, "a+b+c+d+;a+b+c+d+"},
         {47, "a+b+c+d+;c+b+a+d+"}, {49, "a+b+c+d+;a-b+c-d+"}, {50, "a+b+c+d+;c+b-a+d+"},
         {51, "a+b+c+d+;c-b+a-d+"}, {52, "a+b+c+d+;c-d-a-b-"}, {53, "a+b+c+d+;b-a-c+d+"},
         {54, "a+b+c+d+;a-b-c-d+"}, {55, "a+b+c+d+;b+a+d+c+"}, {56, "a+b+c+d+;b+a+c-d-"},
         {57, "a+b+a+b+;a+b+"},     {58, "a+b+a+b+;a+b-"},     {59, "a+b+a+b+;b-a-"},
         {61, "a+b+a+b+;b+a+"},     {62, "a+a+a+a+;a+"},       {64, "a+ba-c;a-cb"},
         {66, "ab+cb-;cb+a"},       {67, "a+ba-c;a+bc"},       {68, "a+b+b-a-;b-a-"},
         {69, "a+b+b-a-;a+b+"},     {71, "a+b+b-a-;b+a+"},     {72, "abab;ab"},
         {73, "abab;ba"},           {74, "a+a-a+a-;a+"},       {76, "aaaa;a"}},
        {{77, "a+b+c+;a-b-c-"}},
        {{78, "a+b+c+;a-b+c-"}, {79, "a+b+c+;c+b+a+"}, {81, "a+b+c+;c+b-a+"}, {82, "a+ba-;a-b"}},
        {{83, "a+b+c+;b-a-c-"},
         {84, "a+b+c+;a+b+c+"},
         {85, "a+b+c+;a-b+c+"},
         {86, "a+b+c+;b-a-c+"},
         {88, "a+b+c+;b+a+c+"},
         {90, "a+a+a+;a+"},
         {91, "a+a-b;a+b"},
         {93, "aaa;a"}}};
    return symbols;
}

/// A type that needs markings: its topology, how many symmetries its tile has, whether mirrors are among them, and
/// whether a mirror goes through the middle of an edge.
struct MarkedNumber
{
    int number;
    const char* topology;
    std::size_t symmetries;
    bool has_mirrors;
    bool has_mirrored_edges;
};

constexpr MarkedNumber marked_numbers[] = {
    {19, "3^6", 6, true, false},  {35, "3.6.3.6", 2, true, false}, {48, "4^4", 1, false, false},
    {60, "4^4", 2, false, false}, {63, "4^4", 4, false, false},    {65, "4^4", 2, true, true},
    {70, "4^4", 2, true, false},  {75, "4^4", 4, true, false},     {80, "4.8^2", 1, false, false},
    {87, "6^3", 1, false, false}, {89, "6^3", 3, false, false},    {92, "6^3", 2, true, true}};

bool is_mirror(const std::vector<std::size_t>& symmetry) { return symmetry[0] % 2 == 1; }

bool agrees(const MarkedNumber& marked, const TileSymbol& symbol, const std::string& topology)
{
    bool has_mirrored_edges = false;
    for (std::size_t e = 0; e < symbol.edges(); ++e)
        has_mirrored_edges |= symbol.class_of[2 * e] == symbol.class_of[2 * e + 1];
    return topology == marked.topology && symbol.symmetries.size() == marked.symmetries &&
           std::ranges::any_of(symbol.symmetries, is_mirror) == marked.has_mirrors &&
           has_mirrored_edges == marked.has_mirrored_edges;
}

/// The type of a symbol, with the incidence symbol that it is printed with; not yet its shape.
IsohedralType numbered(const TileSymbol& symbol, std::size_t topology)
{
    const std::string& name = laves_tilings()[topology].name;
    const std::vector<std::string> incidences = symbol.incidences();
    for (const NumberedSymbol& known : numbered_symbols()[topology])
        if (std::ranges::find(incidences, known.symbol) != incidences.end()) return {known.number, known.symbol, name};
    for (const MarkedNumber& marked : marked_numbers)
        if (agrees(marked, symbol, name)) return {marked.number, incidences.front(), name};
    throw std::logic_error("an isohedral type without a number: " + incidences.front());
}

std::vector<IsohedralType> found_types()
{
    std::vector<IsohedralType> types;
    for (std::size_t topology = 0; topology < laves_tilings().size(); ++topology)
        for (const TileSymbol& symbol : tile_symbols(laves_tilings()[topology])) {
            IsohedralType type = numbered(symbol, topology);
            type.shape = isohedral_template(read_from(symbol, type.symbol));
            type.is_marked = needs_markings(type.shape);
            types.push_back(std::move(type));
        }
    std::ranges::sort(types, {}, &IsohedralType::number);
    return types;
}

/// By number; null where a type is its own mirror image.
std::vector<std::unique_ptr<const IsohedralType>> found_mirrored_types()
{
    std::vector<std::unique_ptr<const IsohedralType>> mirrored;
    for (const IsohedralType& type : isohedral_types()) {
        mirrored.emplace_back();
        if (is_own_mirror_image(type.shape.symbol)) continue;
        IsohedralType image{type.number, type.symbol, type.topology, type.is_marked};
        image.shape = isohedral_template(mirror_image(type.shape.symbol));
        mirrored.back() = std::make_unique<const IsohedralType>(std::move(image));
    }
    return mirrored;
}

}

const std::vector<IsohedralType>& isohedral_types()
{
    static const std::vector<IsohedralType> types = found_types();
    return types;
}

const IsohedralType* mirrored_type(int number)
{
    static const std::vector<std::unique_ptr<const IsohedralType>> types = found_mirrored_types();
    return types[static_cast<std::size_t>(number - 1)].get();
}

}
