// poissonlab isohedral draw: a tiling of a type with parameters and curves, or one of each type.
#include "app/commands/command.hpp"
#include "app/commands/tilings/aperiodic_choice.hpp"
#include "base/errors/errors.hpp"
#include "base/files/text_lines.hpp"
#include "base/text/decimal_commas.hpp"
#include "reports/drawings/tilings/isohedral_image.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>

namespace poissonlab {
namespace {

constexpr auto isohedral_draw_notes =
    R"(TYPE is a number from 1 to 93, or all: a picture of each of the 81 types that shapes can tell, with random shapes.
Without options the tile is that of the Laves tiling. A parameter moves corners; 0.1 is a tenth of the radius of the
circle inside of that tile. A curve is given by its points between (0, 0) and (1, 0), as isohedral list orders curves;
curves that may not be of any shape take what is needed of it.
  poissonlab isohedral draw 16 --parameters 0.3 --out ih16.svg
  poissonlab isohedral draw 1 --curve "0.3,0.2 0.7,-0.1" --curve "0.5,0.3" --out ih1.png
  poissonlab isohedral draw 28 --random --seed 5 --out ih28.png
  poissonlab isohedral draw all --out all.png)";

constexpr double largest_window = 200; // sides of tiles; there are 40,000 tiles then
constexpr std::size_t gallery_columns = 9;

struct IsohedralDrawOptions
{
    std::string type;
    std::string parameters;
    std::vector<std::string> curves;
    bool random = false;
    std::uint64_t seed = 1;
    std::vector<std::int64_t> window;
    std::filesystem::path out;
};

const IsohedralType& chosen_type(const std::string& word)
{
    int number = 0;
    const std::string_view digits = std::string_view(word).substr(word.starts_with("IH") ? 2 : 0);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error != std::errc() || end != digits.data() + digits.size() || number < 1 || number > 93)
        throw InputError(
            fmt::format("isohedral draw: TYPE {}: must be an integer from 1 to 93, or all", shortened(word)));
    return isohedral_types()[static_cast<std::size_t>(number - 1)];
}

/// Numbers between blanks or commas.
std::vector<double> numbers_of(const std::string& option, const std::string& text)
{
    std::vector<double> numbers;
    for (WordReader words(text); words.next();) {
        double value = 0;
        if (!parse_number(words.word(), value) || !std::isfinite(value))
            throw InputError(fmt::format("isohedral draw: {} {}: \"{}\" is not a number", option, shortened(text),
                                         shortened(words.word())));
        numbers.push_back(value);
    }
    return numbers;
}

PlaneCurve curve_of(const std::string& text)
{
    const std::vector<double> numbers = numbers_of("--curve", text);
    if (numbers.size() % 2 != 0)
        throw InputError(fmt::format("isohedral draw: --curve {}: must be points, two numbers each{}", shortened(text),
                                     decimal_comma_words(text)));
    PlaneCurve curve{{0, 0}};
    for (std::size_t i = 0; i < numbers.size(); i += 2) curve.push_back({numbers[i], numbers[i + 1]});
    curve.push_back({1, 0});
    return curve;
}

IsohedralTile chosen_tile(const IsohedralDrawOptions& o, const IsohedralType& type)
{
    if (o.random && (!o.parameters.empty() || !o.curves.empty()))
        throw InputError("isohedral draw: --random: cannot be combined with --parameters and --curve");
    if (o.random) return random_tile(type, o.seed, drawn_deformation, drawn_amplitude);
    IsohedralParameters parameters{numbers_of("--parameters", o.parameters), {}};
    const std::size_t given = parameters.deformations.size(), needed = type.shape.parameters();
    if (given > 0 && given != needed)
        throw InputError(fmt::format("isohedral draw: --parameters {}: must be as many as IH{} has: {}{}",
                                     shortened(o.parameters), type.number, needed, decimal_comma_words(o.parameters)));
    for (const std::string& text : o.curves) parameters.curves.push_back(curve_of(text));
    if (parameters.curves.size() > type.shape.curve_shapes.size())
        throw InputError(fmt::format("isohedral draw: --curve: IH{} has {} curves, not {}", type.number,
                                     type.shape.curve_shapes.size(), parameters.curves.size()));
    try {
        return {type, parameters};
    } catch (const InputError& error) {
        throw error.moved_to({"isohedral draw"});
    }
}

Drawing gallery(std::uint64_t seed)
{
    std::vector<IsohedralPanel> panels;
    for (const IsohedralType& type : isohedral_types()) {
        if (type.is_marked) continue;
        const IsohedralTile tile = random_tile(type, seed, drawn_deformation, drawn_amplitude);
        panels.push_back({fmt::format("IH{}", type.number), tile, proper_coloring(tile)});
    }
    return draw_isohedral_gallery(panels, gallery_columns);
}

Drawing chosen_drawing(const IsohedralDrawOptions& o)
{
    if (o.type == "all") {
        if (!o.parameters.empty() || !o.curves.empty() || !o.window.empty())
            throw InputError("isohedral draw all: has --seed and --out only");
        return gallery(o.seed);
    }
    const IsohedralType& type = chosen_type(o.type);
    const std::vector<std::int64_t> window = o.window.empty() ? std::vector<std::int64_t>{12, 12} : o.window;
    if (window.size() != 2 || window[0] < 1 || window[1] < 1 || static_cast<double>(window[0]) > largest_window ||
        static_cast<double>(window[1]) > largest_window)
        throw InputError(fmt::format("isohedral draw: --window {}: must be W H, each from 1 to {}",
                                     fmt::join(window, " "), largest_window));
    const IsohedralTile tile = chosen_tile(o, type);
    return draw_isohedral_tiling(tile, proper_coloring(tile), static_cast<double>(window[0]),
                                 static_cast<double>(window[1]));
}

void draw_isohedral(const IsohedralDrawOptions& options)
{
    const std::filesystem::path out = checked_output("isohedral draw", "--out", options.out, picture_formats());
    write_picture_file(out, chosen_drawing(options));
}

}

Command isohedral_draw_command()
{
    const auto o = std::make_shared<IsohedralDrawOptions>();
    return {"draw",
            "Draw an isohedral tiling",
            {{"TYPE", &o->type, "1 to 93, or all"},
             {"--parameters", &o->parameters, "Where the corners are: one number for each parameter", "X,Y,..."},
             {"--curve", &o->curves, "The points of a curve; once for each, in their order", "\"X,Y X,Y ...\""},
             {"--random", &o->random, "Random parameters and curves"},
             {"--seed", &o->seed, "The seed of random shapes; default: 1", "S"},
             {"--window", &o->window, "Width and height, in sides of a square as large as the tile; default: 12 12",
              "W H", optional, 2},
             {"--out", &o->out, "The picture (.svg, .png)", "FILE", required}},
            isohedral_draw_notes,
            action_on(o, draw_isohedral)};
}

}
