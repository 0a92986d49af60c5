#include "app/commands/option_words.hpp"

#include <type_traits>

namespace poissonlab {

std::string value_word(const Option& option)
{
    if (!option.name.starts_with('-')) return "";
    if (!option.value_name.empty()) return option.value_name;
    return std::visit(
        [](const auto* value) -> std::string {
            using Value = std::remove_cvref_t<decltype(*value)>;
            if constexpr (std::is_same_v<Value, bool>) return "";
            if constexpr (std::is_arithmetic_v<Value>) return "NUMBER";
            return "TEXT";
        },
        option.target);
}

}
