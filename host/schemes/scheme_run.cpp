#include "host/schemes/scheme_run.hpp"

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

}
