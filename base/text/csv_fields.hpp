// Lines of CSV whose fields may be texts, as RFC 4180 has them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace poissonlab {

/// `text` as a field in quotes, whose own quotes are doubled. Control characters become blanks: a field is one line.
std::string csv_quoted(std::string_view text);

/// The fields of a line without its end, taken out of their quotes. Nothing where a quote stays open, or where a field
/// goes on behind its closing quote.
std::optional<std::vector<std::string>> csv_fields(std::string_view line, char separator = ',');

}
