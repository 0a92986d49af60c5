#include "reports/pages/gallery_words.hpp"

#include "reports/pages/ranking_order.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

namespace poissonlab {

std::optional<MeasuredValue> value_in_gallery(const GalleryMethod& method, const Measure& measure)
{
    const auto found = method.measures.find(measure.key);
    if (found == method.measures.end()) return std::nullopt;
    return MeasuredValue{found->second.value, found->second.standard_error};
}

std::string better_in_gallery(const Measure& measure, const Series& series, int dimension,
                              const std::vector<const GalleryMethod*>& gallery)
{
    const auto own = measure.get(series);
    if (measure.better == Better::neither || !own) return "";
    const auto is_better = [&](double a, double b) { return measure.better == Better::higher ? a > b : a < b; };
    std::size_t compared = 0, better = 0;
    const GalleryMethod* best = nullptr;
    MeasuredValue best_value;
    for (const GalleryMethod* method : gallery) {
        const auto value = value_in_gallery(*method, measure);
        if (!value) continue;
        ++compared;
        if (!is_better(value->value, own->value) || is_as_good(measure, *own, *value)) continue;
        ++better;
        if (best && !is_better(value->value, best_value.value)) continue;
        best = method;
        best_value = *value;
    }
    if (compared == 0) return "";
    const std::string title = in_dimension(measure.title(), dimension);
    if (better == 0) return fmt::format("{}: none of {} methods is better.", title, compared);
    return fmt::format("{}: {} of {} methods {} better, the best is {} ({}).", title, better, compared,
                       better == 1 ? "is" : "are", best->label, words_of(measure, best_value).shown);
}

}
