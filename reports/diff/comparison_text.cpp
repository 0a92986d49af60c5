#include "reports/diff/comparison_text.hpp"

#include "base/text/noun.hpp"
#include "base/word_table.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace poissonlab {

namespace {

constexpr int shown_digits = 5;

std::string with_error(const SampleMean& mean, bool exact)
{
    const bool count = mean.value == std::floor(mean.value) && mean.standard_error == 0;
    if (exact || count) return format_exact(mean.value);
    return format_estimate(mean.value, mean.standard_error, shown_digits).text();
}

const char* verdict_name(Verdict verdict)
{
    constexpr WordTable<Verdict, 5> words{{{{Verdict::identical, "identical"},
                                            {Verdict::within_error, "within error"},
                                            {Verdict::changed, "changed"},
                                            {Verdict::not_comparable, "not comparable"},
                                            {Verdict::not_judged, "no verdict"}}}};
    return words[verdict];
}

/// Worse, changed, better, then what did not change: what a reader must see first.
int order_of(const NumberComparison& number)
{
    switch (number.verdict) {
    case Verdict::changed:
        return !number.improved() ? 1 : *number.improved() ? 2 : 0;
    case Verdict::not_judged:
        return 3;
    case Verdict::not_comparable:
        return 4;
    case Verdict::within_error:
        return 5;
    case Verdict::identical:
        break;
    }
    return 6;
}

std::string counted(std::size_t count, const std::string& one, const std::string& many)
{
    return format_count(count) + " " + noun(count, one, many);
}

/// Columns padded to the widest cell, two blanks between them.
std::string in_columns(const std::vector<std::array<std::string, 5>>& rows)
{
    std::array<std::size_t, 5> widths{};
    for (const auto& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i)
            widths[i] = std::max(widths[i], static_cast<std::size_t>(std::ranges::count_if(
                                                row[i], [](char c) { return (c & 0xc0) != 0x80; }))); // characters
    std::string text;
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) line += fmt::format("{:<{}}", row[i], widths[i] + 2);
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

nlohmann::ordered_json mean_json(const std::optional<SampleMean>& mean)
{
    if (!mean) return nullptr;
    nlohmann::ordered_json json = {{"value", mean->value}};
    if (mean->standard_error > 0) json["standard_error"] = mean->standard_error;
    json["samples"] = mean->samples;
    return json;
}

nlohmann::ordered_json number_json(const ComparedLine& line)
{
    const auto& number = *line.number;
    constexpr std::array better{"higher", "lower", "neither"};
    nlohmann::ordered_json json = {{"series", line.series->name()},
                                   {"quantity", number.quantity},
                                   {"unit", number.unit},
                                   {"better", better[static_cast<std::size_t>(number.better)]},
                                   {"old", mean_json(number.before)},
                                   {"new", mean_json(number.after)},
                                   {"verdict", verdict_name(number.verdict)}};
    if (number.verdict == Verdict::changed && number.improved()) json["improved"] = *number.improved();
    if (number.adjusted_p) json["p"] = *number.adjusted_p;
    if (!number.note.empty()) json["note"] = number.note;
    return json;
}

}

std::string verdict_words(const NumberComparison& number)
{
    if (number.verdict != Verdict::changed || !number.improved()) return verdict_name(number.verdict);
    return *number.improved() ? "better" : "worse";
}

NumberTexts number_texts(const NumberComparison& number)
{
    const auto text = [&](const std::optional<SampleMean>& mean, bool exact) {
        return mean ? with_error(*mean, exact) : "none";
    };
    NumberTexts texts{text(number.before, false), text(number.after, false)};
    const bool differ = number.before && number.after && number.before->value != number.after->value;
    if (differ && texts.before == texts.after) texts = {text(number.before, true), text(number.after, true)};
    return texts;
}

std::string reason_words(const NumberComparison& number)
{
    std::string text;
    if (number.adjusted_p && number.before && number.after)
        text = fmt::format("t = {}, p = {}", format_fixed(welch_test(*number.before, *number.after).t, 1),
                           format_significant(*number.adjusted_p, 2));
    return text + (text.empty() || number.note.empty() ? "" : "; ") + number.note;
}

std::string comparison_summary(const RunComparison& comparison)
{
    std::size_t total = 0;
    for (const auto& series : comparison.series) total += series.numbers.size();
    auto text = fmt::format(
        "{} in both. Of {}, {} changed, {} within their error, {} identical, {} without verdict, {} not comparable.",
        counted(comparison.series.size(), "series", "series"), counted(total, "number", "numbers"),
        format_count(comparison.count(Verdict::changed)), format_count(comparison.count(Verdict::within_error)),
        format_count(comparison.count(Verdict::identical)), format_count(comparison.count(Verdict::not_judged)),
        format_count(comparison.count(Verdict::not_comparable)));
    if (!comparison.missing.empty()) text += fmt::format(" Missing: {}.", format_count(comparison.missing.size()));
    if (!comparison.added.empty()) text += fmt::format(" New: {}.", format_count(comparison.added.size()));
    return text;
}

std::vector<ComparedLine> sorted_lines(const RunComparison& comparison, bool all)
{
    std::vector<ComparedLine> lines;
    for (const auto& series : comparison.series)
        for (const auto& number : series.numbers)
            if (all || number.verdict == Verdict::changed) lines.push_back({&series, &number});
    std::ranges::stable_sort(lines, {}, [](const ComparedLine& line) { return order_of(*line.number); });
    return lines;
}

std::string comparison_table(const RunComparison& comparison, bool all)
{
    std::vector<std::array<std::string, 5>> rows;
    for (const auto& name : comparison.missing) rows.push_back({"missing", name, "", "", ""});
    for (const auto& name : comparison.added) rows.push_back({"new", name, "", "", ""});
    for (const auto& line : sorted_lines(comparison, all)) {
        const auto texts = number_texts(*line.number);
        const auto unit = line.number->unit.empty() ? "" : " " + line.number->unit;
        rows.push_back({verdict_words(*line.number), line.series->name(), line.number->quantity,
                        texts.before + " → " + texts.after + unit, reason_words(*line.number)});
    }
    auto text = in_columns(rows);
    if (!text.empty()) text += "\n";
    for (const auto& remark : comparison.remarks) text += remark + "\n";
    return text + comparison_summary(comparison) + "\n";
}

std::string comparison_json(const RunComparison& comparison)
{
    nlohmann::ordered_json json = {{"format", "poissonlab-diff"},     {"format_version", 1},
                                   {"changed", comparison.changed()}, {"level", comparison_level},
                                   {"remarks", comparison.remarks},   {"missing", comparison.missing},
                                   {"new", comparison.added},         {"numbers", nlohmann::ordered_json::array()}};
    for (const auto& line : sorted_lines(comparison, true)) json["numbers"].push_back(number_json(line));
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}
