#include "host/settings/nearest_key.hpp"

#include <algorithm>

namespace poissonlab {

std::size_t edit_distance(std::string_view a, std::string_view b)
{
    // Three rows of the usual table: the one being filled and the two before it.
    std::vector<std::size_t> before_last(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before_last[j - 2] + 1);
        }
        before_last.swap(last);
        last.swap(row);
    }
    return last[b.size()];
}

std::string nearest_key(std::string_view word, const std::vector<std::string>& known)
{
    std::string nearest;
    std::size_t smallest = std::string::npos;
    for (const std::string& candidate : known) {
        const std::size_t distance = edit_distance(word, candidate);
        const std::size_t bearable = std::max<std::size_t>(2, std::max(word.size(), candidate.size()) / 3);
        // A word of which no letter is right was not misspelt.
        if (distance > bearable || distance >= candidate.size() || distance >= smallest) continue;
        smallest = distance;
        nearest = candidate;
    }
    return nearest;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known)
{
    const std::string nearest = nearest_key(word, known);
    return nearest.empty() ? "" : "; did you mean \"" + nearest + "\"?";
}

}
