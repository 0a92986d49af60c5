#include "host/kinds/kind.hpp"

#include <algorithm>
#include <iterator>

namespace poissonlab {

std::vector<KeySpec> Kind::keys() const
{
    Keys described;
    visit(described);
    return described.described();
}

KindSettings read_kind(const Kind& kind, const ConfigTable& table, const SourceLocation& where, const std::string& name,
                       const std::vector<std::string>& others)
{
    Keys described, keys(table, where, name);
    kind.visit(described);
    std::vector<std::string> known = others;
    std::ranges::move(described.names(), std::back_inserter(known));
    check_keys(table, known);
    return kind.visit(keys);
}

}
