// results.json as it is written, read again: nothing is lost on the way.
#include "results/run.hpp"

#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

namespace poissonlab {
namespace {

/// A run with every member set, so that none can be forgotten; each number is another one.
class MadeUpResults : public testing::Test
{
protected:
    poissonlab::Run made_up() const
    {
        poissonlab::Run run;
        run.folder = folder_.path();
        run.title = "A \"title\"";
        run.version = "1.2.3 (abc)";
        run.command = "poissonlab run c.toml";
        run.config = "title = 1\n";
        run.overrides = {"seed=2", "points=3"};
        run.seed = "18446744073709551615";
        run.engine = "opencl";
        run.dimension = 3;
        run.realizations = 7;
        run.machine = {"device", "platform", "driver", "version", 3, 4, 5};
        run.methods = {{"random", "label", {}}, {"tiles", "", {{"colors", "C", {"2", "3"}}, {"x", "X", {"a", "b"}}}}};
        run.series = {estimate(), single()};
        run.tilings = {tiling(), tile_set()};
        run.constructions = {construction()};
        run.distributions = {distribution()};
        run.schemes = {scheme()};
        return run;
    }

    /// A file that results.json names.
    std::string file(const std::string& name) const
    {
        folder_.write(name, "");
        return name;
    }

    Series estimate() const
    {
        Series series;
        series.name = "s";
        series.label = "L";
        series.sampler = "corner-tiles";
        series.parameters_json = R"({"a":0.7,"b":"text","c":{"sampler":"random"}})";
        series.parameters = {{"a", "0.7"}, {"b", "text"}, {"c", "random"}};
        series.place = GridPlace{1, {1, 0}};
        series.set_sizes({63, 66});
        series.min_distance = statistic_of({0.1, 0.30000000000000004});
        series.relative_radius = statistic_of({0.6, 0.7});
        series.covered_fraction = statistic_of({0.4, 0.5});
        series.measures = measures();
        series.is_estimate = true;
        series.spectrum_size = 64;
        series.spectrum_file = file("spectrum.exr");
        series.volume_file = file("spectrum-volume.exr");
        series.radial_file = file("radial.csv");
        series.background_anisotropy_db = -3.01;
        series.pair_correlation_file = file("pair-correlation.csv");
        series.folded_density = FoldedDensityFile{42, file("folded-density.exr")};
        series.region = RegionResult{"park.geojson",
                                     320.5,
                                     17.9,
                                     71.7,
                                     2,
                                     12,
                                     true,
                                     true,
                                     39,
                                     9,
                                     1e-4,
                                     {"two polygons were united"},
                                     file("region.csv"),
                                     file("region.json")};
        series.iterations =
            Iterations{file("iterations.csv"), {2, 1}, {{1, 2}, {3, 4}, {5, 6}}, {{7, 8}, {9, 1}, {2, 3}}, {}};
        series.zone_plate = ZonePlateResult{8, file("zone-plate.exr"), file("zone-plate.csv"),
                                            *statistic_of({0.25, 0.75}), statistic_of({0.125, 0.5})};
        series.point_files = {file("realization-000.dat"), file("realization-001.dat")};
        series.tile_set = TileSetRecord{
            256, 64, true, TileSetBuild{0.25, "d", 2}, {{"corners", 3, 3.25}, {"faces", 6, 5.5}, {"interior", 55, 56}}};
        series.sample_seconds = {1.5, 2.5};
        series.is_window = true;
        series.device_bytes = 4096;
        series.build_seconds = 0.5;
        series.preparation_seconds = 0.75;
        series.analysis_seconds = 3;
        return series;
    }

    static Measures measures()
    {
        Measures all;
        all.numbers["effective_nyquist"] = {0.5, 0.01};
        all.oscillation = Oscillation{3, 20, 40, 0.125};
        all.peak_anisotropy = PeakAnisotropy{-6, 33, 200, 0.25, 0.5};
        all.low_frequency_power = LowFrequencyPower{0.5, 0.1, 0.06, 0.01, 3, 30};
        all.lattice_peaks = LatticePeaks{8, 12.5, 3.5, {8, -16, 1}, 99, 0.5};
        all.integration = {{"disk", 0.25, 0.01, 0.001, 0.5}, {"step", 0.5, 0.02, 0.002, 0.75}};
        all.largest_empty = LargestEmptyBall{0.01, 0.8};
        all.voronoi = VoronoiStatistics{0.02, {0.01, 0.25, 0.5, 0.2, 0.04}};
        return all;
    }

