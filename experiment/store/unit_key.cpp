#include "experiment/store/unit_key.hpp"

#include "base/files/xxh64_bytes.hpp"

#include <fmt/format.h>

namespace poissonlab {

UnitKey::UnitKey(std::string_view kind) { add("unit", kind); }

UnitKey& UnitKey::add(std::string_view name, std::string_view value)
{
    text_.append(name).append(" = ");
    for (const char c : value) {
        if (c == '\n')
            text_ += "\\n";
        else if (c == '\\')
            text_ += "\\\\";
        else
            text_ += c;
    }
    text_ += '\n';
    return *this;
}

UnitKey& UnitKey::add(const UnitKey& other)
{
    text_ += other.text_;
    return *this;
}

std::string UnitKey::name() const
{
    constexpr std::uint64_t second_seed = 0x9e3779b97f4a7c15; // any other than the first
    return fmt::format("{:016x}{:016x}", xxh64_bytes(text_), xxh64_bytes(text_, second_seed));
}

}
