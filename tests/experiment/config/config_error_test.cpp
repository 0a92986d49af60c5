// One test for each kind of mistake in a config, on the whole message.
#include "experiment/config/config.hpp"
#include "experiment/config/plan.hpp"
#include "host/settings/sampler_registry.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

std::string error_of(const std::string& text)
{
    return message_of([&] { make_plan(parse_config(text, "c.toml")); });
}

const std::string good_method = "[[method]]\nsampler = \"random\"\n";

std::string all_samplers()
{
    std::vector<std::string> names;
    for (const SamplerSpec& spec : sampler_registry()) names.push_back(spec.name);
    return fmt::format("one of \"{}\"", fmt::join(names, "\", \""));
}

TEST(ConfigError, UnknownTopLevelKey)
{
    EXPECT_EQ(error_of("title = \"x\"\nsede = 1\n" + good_method),
              "c.toml:2: sede = 1: unknown key; did you mean \"seed\"? "
              "known keys: title, seed, engine, device, analysis, method, tile_set, tiling, construction, "
              "distribution, scheme, texture, packing, include");
}

TEST(ConfigError, UnknownKeyThatIsLikeNoOther)
{
    EXPECT_EQ(error_of("wavelength = \"long\"\n" + good_method),
              "c.toml:1: wavelength = \"long\": unknown key; "
              "known keys: title, seed, engine, device, analysis, method, tile_set, tiling, construction, "
              "distribution, scheme, texture, packing, include");
}

TEST(ConfigError, UnknownTable)
{
    EXPECT_EQ(error_of(good_method + "[analisys]\npoints = 3\n"),
              "c.toml:3: analisys = {...}: unknown key; did you mean \"analysis\"? "
              "known keys: title, seed, engine, device, analysis, method, tile_set, tiling, construction, "
              "distribution, scheme, texture, packing, include");
}

TEST(ConfigError, UnknownAnalysisKey)
{
    EXPECT_EQ(error_of("[analysis]\npoint = 16384\n" + good_method),
              "c.toml:2: point = 16384: unknown key; did you mean \"points\"? "
              "known keys: points, realizations, dimension, timing_runs, spectrum, spectrum_size, bin_width, "
              "keep_spectrum, volume, "
              "zone_plate, tiles, window, box, "
              "measures, point_files, region, planar, crs, overlap, buffer, density, density_from, envelope, tapers");
}

TEST(ConfigError, UnknownMethodKey)
{
    EXPECT_EQ(error_of("[[method]]\nsampler = \"dart-throwing\"\nrelative_radus = [0.70, 0.75]\n"),
              "c.toml:3: relative_radus = [0.70, 0.75]: unknown key; did you mean \"relative_radius\"? "
              "known keys: sampler, label, points, order, region, planar, crs, overlap, buffer, relative_radius, stop, "
              "min_distance");
}

TEST(ConfigError, ParameterOfAnotherSampler)
{
    EXPECT_EQ(error_of("[[method]]\nsampler = \"random\"\nrelative_radius = 0.7\n"),
              "c.toml:3: relative_radius = 0.7: unknown key; known keys: sampler, label, points, order, "
              "region, planar, crs, overlap, buffer");
}

TEST(ConfigError, TheFirstOfSeveralMistakesIsReported)
{
    EXPECT_EQ(error_of("zzzzzzzzzz = 1\naaaaaaaaaa = 2\n" + good_method).substr(0, 12), "c.toml:1: zz");
}

TEST(ConfigError, NotText)
{
    EXPECT_EQ(error_of("title = 3\n" + good_method), "c.toml:1: title = 3: must be a line of text in quotes");
    EXPECT_EQ(error_of("title = \"\"\n" + good_method), "c.toml:1: title = \"\": must be a line of text in quotes");
    EXPECT_EQ(error_of("[[method]]\nsampler = \"random\"\nlabel = [\"a\", \"b\"]\n"),
              "c.toml:3: label = [\"a\", \"b\"]: must be a line of text in quotes");
}

