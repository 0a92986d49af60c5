// Runs the program as children of a process that has loaded what takes the program half a second to load.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// This is the program as a function, as main calls it.
using ProgramMain = int (*)(int argc, const char* const* argv);

/// A nursery is a process that waits for requests and forks a child for each. It must be made before this process has
/// threads of its own. When a child has loaded the image library or the driver of the device, the nursery loads them as
/// well, and later children have them from the beginning.
class ProgramNursery
{
public:
    /// Throws std::runtime_error where the system has no processes left.
    explicit ProgramNursery(ProgramMain program);
    ~ProgramNursery();
    ProgramNursery(const ProgramNursery&) = delete;
    ProgramNursery& operator=(const ProgramNursery&) = delete;

    /// Runs the program in `folder` with the environment of this process; its output goes to the files "out" and
    /// "error" of `streams`. Returns the status of waitpid().
    int run(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
            const std::filesystem::path& streams);

private:
    int requests_ = -1;
    int nursery_ = -1; ///< the process
};

}
