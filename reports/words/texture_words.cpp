#include "reports/words/texture_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <numeric>

namespace poissonlab {
namespace {

std::optional<double> number_in(const DistributionResult& texture, std::string_view key)
{
    const auto found = std::ranges::find(texture.numbers, key, &DistributionNumber::key);
    return found == texture.numbers.end() ? std::nullopt : std::optional(found->value);
}

/// Sentences say that nothing recurs below the first limit, and call shapes whole below the second one, a share of
/// new patches. Seams show above the third limit, twice the share of conspicuous steps in an exemplar. A texture whose
/// recurrence reaches the last limit repeats.
constexpr double least_recurrence = 0.01, most_whole = 0.05, most_hidden = 0.1, repeated_altogether = 0.5;

std::string recurrence_part(double recurs, const std::optional<double>& width)
{
    if (recurs < least_recurrence) return "nothing recurs";
    const char* const verb = texture_gate("recurrence").passes(recurs) ? "recurs faintly"
                             : recurs < repeated_altogether            ? "recurs"
                                                                       : "repeats";
    return width ? fmt::format("{} every {:.0f} pixels", verb, *width) : verb;
}

std::string capital(std::string text)
{
    if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
}

bool is_judged(const DistributionResult& texture)
{
    return std::ranges::any_of(texture_gates(),
                               [&](const TextureGate& gate) { return number_in(texture, gate.key).has_value(); });
}

/// True of a quilted picture, which is no function of the plane.
bool is_finished(const DistributionResult& texture) { return texture.parameter("kind") == "quilted"; }

std::vector<std::string> faults_of(const DistributionResult& texture)
{
    std::vector<std::string> faults;
    for (const TextureGate* gate : failed_gates(texture)) faults.emplace_back(gate->fault);
    return faults;
}

}

std::vector<const TextureGate*> failed_gates(const DistributionResult& texture)
{
    std::vector<const TextureGate*> failed;
    for (const TextureGate& gate : texture_gates())
        if (const auto value = number_in(texture, gate.key); value && !gate.passes(*value)) failed.push_back(&gate);
    return failed;
}

std::string texture_sentence(const DistributionResult& texture)
{
    std::vector<std::string> parts;
    if (const auto edges = number_in(texture, "gradient_spread"))
        parts.emplace_back(texture_gate("gradient_spread").passes(*edges) ? "edges kept" : "edges blurred");
    if (const auto recurs = number_in(texture, "recurrence"))
        parts.push_back(recurrence_part(*recurs, number_in(texture, "recurrence_width")));
    if (const auto novelty = number_in(texture, "novelty"))
        parts.emplace_back(*novelty < most_whole                      ? "shapes whole"
                           : texture_gate("novelty").passes(*novelty) ? "some shapes fused or broken"
                                                                      : "shapes fused or broken");
    if (number_in(texture, "conspicuous_seams").value_or(0) > most_hidden) parts.emplace_back("seams show");
    if (!parts.empty() && is_finished(texture)) parts.emplace_back("a picture, not endless");
    return parts.empty() ? "" : capital(fmt::format("{}.", fmt::join(parts, "; ")));
}

std::vector<std::size_t> judged_order(const std::vector<const DistributionResult*>& textures)
{
    std::vector<std::size_t> order(textures.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) {
        return std::pair(failed_gates(*textures[i]).size(),
                         number_in(*textures[i], "novelty").value_or(std::numeric_limits<double>::infinity()));
    });
    return order;
}

std::string label_of_method(const DistributionResult& texture)
{
    const std::string begin = texture.parameter("exemplar") + ": ";
    const auto is_same = [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); };
    const std::string& label = texture.label;
    if (label.size() <= begin.size() || !std::equal(begin.begin(), begin.end(), label.begin(), is_same)) return label;
    return capital(label.substr(begin.size()));
}

std::string textures_verdict(const std::vector<const DistributionResult*>& textures)
{
    if (std::ranges::none_of(textures, [](const auto* texture) { return is_judged(*texture); })) return "";
    std::vector<std::string> good;
    std::vector<std::pair<std::string, std::vector<std::string>>> others; // faults, and the textures that have them
    for (const DistributionResult* texture : textures) {
        const std::string faults = fmt::format("{}", fmt::join(faults_of(*texture), ", "));
        if (faults.empty()) {
            if (is_judged(*texture))
                good.push_back(label_of_method(*texture) + (is_finished(*texture) ? " (not endless)" : ""));
            continue;
        }
        auto group = std::ranges::find(others, faults, &std::pair<std::string, std::vector<std::string>>::first);
        if (group == others.end()) group = others.insert(group, {faults, {}});
        group->second.push_back(label_of_method(*texture));
    }
    std::string words = good.empty() ? "None of these passes" : "Take: " + good.front();
    if (good.size() > 1) words += fmt::format(". Good as well: {}", fmt::join(good.begin() + 1, good.end(), "; "));
    for (const auto& [faults, labels] : others)
        words += fmt::format(". Rejected ({}): {}", faults, fmt::join(labels, "; "));
    return words + ".";
}

}
