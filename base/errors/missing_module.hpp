// Work that a module does which this program was built without.
#pragma once

#include <stdexcept>
#include <string>

namespace poissonlab {

/// Thrown where a word names what only a module knows that is not built. `module` is its name; "all": the work needs
/// every module.
class MissingModule : public std::runtime_error
{
public:
    explicit MissingModule(std::string module)
        : std::runtime_error(
              "this program was built without " +
              (module == "all" ? "some of its modules" : "the module \"" + module + "\"") +
              ": build it with cmake -D POISSONLAB_MODULES=all, or call ./lab, which adds what is missing"),
          module_(std::move(module))
    {}

    const std::string& module() const { return module_; }

private:
    std::string module_;
};

}
