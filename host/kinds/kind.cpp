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
    check_described_keys(table, kind.visit, others);
    Keys keys(table, where, name);
    return kind.visit(keys);
}

}
