#include "reports/words/texture_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <tuple>

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

const char* edge_part(double lost, double gained)
{
    const bool is_sharp = texture_gate("edge_loss").passes(lost), is_clean = texture_gate("edge_gain").passes(gained);
    if (is_sharp) return is_clean ? "edges kept" : "edges added";
    return is_clean ? "edges blurred" : "edges blurred, others added";
}

/// Returns true if the features of the exemplar are wider than an eighth of a tile. Cuts fuse or break such features,
/// and new patches do not tell: in tiles of 32 pixels, fused pebbles made 0.2 % of new patches.
bool are_features_wide(const DistributionResult& texture)
{
    const double side = std::strtod(texture.parameter("size").c_str(), nullptr); // 0 for textures without tiles
    const std::optional<double> feature = number_in(texture, "feature_side");
    return side > 0 && feature && 8 * *feature > side;
}

std::string capital(std::string text)
{
    if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
}

/// Returns the subjects of the gates whose measure a texture lacks.
std::vector<const char*> unmeasured_in(const DistributionResult& texture)
{
    std::vector<const char*> unmeasured;
    for (const TextureGate& gate : texture_gates())
        if (!number_in(texture, gate.key)) unmeasured.push_back(gate.judged);
    return unmeasured;
}

bool is_judged(const DistributionResult& texture) { return unmeasured_in(texture).size() < texture_gates().size(); }

/// True of a quilted picture, which is no function of the plane.
bool is_finished(const DistributionResult& texture) { return texture.parameter("kind") == "quilted"; }

/// Returns the reason why a texture cannot be taken; it is empty for a texture that passes all gates.
std::string objection_to(const DistributionResult& texture)
{
    std::vector<std::string> faults;
    for (const TextureGate* gate : failed_gates(texture)) faults.emplace_back(gate->fault);
    if (!faults.empty()) return fmt::format("Rejected ({})", fmt::join(faults, ", "));
    const std::vector<const char*> unmeasured = unmeasured_in(texture);
    if (unmeasured.empty()) return "";
    const char* why = number_in(texture, "edge_loss")         ? ""
                      : number_in(texture, "gradient_spread") ? ": an older version compared the edges"
                                                              : ": set compare = true";
    return fmt::format("Passes what was measured ({} not measured{})", fmt::join(unmeasured, " and "), why);
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
    if (const auto lost = number_in(texture, "edge_loss"), gained = number_in(texture, "edge_gain"); lost && gained)
        parts.emplace_back(edge_part(*lost, *gained));
    if (const auto recurs = number_in(texture, "recurrence"))
        parts.push_back(recurrence_part(*recurs, number_in(texture, "recurrence_width")));
    if (const auto novelty = number_in(texture, "novelty"))
        parts.emplace_back(!texture_gate("novelty").passes(*novelty)              ? "shapes fused or broken"
                           : *novelty < most_whole && !are_features_wide(texture) ? "shapes whole"
                                                                                  : "some shapes fused or broken");
    // Seams are judged by sources, and say nothing of what blending made of them.
    const bool is_blended = texture.parameter("smooth") == "true" || texture.parameter("blend") == "true";
    if (!is_blended && number_in(texture, "conspicuous_seams").value_or(0) > most_hidden)
        parts.emplace_back("seams show");
    if (!parts.empty() && is_finished(texture)) parts.emplace_back("a picture, not endless");
    return parts.empty() ? "" : capital(fmt::format("{}.", fmt::join(parts, "; ")));
}

std::vector<std::size_t> judged_order(const std::vector<const DistributionResult*>& textures)
{
    std::vector<std::size_t> order(textures.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) {
        const std::size_t failed = failed_gates(*textures[i]).size();
        return std::tuple(failed, failed == 0 && !unmeasured_in(*textures[i]).empty(),
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
    std::vector<std::string> good, sentences;
    std::vector<std::pair<std::string, std::vector<std::string>>> others; // objections, and the textures that have them
    for (const DistributionResult* texture : textures) {
        if (!is_judged(*texture)) continue;
        const std::string objection = objection_to(*texture);
        const std::string label = label_of_method(*texture);
        const bool is_rejected = !failed_gates(*texture).empty();
        const std::string named = label + (is_finished(*texture) && !is_rejected ? " (not endless)" : "");
        if (objection.empty()) {
            good.push_back(named);
            continue;
        }
        auto group = std::ranges::find(others, objection, &std::pair<std::string, std::vector<std::string>>::first);
        if (group == others.end()) group = others.insert(group, {objection, {}});
        group->second.push_back(named);
    }
    sentences.push_back(good.empty() ? "None of these passes all gates" : "Take: " + good.front());
    if (good.size() > 1)
        sentences.push_back(fmt::format("Good as well: {}", fmt::join(good.begin() + 1, good.end(), "; ")));
    for (const auto& [objection, labels] : others)
        sentences.push_back(fmt::format("{}: {}", objection, fmt::join(labels, "; ")));
    return fmt::format("{}.", fmt::join(sentences, ". "));
}

}
