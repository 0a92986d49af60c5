// The interface of every method of making point sets to the rest of the laboratory.
//
// To add a method: write a Sampler, describe it by a SamplerSpec, and list that in a file of host/modules.
// Config keys, checks, defaults, help, series names and the report follow from the description.
#pragma once

#include "base/geometry/point_set.hpp"
#include "base/word_table.hpp"
#include "host/device/device_memory.hpp"
#include "host/sampling/parameters.hpp"
#include "results/records/archive.hpp"
#include "results/records/sample_records.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

// The traits of a sampler's sets beside their points are one value, so that a method that makes its sets from another's
// hands on all of it. A trait more is a member here, the method that sets it, and who asks for it.

struct SetTraits
{
    /// Realizations differ in size by the nature of the method (saturation), rather than by mistake.
    bool sizes_vary = false;

    /// Sets are windows of the plane: what lies beside the right border is not what lies at the left one.
    bool is_window = false;

    /// The first points of a set are a set of their own, however many they are.
    bool is_progressive = false;

    /// The number of tiles along each axis of which sets are made; 0: they are not made of tiles.
    std::uint32_t tiles_along_axis = 0;

    /// The number of tile sets that realizations take in turn, realization k set k % tile_sets.
    std::uint32_t tile_sets = 1;

    /// The tile set of methods that tile.
    std::optional<TileSetRecord> tile_set = {};

    /// Makes the bytes of the Poisson disk (sphere) tile set's binary file, docs/tile-set-file.md, where sets are
    /// tilings with one: others can use it. Empty elsewhere; to be called while the sampler lives.
    std::function<std::string()> tile_set_file = {};

    /// The iterations of the last set; empty for methods without any.
    std::vector<IterationRecord> iterations = {};

    /// The relative radius that the last set is proven to have at least, where that is known without looking at it.
    std::optional<double> proven_relative_radius = {};

    /// Seconds spent on what all sets have in common, such as a tile set, without building kernels.
    double preparation_seconds = 0;

    /// The seconds that the last set took where it was made side by side with others: its share of their time, without
    /// building kernels. Nothing: those of its sample().
    std::optional<double> shared_seconds = {};

    /// All but times and files is stored with a set.
    template <class Archive>
    void serialize(Archive& archive)
    {
        archive(sizes_vary, is_window, is_progressive, tiles_along_axis, tile_sets, tile_set, iterations,
                proven_relative_radius);
    }
};

class Device;
struct DeviceInfo;
class FramedRegion;

/// Which of the two twins does the work.
enum class Engine
{
    opencl,
    reference
};
inline constexpr WordTable<Engine, 2> engines{{{{Engine::opencl, "opencl"}, {Engine::reference, "reference"}}}};

/// The properties that the experiment asks of each point set of a series.
struct SampleRequest
{
    std::size_t points = 0; ///< target size; methods that cannot hit it exactly come as near as they can
    int dimension = 2;      ///< 2 or 3
    std::uint64_t seed = 0;
    /// Told of the steps of what takes long before the first set; what it throws ends that. May be empty.
    std::function<void(const std::string& what)> on_step = {};
    /// The region that points lie in, in its own units. Null: they are in the unit square.
    std::shared_ptr<const FramedRegion> region = nullptr;
};

/// The law by which a sampler's device memory grows with the number of points N of a set.
enum class MemoryGrowth
{
    none,    ///< it takes none
    fixed,   ///< as large for every N
    limited, ///< in proportion to N up to a limit: larger sets are made in pieces
    linear,  ///< in proportion to N
};

/// The words of help and documentation.
inline constexpr WordTable<MemoryGrowth, 4> memory_growths{{{{MemoryGrowth::none, "no device memory"},
                                                             {MemoryGrowth::fixed, "fixed device memory"},
                                                             {MemoryGrowth::limited, "device memory ~ N, limited"},
                                                             {MemoryGrowth::linear, "device memory ~ N"}}}};

/// Makes the point sets of one series.
class Sampler
{
public:
    virtual ~Sampler() = default;

