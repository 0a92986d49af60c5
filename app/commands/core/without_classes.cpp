// This function stands in for points with classes where a program lacks them: `analyze --classes` asks for the module.
#include "app/commands/class_series.hpp"
#include "base/errors/missing_module.hpp"

namespace poissonlab {

void add_class_series(Experiment& /*experiment*/, const std::string& /*keys*/) { throw MissingModule("classes"); }

}
