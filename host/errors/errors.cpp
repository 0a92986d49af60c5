#include "errors/errors.hpp"

namespace poissonlab {

std::string to_string(const SourceLocation& location)
{
    return location.line > 0 ? location.file + ":" + std::to_string(location.line) : location.file;
}

InputError invalid_value(const SourceLocation& location, const std::string& key, const std::string& value,
                         const std::string& allowed)
{
    return InputError(to_string(location) + ": " + key + " = " + value + ": " + allowed);
}

}
