// Tilings by polygons that the program brings: against closed forms of their counts, published atlases of vertices and
// tables of symmetry groups, and exact areas.
#include "base/errors/errors.hpp"
#include "host/settings/tilings/polygon_tiling_file.hpp"
#include "tests/support/places.hpp"
#include "tiles/prototiles/patch_survey.hpp"
#include "tiles/prototiles/periodic_tiling.hpp"
#include "tiles/prototiles/substitution.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <filesystem>
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

/// True for the hat, the turtle and the spectre.
bool is_monotile(const std::string& word)
{
    const PolygonTiling& tiling = built_in_tiling(word);
    return !is_multiplication(tiling.ring, tiling.magnification);
}

/// Returns the address of a tile that has parts itself, since some tilings have tiles without parts.
TileAddress random_address(const Substitution& substitution, const PolygonTiling& tiling, int depth,
                           std::mt19937& random)
{
    TileAddress address{0};
    while (address.size() <= static_cast<std::size_t>(depth)) {
        const std::size_t parts = tiling.parts[substitution.tile_at(address).prototile].size();
        address.push_back(static_cast<std::uint32_t>(random() % parts));
        if (tiling.parts[substitution.tile_at(address).prototile].empty()) address.pop_back();
    }
    return address;
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

TEST(Monotiles, HaveAsManyTilesAsTheirMatricesSay)
{
    const auto lucas_number = [](int n) { return fibonacci_number(n - 1) + fibonacci_number(n + 1); };
    const auto count = [](const std::string& word, std::size_t start, int depth, const std::string& name) {
        const PolygonTiling& tiling = built_in_tiling(word);
        std::uint64_t named = 0, all = 0;
        for (const PlacedTile& tile : patch_of(word, depth, start))
            ++all, named += tiling.prototiles[tile.prototile].name == name;
        return std::pair{all, named};
    };
    // Clusters of hats grow by the matrix ((6, 1), (5, 1)), whose eigenvalues are the golden ratio phi to the powers 4
    // and -4. In the limit there are 3 phi^2 - 1 other hats for each reflected one.
    for (int n = 1; n <= 4; ++n)
        for (const std::string word : {"hat", "turtle"}) {
            EXPECT_EQ(count(word, 0, n, "reflected"),
                      (std::pair{fibonacci_number(4 * n + 2), fibonacci_number(4 * n) / 3}));
            EXPECT_EQ(count(word, 1, n, "reflected"), (std::pair{lucas_number(4 * n), lucas_number(4 * n - 2) / 3}));
        }
    // A cluster has eight spectres, one of them a Mystic; the matrix has the eigenvalues 4 + sqrt(15) and 4 - sqrt(15).
    const double root = std::sqrt(15.0);
    for (int n = 0; n <= 4; ++n) {
        const double up = std::pow(4 + root, n), down = std::pow(4 - root, n);
        const std::pair expected{
            static_cast<std::uint64_t>(std::llround(((1 + root / 3) * up + (1 - root / 3) * down) / 2)),
            static_cast<std::uint64_t>(std::llround((up - down) / (2 * root)))};
        for (const std::size_t start : {0, 1, 7}) EXPECT_EQ(count("spectre", start, n, "upper"), expected); // not gamma
    }
}

TEST(Monotiles, HaveTheAreasAndFactorsOfTheirPapers)
{
    // Tile(a, b) has the area sqrt(3) (2 a^2 + sqrt(3) a b + b^2); arXiv 2303.10798, section 6.
    constexpr double root = std::numbers::sqrt3;
    const std::map<std::string, std::array<double, 2>> sides{
        {"hat", {1, root}}, {"turtle", {root, 1}}, {"spectre", {1, 1}}};
    for (const auto& [word, lengths] : sides) {
        const auto [a, b] = lengths;
        const PolygonTiling& tiling = built_in_tiling(word);
        for (std::size_t i = 0; i < tiling.prototiles.size(); ++i)
            EXPECT_NEAR(area_of(tiling, i), root * (2 * a * a + root * a * b + b * b), 1e-14 * 20) << word;
        const double factor = word == "spectre" ? std::sqrt(4 + std::sqrt(15.0)) : std::pow(std::numbers::phi, 2);
        EXPECT_NEAR(Substitution(tiling, 0).inflation(), factor, 1e-14) << word;
    }
}

TEST(Monotiles, MakePatchesWithoutHoles)
{
    // Euler: corners - edges + tiles = 1 for a patch that is a disk, whose border edges are its only ones.
    for (const std::string word : {"hat", "turtle", "spectre"})
        for (int depth = 0; depth <= 4; ++depth) {
            const PolygonTiling& tiling = built_in_tiling(word);
            const std::vector<PlacedTile> tiles = patch_of(word, depth);
            std::set<RingPlace> corners;
            for (const PlacedTile& tile : tiles)
                for (const RingPlace& corner : corners_of(tiling, tile)) corners.insert(corner);
            const PatchSurvey survey = survey_patch(tiling, tiles);
            EXPECT_TRUE(survey.is_edge_to_edge) << word;
            EXPECT_EQ(2 * survey.inner_edges + survey.border_edges, 14 * tiles.size()) << word;
            EXPECT_EQ(corners.size() + tiles.size(), survey.inner_edges + survey.border_edges + 1) << word << depth;
        }
}

TEST(Monotiles, AreReflectedWhereTheyShouldBe)
{
    // No spectre is reflected when another is not, and those that turn by odd multiples of 30 degrees are in Mystics.
    for (int depth = 1; depth <= 4; ++depth)
        for (const PlacedTile& tile : patch_of("spectre", depth)) {
            const RingPlace& turn = tile.motion.turn;
            EXPECT_EQ(tile.motion.is_mirrored, depth % 2 == 1);
            EXPECT_EQ(turn.c[1] != 0 || turn.c[3] != 0,
                      built_in_tiling("spectre").prototiles[tile.prototile].name == "upper");
        }
    EXPECT_FALSE(mixes_mirrored_tiles(built_in_tiling("spectre")));
    EXPECT_TRUE(mixes_mirrored_tiles(built_in_tiling("hat")));
    for (const PlacedTile& tile : patch_of("hat", 4))
        EXPECT_EQ(tile.motion.is_mirrored, built_in_tiling("hat").prototiles[tile.prototile].name == "reflected");
}

TEST(Monotiles, AreUnionsOfKitesOfOneGrid)
{
    // Kites of [3.4.6.4] with edges 1 and sqrt(3) have their corners in the triangular lattice. Up to translations of
    // the kites they are one corner of degree 6, two of degree 3 and three of degree 4, and 6 of 12 points are none.
    // Each corner of a tile has one degree wherever the tile lies, and each degree's points are alike.
    for (const std::string word : {"hat", "turtle"}) {
        const PolygonTiling& tiling = built_in_tiling(word);
        const std::vector<PlacedTile> tiles = patch_of(word, 4);
        // Returns x and y of x + y w in the lattice of points at distance 1; turtles are turned by -30 degrees first.
        const auto lattice = [&](const RingPlace& p) {
            const auto& c = p.c;
            return word == "hat" ? std::pair{c[0] + c[1] - c[3], c[1] + c[2] + 2 * c[3]}
                                 : std::pair{2 * c[0] + c[1] + c[2], c[2] - c[0] + c[3]};
        };
        const auto origin = lattice(corners_of(tiling, tiles[0])[0]);
        std::map<std::pair<std::int64_t, std::int64_t>, std::set<std::size_t>> corners_in_class;
        for (const PlacedTile& tile : tiles)
            for (std::size_t i = 0; i < 14; ++i) {
                const RingPlace corner = moved(tiling.ring, tile.motion, tiling.prototiles[tile.prototile].corners[i]);
                const auto [x, y] = lattice(corner);
                const auto point = point_of(tiling, corner);
                const std::complex<double> there = std::polar(1.0, word == "hat" ? 0 : -std::numbers::pi / 6) *
                                                   std::complex<double>(point[0], point[1]);
                EXPECT_NEAR(there.real(), static_cast<double>(x) + static_cast<double>(y) / 2, 1e-9);
                EXPECT_NEAR(there.imag(), static_cast<double>(y) * std::numbers::sqrt3 / 2, 1e-9);
                const auto modulo = [](std::int64_t a, std::int64_t m) { return (a % m + m) % m; };
                // Centres of hexagons are the multiples of 2 (1 + w).
                const std::int64_t u = x - origin.first, v = y - origin.second;
                corners_in_class[{modulo(u + v, 2) * 2 + modulo(u, 2), modulo(u - v, 3)}].insert(i);
            }
        EXPECT_EQ(corners_in_class.size(), 6U) << word;
        std::map<std::set<std::size_t>, std::size_t> degrees;
        for (const auto& [place, corners] : corners_in_class) ++degrees[corners];
        std::multiset<std::size_t> classes;
        std::size_t corners_in_all = 0;
        for (const auto& [corners, count] : degrees) classes.insert(count), corners_in_all += corners.size();
        EXPECT_EQ(classes, (std::multiset<std::size_t>{1, 2, 3})) << word;
        EXPECT_EQ(corners_in_all, 14U) << word << ": no corner has two degrees";
    }
}

TEST(Monotiles, AreTheSameFarAwayAsNearTheOrigin)
{
    std::mt19937 random(11);
    for (const std::string word : {"hat", "turtle", "spectre"}) {
        const PolygonTiling& tiling = built_in_tiling(word);
        const RootRing& ring = tiling.ring;
        const Substitution far(tiling, 0);
        for (const int depth : {4, 5, 25, far.deepest()}) {
            // A cluster of three levels is compared with the one that is made from its own first tile.
            TileAddress address = random_address(far, tiling, depth - 3, random);
            const PlacedTile ancestor = far.tile_at(address);
            const Substitution near(tiling, ancestor.prototile); // the first starts are the tiles that have parts
            address.resize(static_cast<std::size_t>(depth) + 1);
            const PlacedTile first = far.tile_at(address);
            const RingPlace local_first = near.tile_at({0, 0, 0, 0}).motion.at;
            for (const AddressedTile& local : near.tiles(3, plenty)) {
                std::copy(local.address.begin() + 1, local.address.end(), address.end() - 3);
                const RingPlace away = local.tile.motion.at - local_first;
                EXPECT_EQ(far.tile_at(address).motion.at - first.motion.at,
                          ring.times(ancestor.motion.turn, ancestor.motion.is_mirrored ? ring.conjugate(away) : away));
            }
        }
    }
}

TEST(Monotiles, AreFoundFromAnyPlace)
{
    // Windows around places that are no tile's own: hundreds of millions of edges away from the origin.
    for (const std::string word : {"hat", "turtle", "spectre"}) {
        const PolygonTiling& tiling = built_in_tiling(word);
        const Substitution substitution(tiling, word == "spectre" ? 0 : 2); // those that cover the plane
        for (const std::int64_t k : {0, 1, 2, 3, 4, 5}) {
            const RingPlace direction = tiling.ring.unit(static_cast<int>(2 * k));
            const RingPlace middle = tiling.ring.times(direction, {{300'000'000 + k, 7 * k, 100'000'000, k}});
            const auto near = substitution.tiles_near(26, middle, 12, plenty);
            const PatchSurvey survey = survey_patch(tiling, tiles_of(near));
            EXPECT_EQ(survey.crowded_edges + survey.odd_vertices + survey.unfit_edges, 0U);
            EXPECT_LT(near.size(), 400U);
            for (const AddressedTile& tile : near) EXPECT_EQ(substitution.tile_at(tile.address), tile.tile);
            EXPECT_GT(survey.inner_vertices, 100U) << word << ", direction " << k;
            const auto around = substitution.tile_around(26, middle);
            ASSERT_TRUE(around) << word << ", direction " << k;
            EXPECT_EQ(substitution.tile_at(around->address), around->tile);
        }
    }
}

TEST(SubstitutionTilings, HavePartsOfTheAreaOfTheWholeExactly)
{
    for (const std::string& word : substitution_words()) {
        if (word == "shield" || is_monotile(word)) continue; // what stands out of one tile is cut out of another
        const PolygonTiling& tiling = built_in_tiling(word);
        const RootRing& ring = tiling.ring;
        for (std::size_t i = 0; i < tiling.parts.size(); ++i) {
            RingPlace parts;
            for (const PlacedTile& part : tiling.parts[i])
                parts = parts + quadruple_area(ring, corners_of(tiling, part));
            const RingPlace whole =
                quadruple_area(ring, corners_of(tiling, {i, {{}, tiling.magnification.of_one, false}}));
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
                                            {"sphinx", 5},
                                            {"hat", 4},
                                            {"turtle", 4},
                                            {"spectre", 4}};
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
    const std::map<std::string, int> depths{{"kite-domino", 2}, {"shield", 4}, {"chair", 4},  {"sphinx", 4},
                                            {"hat", 4},         {"turtle", 4}, {"spectre", 3}};
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
                    const auto away = point_of(tiling, corner - middle);
                    return std::hypot(away[0], away[1]) < radius * scale;
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
                                             {"sphinx", 55},
                                             {"hat", 40},
                                             {"turtle", 40},
                                             {"spectre", 37}};
    for (const std::string& word : substitution_words()) {
        const PolygonTiling& tiling = built_in_tiling(word);
        const Substitution substitution(tiling, 0);
        const int depth = substitution.deepest();
        EXPECT_GE(depth, deepest.at(word)) << word;
        // Somewhere inside, tiles fill a window around a tile, as they do near the origin.
        const PlacedTile tile = substitution.tile_at(random_address(substitution, tiling, depth, random));
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

}
}
