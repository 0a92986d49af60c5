// The commands `distribute ...` share these options: a density, the even points that are put on it, a device.
#pragma once

#include "app/commands/command.hpp"
#include "host/config/distributions/distribution_config.hpp"
#include "host/distribution/even_points.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

struct DistributeOptions
{
    std::string command; ///< "distribute warp", for messages
    std::string density; ///< a picture or a formula
    std::string density_from = "light";
    std::uint64_t points = 0;
    std::uint64_t seed = 1;
    std::filesystem::path tiles; ///< a tile set; empty: `method`
    std::string method;          ///< of even points; empty: default_even_method()
    std::filesystem::path out;
    std::string engine = "opencl";
    std::string device;
    bool quiet = false;
};

/// The options for them. `o` must outlive the command.
std::vector<Option> density_options(DistributeOptions& o);
std::vector<Option> even_point_options(DistributeOptions& o);
Option points_option(DistributeOptions& o, const std::string& help); ///< the number alone
std::vector<Option> device_options(DistributeOptions& o);
std::vector<Option> output_options(DistributeOptions& o); ///< the point file, and those of the device

/// One list of several.
std::vector<Option> joined(std::vector<std::vector<Option>> lists);

/// Checks all of the above but the density, and opens no device. Throws InputError, a line with command and option.
void check(const DistributeOptions& o);

/// Parts of that check. Each throws InputError.
void check_engine(const DistributeOptions& o);
void check_points(const DistributeOptions& o);
void check_output(const DistributeOptions& o, const std::filesystem::path& file);

/// Tells users what was taken as 0, on standard error, where there is such a note and they want to hear it.
void say_note(const DistributeOptions& o, const std::string& note);

/// The density, over a square where it is a formula; its note is said.
Density read_density(const DistributeOptions& o);

/// The method that the options name, or the default.
EvenMethod read_even_method(const DistributeOptions& o);

/// The same as the settings of configs have it.
EvenMethodChoice even_method_choice(const DistributeOptions& o);

/// A workplace that shows its steps; the device is opened when it is needed.
DistributionPlace make_place(const DistributeOptions& o);

}
