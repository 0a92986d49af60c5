#include "host/schemes/scheme_run.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {

std::optional<std::vector<double>> numbers_of_list(const ConfigNode& list, double most)
{
    const auto* items = list.get_if<ConfigList>();
    if (!items) return {};
    std::vector<double> numbers;
    for (const ConfigNode& item : *items) {
        const auto* whole = item.get_if<std::int64_t>();
        const auto* real = item.get_if<double>();
        if (!whole && !real) return {};
        numbers.push_back(whole ? static_cast<double>(*whole) : *real);
        if (!(std::abs(numbers.back()) <= most)) return {};
    }
    return numbers;
}

std::optional<PlaneCurve> curve_of_node(const ConfigNode& list)
{
    const auto* points = list.get_if<ConfigList>();
    if (!points) return {};
    PlaneCurve curve{{0, 0}};
    for (const ConfigNode& point : *points) {
        const auto numbers = numbers_of_list(point);
        if (!numbers || numbers->size() != 2) return {};
        curve.push_back({(*numbers)[0], (*numbers)[1]});
    }
    curve.push_back({1, 0});
    return curve;
}

void curve_keys(Keys& keys, std::vector<PlaneCurve>& curves)
{
    constexpr auto allowed = "a list of curves, each a list of points [x, y] from -100 to 100";
    keys.value("curves", allowed, "the points of curves between (0, 0) and (1, 0)",
               [&](const ConfigNode& node) {
                   const auto refused = [&] { return keys.invalid("curves", std::string("must be ") + allowed); };
                   const auto* list = node.get_if<ConfigList>();
                   if (!list) throw refused();
                   for (const ConfigNode& curve : *list) {
                       const auto read = curve_of_node(curve);
                       if (!read) throw refused();
                       curves.push_back(*read);
                   }
               })
        .otherwise("straight");
}

void split_keys(Keys& keys, std::optional<TileSplit>& split, const std::vector<std::string>& excluded)
{
    constexpr auto allowed = "two corners of the tile, [0, 2]";
    Keys::Said said = keys.value(
        "split", allowed, "the corners that a path joins, which divides the tile in two", [&](const ConfigNode& node) {
            const auto corners = numbers_of_list(node);
            const auto is_corner = [](double x) { return x == std::floor(x) && x >= 0 && x < 6; };
            if (!corners || corners->size() != 2 || !std::ranges::all_of(*corners, is_corner))
                throw keys.invalid("split", std::string("must be ") + allowed);
            split.emplace();
            split->from = static_cast<std::size_t>((*corners)[0]);
            split->to = static_cast<std::size_t>((*corners)[1]);
        });
    said.otherwise("tiles are whole");
    for (const std::string& key : excluded) said.excludes(key);
    keys.value("split_curve", "[[0.3, 0.1], [0.7, -0.1]]", "the points of the path between (0, 0) and (1, 0)",
               [&](const ConfigNode& node) {
                   const auto path = curve_of_node(node);
                   if (!path) throw keys.invalid("split_curve", "must be a list of points, such as [[0.3, 0.1]]");
                   if (split) split->path = *path;
               })
        .otherwise("straight")
        .only_if(split.has_value(), "split");
}

}
