// Tilings by polygons that the program brings: against closed forms of their counts, published atlases of vertices and
// tables of symmetry groups, and exact areas.
#include "host/settings/tilings/polygon_tiling_file.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tiles/prototiles/patch_survey.hpp"
#include "tiles/prototiles/periodic_tiling.hpp"
#include "tiles/prototiles/substitution.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <fstream>
#include <map>
#include <numbers>
#include <random>
#include <set>

namespace poissonlab {
namespace {

constexpr std::size_t plenty = 1'000'000;

std::vector<PlacedTile> tiles_of(const std::vector<AddressedTile>& addressed)
{
    std::vector<PlacedTile> tiles;
    for (const AddressedTile& tile : addressed) tiles.push_back(tile.tile);
    return tiles;
}

std::vector<PlacedTile> patch_of(const std::string& word, int depth, std::size_t start = 0)
{
    return tiles_of(Substitution(built_in_tiling(word), start).tiles(depth, plenty));
}

/// Tiles by prototile; mirrored ones are counted apart.
std::map<std::pair<std::string, bool>, std::uint64_t> counts_of(const std::string& word, int depth)
{
    std::map<std::pair<std::string, bool>, std::uint64_t> counts;
    const PolygonTiling& tiling = built_in_tiling(word);
    for (const PlacedTile& tile : patch_of(word, depth))
        ++counts[{tiling.prototiles[tile.prototile].name, tile.motion.is_mirrored}];
    return counts;
}

std::uint64_t fibonacci_number(int n)
{
    const double root = std::sqrt(5.0);
    return static_cast<std::uint64_t>(std::llround(std::pow(std::numbers::phi, n) / root)); // Binet
}

std::uint64_t power(std::int64_t base, int exponent)
{
    return static_cast<std::uint64_t>(std::llround(std::pow(static_cast<double>(base), exponent)));
}

TEST(BuiltInTilings, AreTheFilesOfTheirFolder)
{
    std::set<std::string> files, words;
    for (const auto& entry : std::filesystem::directory_iterator(source_folder() + "/configs/tilings"))
        files.insert(entry.path().stem().string());
    for (const auto* list : {&substitution_words(), &periodic_words()}) words.insert(list->begin(), list->end());
    EXPECT_EQ(files, words);
    for (const std::string& word : substitution_words()) EXPECT_FALSE(built_in_tiling(word).is_periodic()) << word;
    for (const std::string& word : periodic_words()) EXPECT_TRUE(built_in_tiling(word).is_periodic()) << word;
}

TEST(SubstitutionTilings, HaveAsManyTilesAsTheirMatricesSay)
{
    for (int n = 0; n <= 6; ++n) {
        // Matrices ((2, 1), (1, 1)), whose eigenvalues are the golden ratio to the powers 2 and -2.
        for (const auto& [word, first, second] :
             {std::tuple{"penrose-kite-dart", "kite", "dart"}, std::tuple{"penrose-rhombs", "thick", "thin"}}) {
            const auto counts = counts_of(word, n);
            EXPECT_EQ(counts.contains({first, false}) ? counts.at({first, false}) : 0, fibonacci_number(2 * n + 1));
            EXPECT_EQ(counts.contains({second, false}) ? counts.at({second, false}) : 0, fibonacci_number(2 * n));
        }
        EXPECT_EQ(patch_of("chair", n).size(), power(4, n));
        // One part is direct and three are mirrored: eigenvalues 4 and -2.
        const auto sphinxes = counts_of("sphinx", n);
        EXPECT_EQ(sphinxes.contains({"sphinx", false}) ? sphinxes.at({"sphinx", false}) : 0,
                  (power(4, n) + power(-2, n)) / 2);
    }
    // ((13, 10), (12, 15)): eigenvalues 25 and 3, and so 6 kites for each 5 in the other direction.
    for (int n = 0; n <= 2; ++n) {
        const auto counts = counts_of("kite-domino", n);
        std::uint64_t kites = 0;
        for (const auto& [name, count] : counts) kites += name.first == "kite" ? count : 0;
        EXPECT_EQ(11 * kites, 5 * power(25, n) + 6 * power(3, n));
    }
}

TEST(SubstitutionTilings, HavePartsOfTheAreaOfTheWholeExactly)
{
    for (const std::string& word : substitution_words()) {
        if (word == "shield") continue; // what stands out of one tile is cut out of another
        const PolygonTiling& tiling = built_in_tiling(word);
        const RootRing& ring = tiling.ring;
        for (std::size_t i = 0; i < tiling.parts.size(); ++i) {
            RingPlace parts;
            for (const PlacedTile& part : tiling.parts[i])
                parts = parts + quadruple_area(ring, corners_of(tiling, part));
            const RingPlace whole = quadruple_area(ring, corners_of(tiling, {i, {{}, tiling.magnification, false}}));
            EXPECT_EQ(parts, whole) << word << ", " << tiling.prototiles[i].name;
        }
    }
}

TEST(SubstitutionTilings, HaveShieldsWhosePartsMakeUpForEachOther)
{
    // The areas of tiles after n divisions, over those before: in the limit 2 + sqrt(3), the square of the factor.
    const PolygonTiling& tiling = built_in_tiling("shield");
    const Substitution substitution(tiling, 3);
    const auto area = [&](int depth) {
        const auto counts = *substitution.counts(depth, std::uint64_t{1} << 62);
        double sum = 0;
        for (std::size_t i = 0; i < counts.size(); ++i) sum += static_cast<double>(counts[i]) * area_of(tiling, i);
        return sum;
    };
    EXPECT_NEAR(area(30) / area(29), 2 + std::numbers::sqrt3, 1e-7);
}

TEST(SubstitutionTilings, FillThePlaneWithoutGapsAndOverlaps)
{
    const std::map<std::string, int> depths{{"penrose-kite-dart", 8},
                                            {"penrose-rhombs", 8},
                                            {"robinson-triangles", 8},
                                            {"kite-domino", 2},
                                            {"shield", 5},
                                            {"chair", 5},
                                            {"sphinx", 5}};
    for (const std::string& word : substitution_words()) {
        const PolygonTiling& tiling = built_in_tiling(word);
        for (std::size_t start = 0; start < tiling.starts.size(); ++start) {
            const PatchSurvey survey = survey_patch(tiling, patch_of(word, depths.at(word), start));
            EXPECT_EQ(survey.crowded_edges, 0U) << word << ", start " << start;
            EXPECT_EQ(survey.odd_vertices, 0U) << word << ", start " << start;
            EXPECT_EQ(survey.unfit_edges, 0U) << word << ", start " << start;
            EXPECT_GT(survey.inner_edges, 5 * survey.border_edges) << word << ", start " << start;
        }
    }
}

TEST(PenroseTilings, HaveTheSevenAndTheEightVerticesOfTheAtlases)
{
    // Gruenbaum and Shephard, Tilings and Patterns, 1987, figure 10.5.2 (Conway's names), as tiles around: kites and
    // darts by their angles.
    const auto figures = [](const std::string& word) {
        std::set<std::string> kinds;
        const PolygonTiling& tiling = built_in_tiling(word);
        for (std::size_t start = 0; start < tiling.starts.size(); ++start)
            for (const VertexFigure& figure : survey_patch(tiling, patch_of(word, 8, start)).figures)
                kinds.insert(figure.tiles);
        return kinds;
    };
    const std::string tail = "kite 72° Aa", side = "kite 72° bA", head = "kite 144° Bb", tip = "dart 72° aA",
                      wing = "dart 36° Ba", reflex = "dart 216° bB";
    const auto row = [](const std::vector<std::string>& tiles) {
        std::string text;
        for (const std::string& tile : tiles) text += (text.empty() ? "" : ", ") + tile;
        return text;
    };
    EXPECT_EQ(figures("penrose-kite-dart"), (std::set<std::string>{
                                                row({tail, tail, tail, tail, tail}), // sun
                                                row({tip, tip, tip, tip, tip}),      // star
                                                row({reflex, side, side}),           // ace
                                                row({wing, wing, head, head}),       // deuce
                                                row({wing, head, wing, tail, tail}), // jack
                                                row({tip, tip, tip, side, side}),    // king
                                                row({tip, side, side, side, side}),  // queen
                                            }));
    // De Bruijn, Algebraic theory of Penrose's non-periodic tilings, 1981: D, Q, K, J, S3, S4, S5, S.
    const auto rhombs = figures("penrose-rhombs");
    EXPECT_EQ(rhombs.size(), 8U);
    std::multiset<std::pair<std::ptrdiff_t, std::ptrdiff_t>> thick_and_all;
    for (const std::string& figure : rhombs) {
        std::ptrdiff_t thick = 0;
        for (std::size_t at = figure.find("thick"); at != std::string::npos; at = figure.find("thick", at + 1)) ++thick;
        thick_and_all.emplace(thick, std::ranges::count(figure, ',') + 1);
    }
    EXPECT_EQ(thick_and_all, (std::multiset<std::pair<std::ptrdiff_t, std::ptrdiff_t>>{
                                 {1, 3}, {2, 3}, {3, 4}, {3, 5}, {3, 7}, {4, 6}, {5, 5}, {5, 5}}));
}

TEST(PatchSurvey, SeesOverlapsGapsAndMismatches)
{
    const PolygonTiling& tiling = built_in_tiling("penrose-kite-dart");
    std::vector<PlacedTile> tiles = patch_of("penrose-kite-dart", 5);
    const PatchSurvey good = survey_patch(tiling, tiles);
    ASSERT_EQ(good.crowded_edges + good.odd_vertices + good.unfit_edges, 0U);
    std::vector<PlacedTile> twice = tiles;
    twice.push_back(tiles[40]);
    EXPECT_GT(survey_patch(tiling, twice).crowded_edges, 0U);
    std::vector<PlacedTile> fewer = tiles;
    fewer.erase(fewer.begin() + 40);
    EXPECT_LT(survey_patch(tiling, fewer).inner_vertices, good.inner_vertices);
    EXPECT_LT(survey_patch(tiling, fewer).inner_edges, good.inner_edges);
    // A kite turned around its tail by a tenth of a turn lies across its neighbours.
    std::vector<PlacedTile> turned = tiles;
    turned[40].motion.turn = tiling.ring.times(turned[40].motion.turn, tiling.ring.unit(1));
    EXPECT_NE(survey_patch(tiling, turned).inner_edges, good.inner_edges);
    // Two kites with their long edges side by side, tail to side: kites fit, letters do not.
    const RootRing& ring = tiling.ring;
    const RingPlace phi = ring.unit(1) + ring.unit(-1), far = ring.times(phi, ring.unit(1));
    const std::vector<PlacedTile> pair{{0, {}}, {0, {far, ring.unit(5), false}}};
    const PatchSurvey survey = survey_patch(tiling, pair);
    EXPECT_EQ(survey.inner_edges, 1U);
    EXPECT_EQ(survey.unfit_edges, 1U);
}

TEST(SubstitutionTilings, GiveTheTileOfEachAddress)
{
    for (const std::string& word : substitution_words()) {
        const PolygonTiling& tiling = built_in_tiling(word);
        const Substitution substitution(tiling, 0);
        for (const AddressedTile& tile : substitution.tiles(2, plenty))
            EXPECT_EQ(substitution.tile_at(tile.address), tile.tile) << word;
        EXPECT_THROW(substitution.tile_at({1}), InputError);
        EXPECT_THROW(substitution.tile_at({0, 1000}), InputError);
    }
}

TEST(SubstitutionTilings, HaveInWindowsWhatTheyHaveAsAWhole)
{
    const std::map<std::string, int> depths{{"kite-domino", 2}, {"shield", 4}, {"chair", 4}, {"sphinx", 4}};
    for (const std::string& word : substitution_words()) {
        const PolygonTiling& tiling = built_in_tiling(word);
        const int depth = depths.contains(word) ? depths.at(word) : 6;
        const Substitution substitution(tiling, 0);
        const auto all = substitution.tiles(depth, plenty);
        for (const std::size_t chosen : {std::size_t{0}, all.size() / 3, all.size() - 1}) {
            const RingPlace middle = all[chosen].tile.motion.at;
            constexpr double radius = 3;
            const auto near = substitution.tiles_near(depth, middle, radius, plenty);
            std::set<TileAddress> found;
            for (const AddressedTile& tile : near) found.insert(tile.address);
            const double scale = scale_of(tiling.ring, all[0].tile.motion);
            for (const AddressedTile& tile : all) {
                const auto corners = corners_of(tiling, tile.tile);
                const bool is_inside = std::ranges::any_of(corners, [&](const RingPlace& corner) {
                    return tiling.ring.sizes(corner - middle)[0] < radius * scale;
                });
                EXPECT_TRUE(!is_inside || found.contains(tile.address)) << word;
            }
        }
    }
}

TEST(SubstitutionTilings, AreExactAtTheirGreatestDepths)
{
    std::mt19937 random(7);
    const std::map<std::string, int> deepest{{"penrose-kite-dart", 80},
                                             {"penrose-rhombs", 80},
                                             {"robinson-triangles", 80},
                                             {"kite-domino", 10},
                                             {"shield", 55},
                                             {"chair", 55},
                                             {"sphinx", 55}};
    for (const std::string& word : substitution_words()) {
        const PolygonTiling& tiling = built_in_tiling(word);
        const Substitution substitution(tiling, 0);
        const int depth = substitution.deepest();
        EXPECT_GE(depth, deepest.at(word)) << word;
        // Somewhere inside, tiles fill a window around a tile, as they do near the origin.
        TileAddress address{0};
        PlacedTile tile = tiling.starts[0].tiles[0];
        for (int level = 1; level <= depth; ++level) {
            const auto parts = static_cast<std::uint32_t>(tiling.parts[tile.prototile].size());
            address.push_back(static_cast<std::uint32_t>(random()) % parts);
            tile = substitution.tile_at(address);
        }
        const double reach = 6 * std::sqrt(area_of(tiling, 0));
        const auto tiles = tiles_of(substitution.tiles_near(depth, tile.motion.at, reach, plenty));
        const PatchSurvey survey = survey_patch(tiling, tiles);
        EXPECT_GT(survey.inner_vertices, 20U) << word;
        EXPECT_EQ(survey.crowded_edges + survey.odd_vertices + survey.unfit_edges, 0U) << word;
    }
}

/// The letters of the class notes for those of a file.
std::string letters_of_notes(std::string letters, const std::map<char, char>& names)
{
    for (char& letter : letters) letter = names.at(letter);
    return letters;
}

TEST(PenroseOutlines, HaveTheLettersOfTheNotes)
{
    // Kaplan, section 8.3: abcdaefghd and ghefgcdabf, where (a, d), (b, h), (c, e), (f, g) interlock; abcdefegabhg and
    // afcdegabhg, where (a, g), (b, e), (c, d), (f, h) do.
    const std::map<char, char> kites{{'a', 'a'}, {'A', 'd'}, {'b', 'b'}, {'B', 'h'},
                                     {'c', 'c'}, {'C', 'e'}, {'f', 'f'}, {'F', 'g'}};
    const auto& p2 = built_in_tiling("penrose-kite-dart").prototiles;
    EXPECT_EQ(letters_of_notes(p2[0].outline_edges, kites), "abcdaefghd");
    EXPECT_EQ(letters_of_notes(p2[1].outline_edges, kites), "ghefgcdabf");
    const std::map<char, char> rhombs{{'a', 'a'}, {'A', 'g'}, {'b', 'b'}, {'B', 'e'},
                                      {'c', 'c'}, {'C', 'd'}, {'f', 'f'}, {'F', 'h'}};
    const auto& p3 = built_in_tiling("penrose-rhombs").prototiles;
    EXPECT_EQ(letters_of_notes(p3[0].outline_edges, rhombs), "abcdefegabhg");
    EXPECT_EQ(letters_of_notes(p3[1].outline_edges, rhombs), "afcdegabhg");
}

TEST(PenroseOutlines, FitWhateverTheShifts)
{
    using Complex = std::complex<double>;
    using Vertex = std::pair<std::int64_t, std::int64_t>;
    const std::array<Complex, 2> shifts{std::polar(0.23, 0.7), std::polar(0.19, -1.1)};
    for (const std::string word : {"penrose-kite-dart", "penrose-rhombs"}) {
        const PolygonTiling& tiling = built_in_tiling(word);
        const auto value = [&](const RingPlace& place) {
            const auto v = tiling.ring.value(place);
            return Complex(v[0], v[1]);
        };
        std::map<std::pair<Vertex, Vertex>, char> edges;
        std::map<std::pair<Vertex, Vertex>, double> away;
        for (const PlacedTile& tile : patch_of(word, 6, 2)) {
            const Prototile& prototile = tiling.prototiles[tile.prototile];
            std::vector<Vertex> vertices;
            for (const ShiftedPlace& vertex : prototile.outline) {
                Complex place = value(vertex.place);
                for (std::size_t i = 0; i < 2; ++i) place += value(vertex.shifts[i]) * shifts[i];
                place = value(tile.motion.at) + value(tile.motion.turn) * place;
                vertices.emplace_back(std::llround(place.real() * 1e6), std::llround(place.imag() * 1e6));
            }
            for (std::size_t i = 0; i < vertices.size(); ++i) {
                const std::pair edge{vertices[i], vertices[(i + 1) % vertices.size()]};
                EXPECT_TRUE(edges.emplace(edge, prototile.outline_edges[i]).second) << "two tiles on one side";
                away[edge] = std::abs(value(tile.motion.at));
            }
        }
        std::size_t inside = 0;
        for (const auto& [edge, letter] : edges) {
            const auto other = edges.find({edge.second, edge.first});
            EXPECT_TRUE(away[edge] > 6 || other != edges.end()) << word << ": a gap";
            if (other == edges.end()) continue;
            ++inside;
            EXPECT_TRUE(letters_fit(letter, other->second)) << word;
        }
        EXPECT_GT(inside, 2000U) << word;
    }
}

TEST(ArchimedeanTilings, HaveOneClassOfCornersAndTheSymmetriesOfTheirGroups)
{
    // Gruenbaum and Shephard, Tilings and Patterns, 1987, section 2.1 and table 2.2.1: the orders of the groups p6m,
    // p4m, p6, cmm, p4g up to translations of the primitive lattice, and the classes of tiles.
    struct Row
    {
        std::string word;
        std::size_t symmetries, tile_classes;
        bool has_mirrors;
    };
    for (const Row& row : {Row{"3.3.3.3.3.3", 12, 1, true}, Row{"4.4.4.4", 8, 1, true}, Row{"6.6.6", 12, 1, true},
                           Row{"3.3.3.3.6", 6, 3, false}, Row{"3.3.3.4.4", 4, 2, true}, Row{"3.3.4.3.4", 8, 2, true},
                           Row{"3.4.6.4", 12, 3, true}, Row{"3.6.3.6", 12, 2, true}, Row{"3.12.12", 12, 2, true},
                           Row{"4.6.12", 12, 3, true}, Row{"4.8.8", 8, 2, true}}) {
        const PolygonTiling& tiling = built_in_tiling(row.word);
        const TransitivityClasses classes = transitivity_classes(tiling);
        EXPECT_EQ(classes.vertex_classes, 1U) << row.word;
        EXPECT_EQ(classes.symmetries, row.symmetries) << row.word;
        EXPECT_EQ(classes.tile_classes, row.tile_classes) << row.word;
        EXPECT_EQ(classes.has_mirrors, row.has_mirrors) << row.word;
        std::vector<PlacedTile> tiles;
        for (const RepeatedTile& tile : repeated_tiles(tiling, 8, 8)) tiles.push_back(tile.tile);
        const PatchSurvey survey = survey_patch(tiling, tiles);
        ASSERT_EQ(survey.figures.size(), 1U) << row.word;
        EXPECT_EQ(survey.figures[0].tiles, row.word);
        EXPECT_EQ(survey.crowded_edges + survey.odd_vertices, 0U) << row.word;
        EXPECT_TRUE(survey.is_edge_to_edge) << row.word;
        EXPECT_TRUE(unit_fills_period(tiling)) << row.word;
    }
}

TEST(PeriodicTilings, HaveAsManyClassesAsTheyShould)
{
    EXPECT_EQ(transitivity_classes(built_in_tiling("cheese-sandwich")).tiles, (std::vector<std::size_t>{0, 1, 1}));
    EXPECT_EQ(transitivity_classes(built_in_tiling("trihedral")).tile_classes, 5U);
    EXPECT_TRUE(unit_fills_period(built_in_tiling("trihedral")));
}

TEST(RepeatedTiles, CoverTheirWindow)
{
    for (const std::string& word : periodic_words()) {
        const PolygonTiling& tiling = built_in_tiling(word);
        const auto tiles = repeated_tiles(tiling, 5, 3);
        // Whoever is inside of no tile would lie on a gap: places on a grid that no edge passes through.
        for (double x = -4.93; x < 5; x += 0.71)
            for (double y = -2.97; y < 3; y += 0.67) {
                int around = 0;
                for (const RepeatedTile& tile : tiles) {
                    const auto corners = corners_of(tiling, tile.tile);
                    bool is_inside = false;
                    for (std::size_t i = 0; i < corners.size(); ++i) {
                        const auto a = tiling.ring.value(corners[i]),
                                   b = tiling.ring.value(corners[(i + 1) % corners.size()]);
                        if ((a[1] > y) != (b[1] > y) && x < a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]))
                            is_inside = !is_inside;
                    }
                    around += is_inside;
                }
                EXPECT_EQ(around, 1) << word << " at " << x << ", " << y;
            }
    }
}

