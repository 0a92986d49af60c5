// The values on which a unit of work depends, and the name that follows from them.
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <type_traits>

namespace poissonlab {

/// Lines "name = value": everything that decides the outcome of a unit of work, the version of the code included, and
/// nothing else. Units with equal keys are the same.
class UnitKey
{
public:
    /// `kind` is the first line, for example "realization".
    explicit UnitKey(std::string_view kind);

    /// Appends a line. Line breaks in values are escaped, so that different values stay different.
    UnitKey& add(std::string_view name, std::string_view value);
    UnitKey& add(std::string_view name, std::integral auto value)
    {
        if constexpr (std::is_same_v<decltype(value), bool>)
            return add(name, std::string_view(value ? "yes" : "no"));
        else
            return add(name, std::string_view(std::to_string(value)));
    }

    /// Appends all lines of another key.
    UnitKey& add(const UnitKey& other);

    const std::string& text() const { return text_; }

    /// 32 hexadecimal digits: two XXH64 hashes of the text with different seeds.
    std::string name() const;

private:
    std::string text_;
};

}
