// Files that are no text although they were meant as such: text of another encoding, and compressed files.
#pragma once

#include <string>
#include <string_view>

namespace poissonlab {

/// Returns the text without what editors of some systems put in front, a byte order mark. Throws InputError, which
/// begins with `name`, for UTF-16 and for files that zip or gzip has packed.
std::string_view plain_text(const std::string& name, std::string_view text);

}