    /// A series that has as little as possible.
    Series single() const
    {
        Series series;
        series.name = "one";
        series.label = "One point";
        series.sampler = "files";
        series.deterministic = true;
        series.set_sizes({1});
        series.point_files = {file("realization-002.dat")};
        return series;
    }

    TilingResult tiling() const
    {
        TilingResult result;
        result.name = "t";
        result.label = "T";
        result.kind = TileKind::cube;
        result.colors = 3;
        result.tiles = 6561;
        result.file = file("tiles.txt");
        result.regions = 0.12;
        result.algorithm = "direct";
        result.origin = {-1, 2, 3};
        result.size = {4, 5, 6};
        result.hash = "xxh64";
        result.hash_period = {0, 256};
        result.period = {0, 4, 5};
        result.statistics = TilingStatistics{1024, 262144, FrequencyTest{70.5, 0.5}, {}};
        ColorStatistics colors{"corners", {1, 2, 3}, {1.5, 0.25}, file("a.exr"), {}};
        colors.autocorrelation = {320, {}, 0.5, 4.5, {3, -4}, 0.75, 5.25};
        result.statistics->colors = {colors};
        return result;
    }

    TilingResult tile_set() const
    {
        TilingResult result;
        result.name = "set";
        result.label = "S";
        result.kind = TileKind::wang;
        result.tiles = 3;
        result.file = file("set.txt");
        result.set = "compact";
        return result;
    }

    DistributionResult distribution() const
    {
        return {"d",
                "Warped",
                "warp",
                {"12 points"},
                {{"kind", "corner"}},
                {{"error", "Error", 0.25, "of counts"}, {"seams", "Seams", 1.25, "natural steps", 0.125}},
                {{file("picture.json"), "All of it."}, {file("ground.png"), ""}},
                {file("numbers.csv")}};
    }

    DistributionResult scheme() const
    {
        return {"h", "Tables", "aperiodic-tables",
                {},  {},       {},
                {},  {},       {{"Table", {"a", "b"}, {{"1", "2"}, {"", "the same"}}}}};
    }

    ConstructionResult construction() const
    {
        return {"c",
                "C",
                "edge",
                "tile",
                2,
                4096,
                32,
                0.7,
                "dart-throwing",
                3,
                true,
                "5",
                file("construction.json"),
                {4, {1, 2, 3, 0}}};
    }

    TemporaryFolder folder_;
};

TEST_F(MadeUpResults, AreReadAsTheyWereWritten)
{
    const poissonlab::Run run = made_up();
    folder_.write("results.json", run_json(run));
    const poissonlab::Run back = read_run(folder_.path());
    EXPECT_EQ(run_json(back), run_json(run));
    EXPECT_EQ(back.series, run.series);
    EXPECT_EQ(back.tilings, run.tilings);
    EXPECT_EQ(back.constructions, run.constructions);
    EXPECT_EQ(back.distributions, run.distributions);
    EXPECT_EQ(back, run);
}

TEST_F(MadeUpResults, ScenesAreReadAsTheyWereWritten)
{
    for (const int dimension : {2, 3}) {
        const std::int32_t z = dimension == 3 ? 7 : 0;
        ScenePanel panel;
        panel.caption = "First.";
        panel.modified = false;
        panel.window = {{-5, -6, -z}, {10, 11, z}};
        panel.part = {{-1, -2, -z}, {3, 4, z}};
        panel.pieces = {{1, {0, -1, z}, {0, 1}, true}};
        panel.tiles = {{0, 0, 0}, {1, 0, z}};
        panel.of(PointClass::held) = {{1, 2, z}, {3, 4, z}};
        panel.of(PointClass::surroundings) = {{5, 6, z}};
        const Scene scene{dimension, 4365, 4364.6, true, 2, {panel, panel}};
        folder_.write("construction.json", scene_json(scene));
        EXPECT_EQ(read_scene(folder_.path() / "construction.json"), scene);
    }
}

}
}
