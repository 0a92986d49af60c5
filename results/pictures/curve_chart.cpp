#include "results/pictures/curve_chart.hpp"

#include "base/files/json_file.hpp"
#include "base/files/json_members.hpp"

#include <nlohmann/json.hpp>

namespace poissonlab {
namespace {

constexpr const char* chart_format = "poissonlab-curves";
constexpr int chart_format_version = 1;

void describe_axis(JsonMembers& m, Stored<ChartAxis> auto& axis)
{
    m.member("name", axis.name);
    m.member("low", axis.low);
    m.member("high", axis.high);
    m.member("step", axis.step);
    m.check([&](const StoredObject& object) {
        if (!(axis.low < axis.high && axis.step > 0)) throw object.error("high", "must be above low, in steps above 0");
    });
}

void numbers(JsonMembers& m, const std::vector<std::array<double, 2>>& places)
{
    for (const std::size_t k : {0, 1}) {
        std::vector<double> values;
        for (const auto& place : places) values.push_back(place[k]);
        m.member(k == 0 ? "x" : "y", std::as_const(values));
    }
}

void numbers(JsonMembers& m, std::vector<std::array<double, 2>>& places)
{
    const std::vector<double> x = m.stored().numbers("x"), y = m.stored().numbers("y");
    if (x.size() != y.size()) throw m.stored().error("y", "must have as many numbers as x");
    places.clear();
    for (std::size_t i = 0; i < x.size(); ++i) places.push_back({x[i], y[i]});
}

void describe_curve(JsonMembers& m, Stored<ChartCurve> auto& curve)
{
    m.member("name", curve.name);
    m.member("color", curve.color);
    numbers(m, curve.places);
    m.check([&](const StoredObject& object) {
        const std::string& color = curve.color;
        if (color.size() != 7 || color[0] != '#' || color.find_first_not_of("0123456789abcdef", 1) != std::string::npos)
            throw object.error("color", "must be #rrggbb");
    });
}

void describe_chart(JsonMembers& m, Stored<CurveChart> auto& chart)
{
    m.format(chart_format, chart_format_version);
    m.group("x", [&](JsonMembers& n) { describe_axis(n, chart.x); });
    m.group("y", [&](JsonMembers& n) { describe_axis(n, chart.y); });
    m.member("level", chart.level);
    m.objects("curves", chart.curves, [](JsonMembers& n, auto& curve) { describe_curve(n, curve); });
}

}

std::string class_color(std::size_t index)
{
    static constexpr std::array colors{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                       "#e69f00", "#56b4e9", "#a89b00", "#4d4d4d"};
    return colors[index % colors.size()];
}

std::string curve_chart_json(const CurveChart& chart)
{
    return json_text([&](JsonMembers& root) { describe_chart(root, chart); }) + "\n";
}

CurveChart read_curve_chart(const std::filesystem::path& file)
{
    const nlohmann::json json = read_json_file(file);
    JsonMembers root(StoredObject(json, file));
    CurveChart chart;
    describe_chart(root, chart);
    return chart;
}

}