TEST(ConfigError, Seed)
{
    EXPECT_EQ(error_of("seed = -1\n" + good_method), "c.toml:1: seed = -1: must be an integer of at least 0");
    EXPECT_EQ(error_of("seed = 1.0\n" + good_method), "c.toml:1: seed = 1.0: must be an integer of at least 0");
    EXPECT_EQ(error_of("seed = 9223372036854775808\n" + good_method).substr(0, 10), "c.toml:1: ");
}

TEST(ConfigError, Engine)
{
    EXPECT_EQ(error_of("engine = \"refrence\"\n" + good_method),
              "c.toml:1: engine = \"refrence\": must be one of \"opencl\", \"reference\"; did you mean \"reference\"?");
    EXPECT_EQ(error_of("engine = true\n" + good_method),
              "c.toml:1: engine = true: must be one of \"opencl\", \"reference\"");
}

TEST(ConfigError, PointsAndRealizations)
{
    const auto analysis = [](const std::string& line) { return error_of("[analysis]\n" + line + "\n" + good_method); };
    EXPECT_EQ(analysis("points = 0"), "c.toml:2: points = 0: must be an integer from 1 to 134217728");
    EXPECT_EQ(analysis("points = 134217729"), "c.toml:2: points = 134217729: must be an integer from 1 to 134217728");
    EXPECT_EQ(analysis("points = \"many\""), "c.toml:2: points = \"many\": must be an integer from 1 to 134217728");
    EXPECT_EQ(analysis("points = 1e4"), "c.toml:2: points = 1e4: must be an integer from 1 to 134217728");
    EXPECT_EQ(analysis("points = [1, 2]"), "c.toml:2: points = [1, 2]: must be an integer from 1 to 134217728");
    EXPECT_EQ(analysis("points = 1979-05-27"), "c.toml:2: points = 1979-05-27: must be an integer from 1 to 134217728");
    EXPECT_EQ(analysis("realizations = 10001"), "c.toml:2: realizations = 10001: must be an integer from 1 to 10000");
}

TEST(ConfigError, PointsOfAMethod)
{
    const auto points = [](const std::string& value) { return error_of(good_method + "points = " + value + "\n"); };
    const std::string allowed = "must be an integer from 1 to 134217728";
    EXPECT_EQ(points("0"), "c.toml:3: points = 0: " + allowed);
    EXPECT_EQ(points("[256, 1e4]"), "c.toml:3: points = 1e4: " + allowed);
    EXPECT_EQ(points("[]"), "c.toml:3: points = []: the list is empty; each item must be "
                            "an integer from 1 to 134217728");
    EXPECT_EQ(points("[256, 256]"), "c.toml:1: [[method]]: the series \"Random, N = 256\" is there twice");
    EXPECT_EQ(error_of(good_method + good_method + "points = 16384\n"),
              "c.toml:3: [[method]]: the series \"Random\" is there twice")
        << "as many points as analysis.points says";
}

TEST(ConfigError, FilesHaveTheirOwnPoints)
{
    const TemporaryFolder folder;
    folder.write("a.dat", "0.1 0.2\n");
    const std::string file = folder.write("c.toml", "[[method]]\nsampler = \"file\"\npath = \"a.dat\"\npoints = 1\n");
    EXPECT_EQ(message_of([&] { make_plan(read_config(file)); }),
              file + ":4: points = 1: cannot be combined with the sampler \"file\", whose sets have their own "
                     "number of points; leave it out");
}

TEST(ConfigError, Dimension)
{
    EXPECT_EQ(error_of("[analysis]\ndimension = 4\n" + good_method), "c.toml:2: dimension = 4: must be 2 or 3");
    EXPECT_EQ(error_of("[analysis]\nspectrum = \"exakt\"\n" + good_method),
              "c.toml:2: spectrum = \"exakt\": must be one of \"fast\", \"exact\", \"none\"; did you mean \"exact\"?");
    EXPECT_EQ(error_of("[analysis]\ndimension = 2.0\n" + good_method), "c.toml:2: dimension = 2.0: must be 2 or 3");
}

