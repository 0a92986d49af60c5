// `poissonlab distribute classes`, `mri-mask` and `dither-mask`: their files and what they print.
#include "app/commands/class_series.hpp"
#include "base/files/whole_file.hpp"
#include "experiment/series/imported_points.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/program.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace poissonlab {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(DistributeClasses, WritesPointsWithClassesAndSpectra)
{
    const TemporaryFolder folder;
    const Outcome outcome =
        run_program(folder.path(), {"distribute", "classes", "--engine", "reference", "--points", "20", "80", "--out",
                                    "a.csv", "--out", "a.svg", "--out", "a.geojson", "--spectra", "s.csv", "--json"});
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    const std::string points = read_whole_file(folder.path() / "a.csv");
    EXPECT_THAT(points, StartsWith("x,y,class\n"));
    EXPECT_EQ(std::ranges::count(points, '\n'), 101);
    EXPECT_THAT(read_whole_file(folder.path() / "s.csv"), StartsWith("frequency,all,class_0,class_1,cross_0_1\n1,"));
    EXPECT_THAT(read_whole_file(folder.path() / "a.svg"), HasSubstr("<svg"));
    EXPECT_THAT(outcome.out, HasSubstr("\"least_0_1\": "));
    // A feature for each line of the table.
    const auto json = nlohmann::json::parse(read_whole_file(folder.path() / "a.geojson"));
    EXPECT_EQ(json.at("type"), "FeatureCollection");
    ASSERT_EQ(json.at("features").size(), 100U);
    std::string table = "x,y,class\n";
    for (const auto& feature : json.at("features")) {
        EXPECT_EQ(feature.at("type"), "Feature");
        EXPECT_EQ(feature.at("geometry").at("type"), "Point");
        const auto& at = feature.at("geometry").at("coordinates");
        table += fmt::format("{:.17g},{:.17g},{}\n", at.at(0).get<double>(), at.at(1).get<double>(),
                             feature.at("properties").at("class").get<int>());
    }
    EXPECT_EQ(table, points);
}

/// Tables, PLY and GeoJSON of a set give the same numbers. It is measured on the torus, and in the square as a region.
TEST(AnalyzeClasses, MeasuresEachClassAllPointsAndPairs)
{
    const TemporaryFolder folder;
    const Outcome made = run_program(folder.path(), {"distribute", "classes", "--engine", "reference", "--points", "20",
                                                     "80", "--distances", "0.1", "0.05", "--out", "a.csv", "--out",
                                                     "a.ply", "--out", "a.geojson"});
    ASSERT_EQ(made.status, 0) << made.error;
    for (const bool is_torus : {true, false}) {
        nlohmann::json first;
        std::vector<std::string> files{"a.csv"};
        if (is_torus) files.insert(files.end(), {"a.ply", "a.geojson"});
        for (const std::string& file : files) {
            std::vector<std::string> arguments{"analyze", file, "--classes", "class", "--out", "out", "--quiet"};
            if (!is_torus) arguments.insert(arguments.end(), {"--periodic", "no"});
            const Outcome outcome = run_program(folder.path(), arguments);
            ASSERT_EQ(outcome.status, 0) << outcome.error;
            const auto json = nlohmann::json::parse(read_whole_file(folder.path() / "out/results.json"));
            ASSERT_EQ(json.at("series").size(), 3U);
            EXPECT_EQ(json.at("series").at(0).at("points"), 100);
            EXPECT_EQ(json.at("series").at(1).at("label"), "class 0");
            EXPECT_EQ(json.at("series").at(1).at("points"), 20);
            EXPECT_EQ(json.at("series").at(2).at("points"), 80);
            const auto& numbers = json.at("distributions").at(0).at("numbers");
            if (first.is_null()) first = numbers;
            EXPECT_EQ(numbers, first) << file;
            std::map<std::string, double> values;
            for (const auto& number : numbers) values[number.at("key")] = number.at("value");
            EXPECT_GE(values.at("least_0"), 0.1);
            EXPECT_GE(values.at("least_1"), 0.05);
            EXPECT_GE(values.at("least_0_1"), 1 / std::sqrt(100 + 400.0) - 1e-9);
        }
    }
}

