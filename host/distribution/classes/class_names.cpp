#include "host/distribution/classes/class_names.hpp"

#include "base/errors/errors.hpp"
#include "base/files/text_lines.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

namespace poissonlab {
namespace {

/// Numbers come before words, in rising order; `nan` is a word.
bool comes_before(const std::string& a, const std::string& b)
{
    double x = 0, y = 0;
    const bool is_a = parse_number(a, x) && !std::isnan(x), is_b = parse_number(b, y) && !std::isnan(y);
    if (is_a && is_b && x != y) return x < y;
    return is_a != is_b ? is_a : a < b;
}

}

ClassNumbers number_classes(const std::vector<std::string>& class_of_point, const std::string& file)
{
    std::map<std::string, std::uint8_t, bool (*)(const std::string&, const std::string&)> numbers(comes_before);
    for (std::size_t i = 0; i < class_of_point.size(); ++i) {
        if (class_of_point[i].empty()) throw InputError(fmt::format("{}: point {} has no class", file, i + 1));
        if (!numbers.try_emplace(class_of_point[i]).second) continue;
        if (printable(class_of_point[i]) != class_of_point[i])
            throw InputError(fmt::format("{}: point {} has the class {}: names of classes must be printable UTF-8",
                                         file, i + 1, printable(shortened(class_of_point[i], 40))));
        if (numbers.size() > most_measured_classes)
            throw InputError(
                fmt::format("{}: has more than {} classes: {} and others; classes are words or numbers that "
                            "many points share",
                            file, most_measured_classes, printable(shortened(class_of_point[i], 40))));
    }
    if (numbers.size() == 1)
        throw InputError(fmt::format("{}: all points have the class {}; there must be two classes or more", file,
                                     printable(shortened(numbers.begin()->first, 40))));
    ClassNumbers made;
    for (auto& [name, number] : numbers) {
        number = static_cast<std::uint8_t>(made.second.size());
        made.second.push_back(name);
    }
    for (const std::string& name : class_of_point) made.first.push_back(numbers.at(name));
    return made;
}

}
