#include "host/kinds/kind.hpp"

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
    std::vector<std::string> known = others;
    for (const KeySpec& spec : kind.keys()) known.push_back(spec.value.key);
    check_keys(table, known);
    Keys keys(table, where, name);
    return kind.visit(keys);
}

}