TEST(ConfigError, ZonePlate)
{
    EXPECT_EQ(error_of("[analysis]\nzone_plate = 1\n" + good_method),
              "c.toml:2: zone_plate = 1: must be true or false");
    EXPECT_EQ(error_of("[analysis]\nzone_plate = true\ndimension = 3\n" + good_method),
              "c.toml:2: zone_plate = true: needs dimension = 2: the zone plate is a function of the plane");
    EXPECT_FALSE(
        parse_config("[analysis]\nzone_plate = false\ndimension = 3\n" + good_method, "c.toml").analysis.zone_plate);
}

TEST(ConfigError, AnalysisIsNoTable)
{
    EXPECT_EQ(error_of("analysis = 3\n" + good_method), "c.toml:1: analysis = 3: must be a table, written [analysis]");
}

TEST(ConfigError, NoMethod)
{
    EXPECT_EQ(error_of("seed = 1\n"), "c.toml: no [[method]] table: a config needs at least one");
    EXPECT_EQ(error_of(""), "c.toml: no [[method]] table: a config needs at least one");
    EXPECT_EQ(error_of("method = []\n"), "c.toml:1: method = []: must have at least one [[method]] table");
}

TEST(ConfigError, MethodOfAnotherKind)
{
    EXPECT_EQ(error_of("[method]\nsampler = \"random\"\n"),
              "c.toml:1: method = {...}: must be a list of tables, each written [[method]]");
    EXPECT_EQ(error_of("method = [\"random\"]\n"),
              "c.toml:1: method = \"random\": must be a table, written [[method]]");
}

TEST(ConfigError, Sampler)
{
    EXPECT_EQ(error_of("seed = 1\n[[method]]\nlabel = \"x\"\n"),
              "c.toml:2: [[method]]: sampler is missing; it must be " + all_samplers());
    EXPECT_EQ(error_of("[[method]]\nsampler = \"dart-throwin\"\n"),
              "c.toml:2: sampler = \"dart-throwin\": must be " + all_samplers() + "; did you mean \"dart-throwing\"?");
    EXPECT_EQ(error_of("[[method]]\nsampler = 5\n"), "c.toml:2: sampler = 5: must be " + all_samplers());
}

TEST(ConfigError, NumberParameter)
{
    const auto radius = [](const std::string& value) {
        return error_of("[[method]]\nsampler = \"dart-throwing\"\nrelative_radius = " + value + "\n");
    };
    const std::string allowed = "must be a number greater than 0 and at most 1";
    EXPECT_EQ(radius("1.5"), "c.toml:3: relative_radius = 1.5: " + allowed);
    EXPECT_EQ(radius("0"), "c.toml:3: relative_radius = 0: " + allowed);
    EXPECT_EQ(radius("-0.0"), "c.toml:3: relative_radius = -0.0: " + allowed);
    EXPECT_EQ(radius("nan"), "c.toml:3: relative_radius = nan: " + allowed);
    EXPECT_EQ(radius("inf"), "c.toml:3: relative_radius = inf: " + allowed);
    EXPECT_EQ(radius("\"0.7\""), "c.toml:3: relative_radius = \"0.7\": " + allowed);
    EXPECT_EQ(radius("true"), "c.toml:3: relative_radius = true: " + allowed);
    EXPECT_EQ(radius("[0.7,\n 0.75,\n 2]"), "c.toml:5: relative_radius = 2: " + allowed) << "at the item's own line";
    EXPECT_EQ(radius("[[0.7]]"), "c.toml:3: relative_radius = [0.7]: " + allowed);
    EXPECT_EQ(radius("[]"), "c.toml:3: relative_radius = []: the list is empty; each item must be "
                            "a number greater than 0 and at most 1");
}

