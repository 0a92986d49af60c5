// What the program says to those who call it without a command.
#pragma once

namespace poissonlab {

/// Ten things that people do, a line each, and where the others are.
extern const char* const opening_words;

}
