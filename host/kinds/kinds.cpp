#include "host/kinds/kinds.hpp"

#include "base/errors/missing_module.hpp"

#include <algorithm>

namespace poissonlab {
const Kind* find_kind(const std::string& table, const std::string& word)
{
    const auto& all = all_kinds();
    const auto found =
        std::ranges::find_if(all, [&](const Kind& kind) { return kind.table == table && kind.word == word; });
    if (found == all.end()) return nullptr;
    if (!found->absent_module.empty()) throw MissingModule(found->absent_module);
    return &*found;
}

std::vector<std::string> kind_words(const std::string& table)
{
    std::vector<std::string> words;
    for (const Kind& kind : all_kinds())
        if (kind.table == table) words.push_back(kind.word);
    return words;
}

}