/// Each text is another way to type the same.
TEST(AnalyzeClasses, ObeysKeysOfSetHoweverTheyAreTyped)
{
    const TemporaryFolder folder;
    write_whole_file(folder.path() / "a.csv", "x,y,kind\n0.3,0.4,oak\n0.5,0.6,oak\n0.7,0.4,ash\n0.5,0.3,ash\n");
    const auto numbers = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments{
            "analyze", "a.csv", "--classes", "kind", "--out", "out", "--quiet", "--set", "analysis.measures=distances"};
        for (const std::string& text : more) arguments.insert(arguments.end(), {"--set", text});
        const Outcome outcome = run_program(folder.path(), arguments);
        EXPECT_EQ(outcome.status, 0) << outcome.error;
        return nlohmann::json::parse(read_whole_file(folder.path() / "out/results.json"))
            .at("distributions")
            .at(0)
            .at("numbers");
    };
    const auto torus = numbers({}), window = numbers({"analysis.window=true"}),
               disk = numbers({"analysis.region=disk 0.5 0.5 0.4"});
    EXPECT_NE(torus, window);
    EXPECT_NE(disk, window);
    EXPECT_EQ(numbers({" analysis.window = true"}), window);
    EXPECT_EQ(numbers({"analysis.region = \"disk 0.5 0.5 0.4\"", "analysis.envelope=0"}), disk);
}

/// Folders are called by the class alone, so that those of sets with other classes besides are found again.
TEST(AnalyzeClasses, NamesSeriesByTheirClass)
{
    const TemporaryFolder folder;
    const auto series = [&](const std::string& file, const std::vector<std::string>& classes) {
        std::string table = "x,y,kind\n";
        for (std::size_t i = 0; i < 2 * classes.size(); ++i)
            table += fmt::format("{},{},{}\n", (static_cast<double>(i) + 0.5) / 20, 0.3 * static_cast<double>(i % 3),
                                 classes[i / 2]);
        write_whole_file(folder.path() / file, table);
        const Outcome outcome =
            run_program(folder.path(), {"analyze", file, "--classes", "kind", "--out", "out", "--quiet"});
        EXPECT_EQ(outcome.status, 0) << outcome.error;
        std::vector<std::string> names;
        const auto json = nlohmann::json::parse(read_whole_file(folder.path() / "out/results.json"));
        for (const auto& each : json.at("series")) {
            names.push_back(each.at("name"));
            names.push_back(each.at("label"));
            EXPECT_TRUE(exists(folder.path() / "out" / names[names.size() - 2]));
        }
        return names;
    };
    EXPECT_THAT(series("oak.csv", {"1", "oak"}),
                testing::ElementsAre("oak", "oak", "class-1", "class 1", "class-oak", "class oak"));
    const std::string first(300, 'a'), second = first + "b", folder_name = "class-" + std::string(94, 'a');
    EXPECT_THAT(series("class a.csv", {"a", first, second, "é", "ê"}),
                testing::ElementsAre("class-a", "class a", "class-a-alone", "class a alone", folder_name,
                                     "class " + first, folder_name + "-2", "class " + second, "class", "class é",
                                     "class-2", "class ê"));
}

TEST(AnalyzeClasses, RefuseAFileThatChangesWhileItIsRead)
{
    const TemporaryFolder folder;
    const auto file = folder.write("a.csv", "x,y,kind\n0.1,0.2,oak\n0.5,0.5,oak\n0.7,0.7,ash\n");
    Experiment experiment = import_points({file}, "");
    folder.write("a.csv", "x,y,kind\n0.1,0.2,oak\n0.5,0.5,ash\n");
    EXPECT_EQ(message_of([&] {
                  add_class_series(experiment, fmt::format("set = \"{}\"\nclasses = \"kind\"\n", file.string()));
              }),
              file.string() + ": changed while it was read, from 3 points to 2");
}

TEST(DistributeMasks, WriteFilesOfOtherPrograms)
{
    const TemporaryFolder folder;
    const Outcome samples = run_program(folder.path(), {"distribute", "mri-mask", "--shape", "64", "48",
                                                        "--acceleration", "4", "--out", "a.cfl", "--out", "a.png"});
    EXPECT_EQ(samples.status, 0) << samples.error;
    EXPECT_EQ(samples.out, "768 samples of 64 x 48 pixels, acceleration 4; 0 of them in the calibration area\n");
    EXPECT_THAT(read_whole_file(folder.path() / "a.hdr"), StartsWith("# Dimensions\n1 64 48 1 "));
    EXPECT_EQ(read_whole_file(folder.path() / "a.cfl").size(), 64U * 48 * 8);
    EXPECT_EQ(run_program(folder.path(), {"distribute", "mri-mask", "--acceleration", "8", "--out", "c.npy"}).out,
              "8192 samples of 256 x 256 pixels, acceleration 8; 0 of them in the calibration area\n");
    const Outcome thresholds =
        run_program(folder.path(), {"distribute", "dither-mask", "--size", "32", "--by", "tiles", "--colors", "2",
                                    "--tile-pixels", "4", "--out", "b.ptiles", "--out", "b.png", "--quiet"});
    EXPECT_EQ(thresholds.status, 0) << thresholds.error;
    const PoissonTileSet tiles = read_tile_set(folder.path() / "b.ptiles");
    EXPECT_EQ(tiles.ranks.size(), 16U * 16);
}

}
}