TEST(ConfigError, NumberParameterBelowAnExclusiveMaximum)
{
    const auto factor = [](const std::string& value) {
        return error_of("[[method]]\nsampler = \"relaxation-dart-throwing\"\nfactor = " + value + "\n");
    };
    const std::string allowed = "must be a number greater than 0 and less than 1";
    EXPECT_EQ(factor("1.0"), "c.toml:3: factor = 1.0: " + allowed);
    EXPECT_EQ(factor("1"), "c.toml:3: factor = 1: " + allowed);
    EXPECT_EQ(factor("0.0"), "c.toml:3: factor = 0.0: " + allowed);
    EXPECT_EQ(factor("nan"), "c.toml:3: factor = nan: " + allowed);
    EXPECT_FALSE(make_plan(parse_config("[[method]]\nsampler = \"relaxation-dart-throwing\"\n"
                                        "factor = 0.9999999999\nattempts = 1\n",
                                        "c.toml"))
                     .empty());
}

TEST(ConfigError, ChoiceParameter)
{
    EXPECT_EQ(error_of("[[method]]\nsampler = \"dart-throwing\"\nstop = \"saturaton\"\n"),
              "c.toml:3: stop = \"saturaton\": must be one of \"points\", \"saturation\"; "
              "did you mean \"saturation\"?");
}

TEST(ConfigError, PathsParameter)
{
    EXPECT_EQ(error_of("[[method]]\nsampler = \"file\"\npath = [\"a.dat\", 3]\n"),
              "c.toml:3: path = 3: must be a path in quotes, or a list of them");
}

TEST(ConfigError, LongValuesAreCut)
{
    const std::string message = error_of("seed = \"" + std::string(300, 'x') + "\"\n" + good_method);
    EXPECT_EQ(message, "c.toml:1: seed = \"" + std::string(59, 'x') + "...: must be an integer of at least 0");
}

TEST(ConfigError, WhatTheSamplerRefusesNamesTheLine)
{
    EXPECT_EQ(error_of("[[method]]\nsampler = \"dart-throwing\"\nrelative_radius = [0.7,\n0.95]\n").substr(0, 34),
              "c.toml:4: relative_radius = 0.95: ");
    EXPECT_EQ(error_of("seed = 1\n[[method]]\nsampler = \"dart-throwing\"\n").substr(0, 10), "c.toml:2: ");
}

TEST(ConfigError, TheSameSeriesTwice)
{
    EXPECT_EQ(error_of("[[method]]\nsampler = \"dart-throwing\"\nrelative_radius = [0.7, 0.70]\n"),
              "c.toml:1: [[method]]: the series \"Dart throwing, rho = 0.7\" is there twice");
    EXPECT_EQ(error_of(good_method + "label = \"A\"\n" + good_method + "label = \"B\"\n"),
              "c.toml:4: [[method]]: the series \"A\" is there twice");
}

TEST(ConfigError, TooManySeries)
{
    std::string list;
    for (int i = 0; i < 1001; ++i) list += fmt::format("{}, ", 0.1 + 0.0001 * i);
    EXPECT_EQ(error_of("[[method]]\nsampler = \"dart-throwing\"\nrelative_radius = [" + list + "]\n"),
              "c.toml:1: [[method]]: its lists make more than 1000 series");
}

TEST(ConfigError, SyntaxIsToldWithFileAndLine)
{
    EXPECT_EQ(error_of("seed = 1\ntitle = \n"),
              "c.toml:2: Error while parsing key-value pair: expected value, saw '\\n'");
}

TEST(ConfigError, UnreadableFiles)
{
    const TemporaryFolder folder;
    const std::string name = folder.path().string();
    EXPECT_EQ(message_of([&] { read_config(name); }), name + ": is a folder; a config file (.toml) is needed");
    EXPECT_EQ(message_of([&] { read_config(name + "/no.toml"); }),
              name + "/no.toml: cannot be read: No such file or directory");
}

}
}