class TilingFiles : public testing::Test
{
protected:
    PolygonTiling read(const std::string& text) const
    {
        folder_.write("t.toml", text);
        return read_polygon_tiling(folder_.path() / "t.toml");
    }

    /// The message without the folder.
    std::string refusal(const std::string& text) const
    {
        const std::string message = refusal_of([&] { read(text); });
        const std::string before = (folder_.path() / "t.toml").string();
        return message.starts_with(before) ? message.substr(before.size()) : message;
    }

    TemporaryFolder folder_;
};

TEST_F(TilingFiles, OfTheDocumentationAreTilings)
{
    std::ifstream page(source_folder() + "/docs/polygon-tilings.md");
    std::string text;
    bool is_inside = false;
    for (std::string line; std::getline(page, line);) {
        if (line == "    title = \"Half hexagon\"") is_inside = true;
        if (is_inside && !line.empty() && !line.starts_with("    ")) break;
        if (is_inside) text += line + "\n";
    }
    const PolygonTiling tiling = read(text);
    ASSERT_EQ(tiling.parts.size(), 1U);
    std::vector<PlacedTile> tiles = tiles_of(Substitution(tiling, 0).tiles(4, plenty));
    ASSERT_EQ(tiles.size(), 256U);
    const PatchSurvey survey = survey_patch(tiling, tiles);
    EXPECT_EQ(survey.crowded_edges + survey.odd_vertices, 0U);
    // The sides of the whole are 80, of tiles 1 and 2.
    EXPECT_GE(survey.border_edges, 40U);
    EXPECT_LE(survey.border_edges, 80U);
}

