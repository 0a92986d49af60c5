// The plan: a config's methods expanded to series, each with its name, label and parameters.
#pragma once

#include "experiment/config/config.hpp"
#include "host/device/device.hpp"
#include "results/method_grid.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// One method with one choice of its parameters.
struct SeriesPlan
{
    std::string name;     ///< the series' folder, unique in the plan: letters, digits, '.', '_', '-'
    std::string label;    ///< for the report
    SourceLocation where; ///< of its [[method]]
    const SamplerSpec* sampler = nullptr;
    std::shared_ptr<const SamplerSpec> ordered; ///< that sampler, where the config asks for another order of its sets
    Parameters parameters;
    SampleRequest request;
    std::optional<RegionOptions> region; ///< that its sets lie in; nothing: the unit square
    bool deterministic = false;          ///< all realizations are one set
    std::uint32_t realizations = 0;      ///< as asked; 1 for deterministic series; what there is for files
    std::optional<GridPlace> place;      ///< none: not of a method of a config
};

/// Every method's series in order; of lists, the last parameter varies fastest. Throws InputError for
/// combinations that the sampler refuses, for two series that would be the same, and for more than 1,000
/// series.
std::vector<SeriesPlan> make_plan(const Config& config);

/// The grid of every method, in the order of the config.
std::vector<MethodGrid> method_grids(const Config& config);

/// Text as (part of) a folder name: what is not a letter, digit, '.', '_' or '-' becomes '-'; never empty,
/// never starting with a dot.
std::string safe_name(const std::string& text);

/// The folder of a series that is named after its label: never one of the output folder's own files and folders.
std::string series_folder_name(const std::string& label);

// The check, before work starts, that the device has memory for a plan.

/// Throws InputError for the first series that does not fit on the device: which one, what it needs, what the device
/// has, and how many points would fit. Point sets that come from files and programs may turn out larger than was asked
/// for: their size is checked when they are there.
void check_device_memory(const std::vector<SeriesPlan>& plan, const DeviceInfo& device);

}