    /// The point set of a realization: the same bytes for the same request and realization, always.
    virtual PointSet sample(std::uint32_t realization) = 0;

    /// Is told that so many realizations will be asked for one after the other, from `first` on: methods that make
    /// several side by side do so then. Sets are the same with and without it.
    virtual void expect([[maybe_unused]] std::uint32_t first, [[maybe_unused]] std::uint32_t count) {}

    /// The traits of its sets, and of the last one, once there is one.
    virtual SetTraits traits() const { return {}; }

    /// Seconds spent on building kernels so far, to be kept apart from the time of sampling.
    virtual double build_seconds() const { return 0; }
};

/// Gives the OpenCL device, opened at the first call. Throws DeviceError when there is none.
using DeviceProvider = std::function<Device&()>;

/// A sampler's description: all that the config, the help and the report need to know of it.
struct SamplerSpec
{
    std::string name;    ///< the word in the config
    std::string title;   ///< the name in reports, for example "Dart throwing"
    std::string summary; ///< one line for the help
    std::vector<int> dimensions;
    std::vector<ParameterSpec> parameters;

    /// The label of series to which the user gives none; empty: the title and all parameters.
    std::function<std::string(const Parameters&)> label;

    /// True when all realizations are the same set: its spectrum is then one periodogram, not an estimate.
    bool deterministic = false;

    /// True when all realizations are the same set, where that depends on parameters; empty: `deterministic` says it.
    std::function<bool(const Parameters&)> is_deterministic;

    /// True when realizations differ only where the sets of its start do: with a deterministic start this
    /// method is deterministic as well.
    bool follows_start = false;

    /// True when its sets are there already, with as many points as they have (files): no number can be
    /// asked.
    bool has_own_points = false;

    /// Checks what single values cannot show (missing keys, impossible combinations). Throws InputError.
    /// `where` is the place of the [[method]] table, or of the parameter that has the sampler as its value.
    /// Samplers among the parameters have passed their own checks before.
    std::function<void(const Parameters&, const SampleRequest&, const SourceLocation& where)> check;

    /// Returns sentences that users must know before work begins, such as those on what was left out of files. An empty
    /// function stands for none. It is called after `check` has passed.
    std::function<std::vector<std::string>(const Parameters&, const SampleRequest&)> notes;

    /// The reason why its sets cannot be had on this machine, where the user has said that series are left out then;
    /// nothing: they can. Empty: they always can. Asked before work begins.
    std::function<std::optional<std::string>(const Parameters&)> absence;

    /// A hash of what decides its sets beside its parameters, such as the contents of files; empty: nothing does.
    std::function<std::uint64_t(const Parameters&)> outside_input;

    /// The number of realizations, if the method decides it (files); empty: as many as are asked for.
    std::function<std::size_t(const Parameters&)> available_realizations;

    /// The most memory that its sampler takes on a device of this kind, at a time, with that of its start; at most
    /// 1.3 times what it really takes. Empty: none.
    std::function<DeviceMemory(const Parameters&, const SampleRequest&, const DeviceInfo&)> device_memory;

    /// The growth of device_memory with the number of points, without what the start takes; a test compares the two.
    MemoryGrowth memory_growth = MemoryGrowth::none;

    /// The files of kernels that make its sets on a device, without those of its start; empty: none does.
    std::vector<std::string> kernels = {};

    /// These files make its sets in 3D as well.
    std::vector<std::string> kernels_in_space = {};

    /// The number of points that a set may have, where that is not the number that is asked for (as near as chance
    /// lets it be said). Empty: that number.
    std::function<std::size_t(const Parameters&, const SampleRequest&)> most_points;

    std::function<std::unique_ptr<Sampler>(const Parameters&, const SampleRequest&, Engine, const DeviceProvider&)>
        create;

    /// The module that this program lacks and that alone knows the sampler, of which name, title and summary are all
    /// that is there; empty: it is all there.
    std::string absent_module = {};
};

/// Samplers in the order in which help and errors list them.
using SamplerRegistry = std::vector<SamplerSpec>;

}
