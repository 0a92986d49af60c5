#include "host/device/kernel_source.hpp"

#include <set>
#include <stdexcept>

namespace poissonlab {
namespace {

constexpr std::string_view include_directive = "#include \"";

void append(std::string& out, std::string_view name, std::set<std::string, std::less<>>& done)
{
    const std::string_view text = embedded_kernel_file(name);
    if (text.empty()) throw std::logic_error("no embedded file " + std::string(name));
    done.emplace(name);

    const auto mark = [&](std::size_t line) {
        out += "#line " + std::to_string(line) + " \"" + std::string(name) + "\"\n";
    };
    mark(1);
    std::size_t line_number = 0;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = text.substr(begin, end - begin);
        begin = end + 1;
        ++line_number;
        if (!line.starts_with(include_directive)) {
            if (line != "#pragma once") out.append(line); // every file is there once
            out.push_back('\n');
            continue;
        }
        const std::string_view rest = line.substr(include_directive.size());
        const std::string_view included = rest.substr(0, rest.find('"'));
        if (!done.contains(included)) append(out, included, done);
        mark(line_number + 1);
    }
}

}

std::string kernel_source(std::string_view name)
{
    std::string out;
    std::set<std::string, std::less<>> done;
    append(out, name, done);
    return out;
}

}