TEST_F(TilingFiles, SayWhatIsWrongInThem)
{
    const std::string square = "[[tile]]\nname = \"s\"\ncorners = [\"0\", \"1\", \"1 + i\", \"i\"]\n";
    const std::string whole = "magnification = \"2\"\n" + square;
    EXPECT_EQ(refusal(""), ": 0 tables [[tile]]: must be 1 to 64");
    EXPECT_EQ(refusal(square), ": no period: magnification is missing");
    EXPECT_EQ(refusal(whole), ":2: [[tile]]: parts is missing");
    EXPECT_EQ(refusal("directions = 9\n" + square), ":1: directions = 9: must be 8, 10 or 12");
    EXPECT_EQ(refusal("magnification = \"2 + i\"\n" + square + "parts = [\"s\"]"),
              ":1: magnification = \"2 + i\": must be a real number times a unit vector, or 1 plus one");
    EXPECT_EQ(refusal(whole + "parts = [\"t\"]"),
              ":5: parts = \"t\": must be a tile and its place, such as \"kite at 1 + @60 turn @120 mirrored\"; no "
              "tile is called \"t\"");
    EXPECT_EQ(refusal(whole + "parts = [\"s at 1 + @50\"]"),
              ":5: parts = \"s at 1 + @50\": @50: degrees must be multiples of 30 here");
    EXPECT_EQ(refusal(whole + "parts = [\"s\", \"s turn 2\"]"),
              ":5: parts = \"s turn 2\": must turn by a number of the absolute value that the others have");
    EXPECT_EQ(refusal("magnification = \"1\"\n" + square + "parts = [\"s\"]"),
              ":1: magnification = \"1\": must be larger than the turns of the parts");
    EXPECT_EQ(refusal("period = [\"1\", \"2 i\"]\nunit = [\"s\"]\n" + square),
              ":2: unit = [\"s\"]: must have the area of a period");
    EXPECT_EQ(refusal("period = [\"i\", \"1\"]\nunit = [\"s\"]\n" + square),
              ":1: period = [\"i\", \"1\"]: must be two vectors, the second to the left of the first");
    EXPECT_EQ(refusal("[[tile]]\nname = \"s\"\ncorners = [\"0\", \"i\", \"1\"]"),
              ":3: corners = [\"0\", \"i\", \"1\"]: must go around the tile counterclockwise");
    EXPECT_EQ(refusal("[[tile]]\nname = \"s\"\nsides = 5"), ":3: sides = 5: must be a divisor of 12, the directions");
    EXPECT_EQ(refusal(square + "edges = \"abc\""),
              ":4: edges = \"abc\": must be 4 letters or digits, one for each edge");
    EXPECT_EQ(refusal(square + "colour = \"#ffffff\"").substr(0, 60),
              std::string(":4: colour = \"#ffffff\": unknown key; did you mean \"color\"? known").substr(0, 60));
}

}
}
