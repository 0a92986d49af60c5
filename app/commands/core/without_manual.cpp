// These functions stand in for descriptions of all samplers and kinds where a program lacks modules: it has the texts
// as they are stored, and asks for all modules otherwise.
#include "app/commands/core/stored_text.hpp"
#include "base/errors/missing_module.hpp"

namespace poissonlab {

std::string all_samplers_json() { throw MissingModule("all"); }

std::string all_samplers_markdown() { throw MissingModule("all"); }

std::string all_samplers_text() { return std::string(stored_text("samplers.txt")); }

std::string all_kinds_json() { throw MissingModule("all"); }

std::string all_kinds_markdown() { throw MissingModule("all"); }

std::string all_kinds_text() { return std::string(stored_text("kinds.txt")); }

}
