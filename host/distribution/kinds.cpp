#include "host/distribution/kinds.hpp"

#include <algorithm>

namespace poissonlab {

const std::vector<Kind>& all_kinds()
{
    static const std::vector<Kind> all{warp_kind(),      object_kind(),   self_similar_kind(), rank_kind(),
                                       stippling_kind(), hatching_kind(), icon_kind(),         instance_kind()};
    return all;
}

const Kind* find_kind(const std::string& table, const std::string& word)
{
    const auto& all = all_kinds();
    const auto found =
        std::ranges::find_if(all, [&](const Kind& kind) { return kind.table == table && kind.word == word; });
    return found == all.end() ? nullptr : &*found;
}

}
