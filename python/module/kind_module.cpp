// Kinds of work for Python: their keys, and what is made of them. Values come as TOML, so that they are checked by the
// lines that check configs.
#include "base/errors/errors.hpp"
#include "base/images/png_file.hpp"
#include "base/points/point_file.hpp"
#include "host/device/device.hpp"
#include "host/kinds/kinds.hpp"
#include "host/settings/nearest_key.hpp"
#include "host/settings/toml_reader.hpp"
#include "host/texture/advice/advice_words.hpp"
#include "python/module/arrays.hpp"
#include "python/module/module_parts.hpp"
#include "reports/drawings/construction_image.hpp"
#include "reports/drawings/mark_image.hpp"
#include "results/file_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <variant>

namespace py = pybind11;

namespace poissonlab {
namespace {

/// Returns the name of the kind of values that a key has, for hints of types.
const char* kind_of_key(const KeySpec& spec)
{
    if (spec.value.kind == ParameterSpec::Kind::boolean && !spec.own.empty()) return "switch";
    if (!spec.own.empty() || spec.is_spread) return "own";
    if (!spec.parts.empty()) return "list";
    if (spec.is_region) return "region";
    if (spec.is_file || spec.is_formula) return "file";
    return kind_of(spec.value);
}

py::dict description_of_key(const KeySpec& spec)
{
    py::dict description;
    description["key"] = spec.value.key;
    description["name"] = spec.alias.empty() ? spec.value.key : spec.alias;
    description["kind"] = kind_of_key(spec);
    description["default"] = spec.parts.empty() ? default_of(spec.value) : py::none();
    description["is_required"] = spec.is_required;
    description["help"] = key_help(spec);
    return description;
}

py::list kind_descriptions()
{
    py::list list;
    for (const Kind& kind : all_kinds()) {
        py::list keys;
        for (const KeySpec& spec : kind.keys()) keys.append(description_of_key(spec));
        py::dict description;
        description["table"] = kind.table;
        description["word"] = kind.word;
        description["command"] = kind.command;
        description["title"] = kind.title;
        description["summary"] = kind.summary;
        description["keys"] = keys;
        list.append(description);
    }
    return list;
}

DistributionPlace place_of(const std::string& name, const std::string& engine, const std::string& device)
{
    const auto found = engines.find(engine);
    if (!found)
        throw InputError(fmt::format("{}: engine = {}: must be one of \"{}\"{}", name, engine,
                                     fmt::join(engines.all(), "\", \""), did_you_mean(engine, engines.all())));
    if (!device.empty()) Device::find(device); // throws where there is none of this name, whatever the work needs
    const auto opened = std::make_shared<std::optional<Device>>();
    return {*found,
            [opened, device]() -> Device& {
                if (!*opened) *opened = Device::open(device);
                return **opened;
            },
            [](const std::string&) { stop_if_interrupted(); }};
}

/// Panels become a picture beside their file.
void draw_scene(const std::filesystem::path& folder, DistributionResult& result)
{
    for (const std::string& file : result.files) {
        if (file != file_names::construction) continue;
        const Drawing drawing = draw_construction(read_scene(folder / file));
        write_drawing_png(folder / "construction.png", drawing, static_cast<int>(drawing.width));
        result.pictures.push_back({"construction.png", "The construction."});
        return;
    }
}

/// Pictures of marks become pixels beside them, and curves are files to read.
void draw_pictures(const std::filesystem::path& folder, DistributionResult& result)
{
    for (const DistributionPicture& picture : result.pictures)
        if (picture.has_curves()) result.files.push_back(picture.file);
    std::erase_if(result.pictures, [](const DistributionPicture& picture) { return picture.has_curves(); });
    for (DistributionPicture& picture : result.pictures) {
        if (!picture.has_marks()) continue;
        const std::filesystem::path file = folder / picture.file;
        const MarkPicture marks = read_mark_picture(file);
        picture.file = std::filesystem::path(picture.file).replace_extension(".png").string();
        write_drawing_png(folder / picture.file, draw_marks(marks, folder), marks.pixels);
    }
}

DistributionResult as_distribution(DistributionResult result) { return result; }

/// Tile indices in a file, and how random colours are.
DistributionResult as_distribution(const TilingResult& tiling)
{
    DistributionResult result;
    result.facts = {fmt::format("{} tiles over {} colours in the set", tiling.tiles, tiling.colors)};
    result.files = {tiling.file};
    if (!tiling.statistics) return result;
    for (const ColorStatistics& colors : tiling.statistics->colors) {
        std::string key = colors.name;
        std::ranges::replace(key, ' ', '_');
        result.numbers.push_back({key + "_p_value", "Frequencies of colours of " + colors.name,
                                  colors.frequencies.p_value, "p-value of a chi-square test"});
        result.files.push_back(colors.autocorrelation_file);
    }
    return result;
}

/// Panels of regions and points in a file.
DistributionResult as_distribution(const ConstructionResult& construction)
{
    DistributionResult result;
    result.facts = {fmt::format("{} panels", construction.scene.panels)};
    result.files = {construction.file};
    return result;
}

/// Makes what the values ask for in the folder. `name` begins messages.
DistributionResult made(const std::string& name, const Kind& kind, const std::string& values, std::uint64_t seed,
                        const DistributionPlace& place, const std::filesystem::path& folder)
{
    try {
        const KindSettings settings = read_kind(kind, read_toml(values, name), {name}, "");
        DistributionFiles files([&](const std::string& file) { return folder / file; });
        DistributionResult result = std::visit([](auto own) { return as_distribution(std::move(own)); },
                                               kind.make(settings, seed, place, files));
        result.label = settings.label;
        draw_pictures(folder, result);
        draw_scene(folder, result);
        return result;
    } catch (const InputError& error) {
        throw error.place().file == name ? error.moved_to({name}) : error;
    }
}

py::array_t<std::uint8_t> pixels_of(const std::filesystem::path& file)
{
    PngPixels png = read_png(file);
    return array_of(std::move(png.values), {png.height, png.width, png.channels});
}

py::dict make(const std::string& name, const std::string& table, const std::string& word, const std::string& values,
              std::uint64_t seed, const std::string& engine, const std::string& device,
              const std::filesystem::path& folder)
{
    const Kind& kind = *find_kind(table, word);
    const DistributionResult result =
        without_lock([&] { return made(name, kind, values, seed, place_of(name, engine, device), folder); });
    py::dict numbers, titles, pictures, captions;
    for (const DistributionNumber& number : result.numbers) {
        numbers[py::str(number.key)] = number.value;
        titles[py::str(number.key)] = fmt::format("{}: {}", number.title, number.meaning);
    }
    for (const DistributionPicture& picture : result.pictures) {
        const std::string stem = std::filesystem::path(picture.file).stem().string();
        pictures[py::str(stem)] = pixels_of(folder / picture.file);
        captions[py::str(stem)] = picture.caption;
    }
    py::dict dict;
    dict["label"] = result.label;
    dict["facts"] = result.facts;
    dict["numbers"] = numbers;
    dict["titles"] = titles;
    dict["pictures"] = pictures;
    dict["captions"] = captions;
    dict["files"] = result.files;
    return dict;
}

std::string texture_advice(const std::filesystem::path& picture)
{
    return without_lock([&] { return advice_json(advise_file(picture)); });
}

}

void add_kinds(py::module_& module)
{
    module.def("kinds", kind_descriptions, "The kinds of work and their keys, a dict each.");
    module.def("make", make, py::arg("name"), py::arg("table"), py::arg("word"), py::arg("values"), py::arg("seed"),
               py::arg("engine"), py::arg("device"), py::arg("folder"), "Makes a result in a folder.");
    module.def("texture_advice", texture_advice, py::arg("picture"), "What `texture advise --json` prints.");
}

}
