#include "reports/plots/plot_export.hpp"

#include "base/text/csv_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

namespace poissonlab {
namespace {

/// The shortest number that is the same double; empty where there is none.
std::string csv_number(const std::vector<double>& values, std::size_t i)
{
    return i < values.size() && std::isfinite(values[i]) ? fmt::format("{}", values[i]) : std::string();
}

/// Letters and signs of labels that are not ASCII.
constexpr std::array<std::pair<std::string_view, std::string_view>, 12> latex_signs{{
    {"ρ", "$\\rho$"},
    {"ν", "$\\nu$"},
    {"√", "$\\surd$"},
    {"×", "$\\times$"},
    {"·", "$\\cdot$"},
    {"²", "$^2$"},
    {"−", "$-$"},
    {"≤", "$\\leq$"},
    {"≥", "$\\geq$"},
    {"–", "--"},
    {"…", "\\dots{}"},
    {"°", "$^\\circ$"},
}};

/// Characters that command LaTeX.
std::string_view latex_escape(char c)
{
    switch (c) {
    case '\\':
        return "\\textbackslash{}";
    case '~':
        return "\\textasciitilde{}";
    case '^':
        return "\\textasciicircum{}";
    case '&':
        return "\\&";
    case '%':
        return "\\%";
    case '$':
        return "\\$";
    case '#':
        return "\\#";
    case '_':
        return "\\_";
    case '{':
        return "\\{";
    case '}':
        return "\\}";
    case '<':
        return "$<$";
    case '>':
        return "$>$";
    default:
        return {};
    }
}

/// In mathematics the minus sign is that of ASCII.
std::string plain_minus(std::string_view text)
{
    std::string plain(text);
    for (std::size_t at = 0; (at = plain.find("−", at)) != plain.npos;)
        plain.replace(at, std::string_view("−").size(), "-");
    return plain;
}

std::string color_of(std::size_t index) { return fmt::format("poissonlab{}", curve_color(index).substr(1)); }

/// Dashes in the points of a plot on paper, which is three quarters as wide as on a page.
std::string dashes_of(std::size_t index)
{
    std::string pattern;
    bool is_on = true;
    std::string_view rest = curve_dashes(index);
    while (!rest.empty()) {
        const std::string_view length = rest.substr(0, rest.find(' '));
        pattern += fmt::format("{}{} {}pt", pattern.empty() ? "" : " ", is_on ? "on" : "off", length);
        is_on = !is_on;
        rest.remove_prefix(std::min(rest.size(), length.size() + 1));
    }
    return pattern.empty() ? pattern : ", dash pattern=" + pattern;
}

std::string coordinates(const std::vector<double>& x, const std::vector<double>& y)
{
    std::string text;
    for (std::size_t i = 0; i < x.size() && i < y.size(); ++i)
        fmt::format_to(std::back_inserter(text), "({:.8g},{})\n", x[i],
                       std::isfinite(y[i]) ? fmt::format("{:.6g}", y[i]) : "nan");
    return text;
}

/// A band is a polygon: along its low side, and back along the high one.
std::string band(const PlotCurve& curve)
{
    std::vector<double> x, y;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        if (!std::isfinite(curve.low[i]) || !std::isfinite(curve.high[i])) continue;
        x.push_back(curve.x[i]);
        y.push_back(curve.low[i]);
    }
    for (std::size_t i = curve.x.size(); i-- > 0;) {
        if (!std::isfinite(curve.low[i]) || !std::isfinite(curve.high[i])) continue;
        x.push_back(curve.x[i]);
        y.push_back(curve.high[i]);
    }
    if (x.empty()) return {};
    return fmt::format("\\addplot[draw=none, fill={}, fill opacity=0.25, forget plot] coordinates {{\n{}}};\n",
                       color_of(curve.index), coordinates(x, y));
}

/// Bars are lines of two places each, with a gap between.
std::string bars(const PlotCurve& curve)
{
    std::string text = fmt::format("\\addplot[{}, thick, forget plot] coordinates {{\n", color_of(curve.index));
    for (std::size_t i = 0; i < curve.x.size(); ++i)
        if (std::isfinite(curve.low[i]) && std::isfinite(curve.high[i]))
            text += coordinates({curve.x[i], curve.x[i], curve.x[i]}, {curve.low[i], curve.high[i], std::nan("")});
    return text + "};\n";
}

std::string latex_curve(const PlotCurve& curve, bool is_alone, bool has_legend)
{
    std::string text;
    const bool has_range = curve.low.size() == curve.x.size() && curve.high.size() == curve.x.size();
    if (has_range && curve.has_bars) text += bars(curve);
    if (has_range && !curve.has_bars && is_alone && curve.low != curve.high) text += band(curve);
    text += fmt::format("\\addplot[{}{}{}] coordinates {{\n{}}};\n", color_of(curve.index), dashes_of(curve.index),
                        curve.x.size() == 1 ? ", mark=*" : "", coordinates(curve.x, curve.y));
    if (has_legend) text += fmt::format("\\addlegendentry{{{}}}\n", latex_words(curve.label));
    if (!curve.dots.empty())
        text += fmt::format("\\addplot[{}, only marks, mark size=0.8pt, forget plot] coordinates {{\n{}}};\n",
                            color_of(curve.index), coordinates(curve.x, curve.dots));
    return text;
}

std::string latex_axis(const char* name, const PlotAxis& axis)
{
    std::string text = fmt::format("  {0}label={{{1}}}, {0}min={2:g}, {0}max={3:.10g},\n", name,
                                   latex_words(axis.label), axis.low, axis.high);
    if (axis.logarithmic) text += fmt::format("  {}mode=log,\n", name);
    if (axis.ticks.empty()) return text;
    std::string places, words;
    for (const auto& [place, label] : axis.ticks) {
        places += fmt::format("{}{:g}", places.empty() ? "" : ",", place);
        words += fmt::format("{}{{{}}}", words.empty() ? "" : ",", latex_words(label));
    }
    return text + fmt::format("  {0}tick={{{1}}}, {0}ticklabels={{{2}}},\n", name, places, words);
}

std::string latex_reference(const Plot& plot, const ReferenceLine& line)
{
    return fmt::format(
        "\\draw[dashed, thin] (axis cs:{0:g},{2:.6g}) -- (axis cs:{1:.10g},{2:.6g}){3};\n", plot.x.low, plot.x.high,
        line.height,
        line.text.empty() ? "" : fmt::format(" node[above left, font=\\footnotesize] {{{}}}", latex_words(line.text)));
}

std::string latex_mark(const Plot& plot, const UprightMark& mark)
{
    return fmt::format("\\draw[dotted] (axis cs:{0:.6g},{1:g}) -- (axis cs:{0:.6g},{2:.10g}) node[below {3}, "
                       "font=\\footnotesize] {{{4}}};\n",
                       mark.x, plot.y.low, plot.y.high, mark.name_on_the_left ? "left" : "right",
                       latex_words(mark.name));
}

std::string latex_colors(const Plot& plot)
{
    std::string text;
    for (const PlotCurve& curve : plot.curves) {
        std::string code = curve_color(curve.index).substr(1);
        const std::string line = fmt::format("\\definecolor{{{}}}{{HTML}}{{", color_of(curve.index));
        std::ranges::transform(code, code.begin(), [](char c) { return c >= 'a' ? static_cast<char>(c - 32) : c; });
        if (text.find(line) == std::string::npos) text += line + code + "}\n";
    }
    return text;
}

}

