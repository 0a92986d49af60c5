#include "host/texture/advice/advice_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace poissonlab {
namespace {

/// Returns the reason why a picture should not be tiled, in words and as the value of the JSON member.
std::pair<std::string, const char*> obstacle_words(const TextureAdvice& advice, const OpenAdvice& open)
{
    switch (advice.obstacle) {
    case TextureObstacle::one_color:
        return {"it has one colour only", "one color"};
    case TextureObstacle::one_object:
        return {"its middle has much more contrast than its rim, as one object on a plain ground does", "one object"};
    case TextureObstacle::not_alike:
        return {fmt::format("it does not look alike everywhere: the contrast of its parts has a standard deviation of "
                            "{:.2f} octaves; textures have at most 0.25",
                            advice.contrast_spread),
                "not alike"};
    case TextureObstacle::other_colors:
        return {fmt::format("it does not look alike everywhere: differences of lightness between its parts make up "
                            "{:.0f} % of its variance{}",
                            100 * advice.part_variance,
                            open.flatten ? "; if uneven light is the only cause, --flatten on evens it" : ""),
                "uneven"};
    case TextureObstacle::too_small:
        return {fmt::format("it has no room for two tiles of {} pixels along each side", advice.size), "too small"};
    case TextureObstacle::none:
        break;
    }
    return {"", ""};
}

std::string scale_words(const TextureAdvice& advice)
{
    return advice.scale ? fmt::format("its scale is {:.0f} pixels", *advice.scale)
                        : std::string("it has no scale below half of its size");
}

}

std::vector<std::string> advice_lines(const TextureAdvice& advice, const OpenAdvice& open)
{
    std::vector<std::string> lines;
    if (!advice.is_texture()) lines.push_back("Do not tile this picture: " + obstacle_words(advice, open).first);
    if (advice.obstacle == TextureObstacle::one_color) return lines;
    lines.push_back(fmt::format(
        "Take tiles of {} x {} pixels{}{}: {}{}", advice.size, advice.size,
        open.colors ? fmt::format(" of {} colours", advice.colors) : "",
        !open.joint       ? ""
        : advice.is_joint ? ", made both ways, the better set being kept"
                          : ", fitted one piece after another",
        scale_words(advice),
        advice.is_wide ? ", which is wide for such tiles; a larger part of the scene would be better" : ""));
    if (open.straighten && !advice.periods.empty())
        lines.push_back(fmt::format("It is regular, every {:.1f} pixels: {}", fmt::join(advice.periods, " and "),
                                    advice.is_straightened ? "--straighten lets joints run through"
                                                           : "tiles hold a whole number of periods"));
    if (!open.is_light_said && advice.is_flattened)
        lines.push_back(fmt::format("Its light is uneven: {:.0f} % of its power varies over more than two tiles, and "
                                    "tilings would show it as a pattern; texture build flattens it (--flatten off "
                                    "keeps it)",
                                    100 * advice.slow_power));
    return lines;
}

std::string advice_json(const TextureAdvice& advice)
{
    nlohmann::ordered_json json{{"width", advice.width}, {"height", advice.height}, {"texture", advice.is_texture()}};
    if (!advice.is_texture()) json["obstacle"] = obstacle_words(advice, {}).second;
    json["kind"] = "corner";
    json["colors"] = advice.colors;
    json["size"] = advice.size;
    json["joint"] = advice.is_joint ? "auto" : "off";
    json["straighten"] = advice.is_straightened;
    json["flatten"] = advice.is_flattened;
    if (advice.scale) json["scale"] = *advice.scale;
    json["is_wide"] = advice.is_wide;
    json["periods"] = advice.periods;
    json["slow_power"] = advice.slow_power;
    json["contrast_spread"] = advice.contrast_spread;
    json["part_variance"] = advice.part_variance;
    json["lines"] = advice_lines(advice);
    return json.dump(2);
}

std::string advice_note(const TextureAdvice& advice, const TextureRequest& request, const OpenAdvice& open)
{
    const int room = std::min(advice.width, advice.height);
    if (request.size > room) return ""; // which is refused
    if (!advice.is_texture()) return fmt::format("Do not tile this picture: {}", obstacle_words(advice, open).first);
    if (request.size < advice.size && advice.scale && request.size < least_tile_scales * *advice.scale)
        return fmt::format("The scale of the picture is {:.0f} pixels: --size {} is advised, {} was given",
                           *advice.scale, advice.size, request.size);
    if (request.size > advice.size && 2 * request.size > room)
        return fmt::format("The picture has {} x {} pixels: --size {} is advised, {} was given", advice.width,
                           advice.height, advice.size, request.size);
    const Color colors = advised_colors(request.size);
    if (request.kind == TextureKind::corner && request.colors.horizontal < colors && request.split == 0)
        return fmt::format("Tilings repeat visibly with {} colours: --colors {} is advised", request.colors.horizontal,
                           colors);
    return "";
}

}