std::string plot_csv(const Plot& plot)
{
    std::string text = "curve,x,y,low,high,dot\n";
    for (const PlotCurve& curve : plot.curves)
        for (std::size_t i = 0; i < curve.x.size(); ++i)
            fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{}\n", csv_quoted(curve.label),
                           csv_number(curve.x, i), csv_number(curve.y, i), csv_number(curve.low, i),
                           csv_number(curve.high, i), csv_number(curve.dots, i));
    return text;
}

std::string latex_words(const std::string& words)
{
    std::string text;
    for (std::size_t at = 0; at < words.size();) {
        const std::string_view rest = std::string_view(words).substr(at);
        const auto sign = std::ranges::find_if(latex_signs, [&](const auto& s) { return rest.starts_with(s.first); });
        if (sign != latex_signs.end()) {
            text += sign->second;
            at += sign->first.size();
        } else if (const auto end = rest.find('}');
                   (rest.starts_with("_{") || rest.starts_with("^{")) && end != rest.npos) {
            text += fmt::format("${}{{\\mathrm{{{}}}}}$", rest.front(), plain_minus(rest.substr(2, end - 2)));
            at += end + 1;
        } else {
            const std::string_view escaped = latex_escape(rest.front());
            escaped.empty() ? text += rest.front() : text += escaped;
            ++at;
        }
    }
    return text;
}

std::string plot_latex(const Plot& plot)
{
    const bool has_legend = plot.curves.size() > 1;
    std::string text =
        "% \\usepackage{pgfplots} \\pgfplotsset{compat=1.18}\n" + latex_colors(plot) +
        "\\begin{tikzpicture}\n\\begin{axis}[\n  unbounded coords=jump, axis lines=left, ymajorgrids,\n" +
        latex_axis("x", plot.x) + latex_axis("y", plot.y);
    if (has_legend)
        text += "  legend style={at={(0.5,-0.25)}, anchor=north, draw=none, font=\\footnotesize}, "
                "legend cell align=left,\n";
    text += "]\n";
    for (const PlotCurve& curve : plot.curves) text += latex_curve(curve, plot.curves.size() == 1, has_legend);
    for (const ReferenceLine& line : plot.references) text += latex_reference(plot, line);
    for (const UprightMark& mark : plot.marks) text += latex_mark(plot, mark);
    for (const SlopeMark& slope : plot.slopes)
        text += fmt::format("\\draw[dashed, thin] (axis cs:{:g},{:.6g}) -- (axis cs:{:.10g},{:.6g}) node[{}, "
                            "font=\\footnotesize] {{{}}};\n",
                            slope.left, slope.left_height, slope.right, slope.right_height,
                            slope.name_on_the_left ? "at start, above right" : "above left", latex_words(slope.name));
    return text + "\\end{axis}\n\\end{tikzpicture}\n";
}

}
