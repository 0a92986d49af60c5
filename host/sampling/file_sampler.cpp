#include "host/sampling/file_sampler.hpp"

#include "analysis/regions/framed_region.hpp"
#include "base/files/file_glob.hpp"
#include "base/files/whole_file.hpp"
#include "base/files/xxh64_bytes.hpp"
#include "base/points/point_file.hpp"
#include "base/regions/region_source.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <set>
#include <stdexcept>

namespace poissonlab {

namespace {

constexpr const char* path_key = "path";
constexpr const char* particles_key = "particles";

/// Messages about files call the keys by these words.
constexpr PointOptions key_words{.domain = "a line `# domain {}:{}` before the points of a text",
                                 .region = "region = \"rectangle {} {} {} {}\"",
                                 .crs = "crs = \"EPSG:4326\"",
                                 .particles = "particles = {}"};

InputError path_error(const Parameters& parameters, const std::string& path, const std::string& allowed)
{
    return invalid_value(parameters.location(path_key), path_key, fmt::format("\"{}\"", path), allowed);
}

/// The files that one entry of `path` stands for: at least one.
std::vector<std::filesystem::path> resolve(const Parameters& parameters, const std::string& entry)
{
    const std::filesystem::path folder = std::filesystem::path(parameters.location(path_key).file).parent_path();

    std::vector<std::filesystem::path> files = named_files(folder, entry);
    if (files.empty()) throw path_error(parameters, entry, no_such_file(folder, entry));
    return files;
}

/// All files in the order of their realizations. A set that counts twice would make an average look better
/// than it is, so a file that is named twice is an error.
std::vector<std::filesystem::path> files_of(const Parameters& parameters)
{
    std::vector<std::filesystem::path> files;
    std::set<std::filesystem::path> seen;
    for (const std::string& entry : parameters.texts(path_key)) {
        for (std::filesystem::path& file : resolve(parameters, entry)) {
            if (is_no_lasting_file(file)) // read by the check, by the key of the series, and for the points
                throw path_error(parameters, entry, file.string() + " is a pipe or a device; a file is needed");
            if (!seen.insert(std::filesystem::weakly_canonical(file)).second) {
                throw path_error(parameters, entry, file.string() + " is named twice");
            }
            files.push_back(std::move(file));
        }
    }
    return without_further_parts(files, {});
}

PointReading reading_of(const Parameters& parameters, std::optional<PointDomain> domain)
{
    PointReading how{.domain = domain, .options = key_words};
    if (parameters.is_given(particles_key)) how.particles = static_cast<int>(parameters.integer(particles_key));
    return how;
}

std::string size_in_words(const std::filesystem::path& file, const PointSet& points)
{
    return fmt::format("{} has {} {}D points", file.string(), points.size(), points.dimension);
}

using Told = std::function<void(const std::string& sentence)>;

/// The sets of a file: in the unit square, or in a region, in its units.
std::vector<PointSet> sets_of(const std::filesystem::path& file, const Parameters& parameters,
                              const FramedRegion* region, const Told& told)
{
    PointReading how = reading_of(parameters, {});
    if (region) {
        how.domain = any_coordinates;
        how.degrees_sentence = degrees_sentence(region->own_polygons());
    }
    how.told = told;
    std::vector<PointSet> sets = read_points(file, how);
    if (!region) return sets;
    for (const PointSet& points : sets) region->framed(points, file.string()); // throws where some are outside
    return sets;
}

/// Reads every realization. Throws InputError where they do not have the same size and dimension.
std::vector<PointSet> read_realizations(const Parameters& parameters, const FramedRegion* region, const Told& told = {})
{
    std::vector<PointSet> realizations;
    std::filesystem::path first_file;
    for (const std::filesystem::path& file : files_of(parameters)) {
        if (realizations.empty()) first_file = file;
        for (PointSet& points : sets_of(file, parameters, region, told)) {
            realizations.push_back(std::move(points));
            const PointSet& first = realizations.front();
            const PointSet& last = realizations.back();
            if (first.size() == last.size() && first.dimension == last.dimension) continue;
            throw path_error(parameters, to_string(ParameterValue(parameters.texts(path_key))),
                             fmt::format("all realizations must be of one size, but {}, and {} (realization {})",
                                         size_in_words(first_file, first), size_in_words(file, last),
                                         realizations.size()));
        }
    }
    return realizations;
}

void check_file(const Parameters& parameters, const SampleRequest& request, const SourceLocation& where)
{
    if (!parameters.is_given(path_key) || parameters.texts(path_key).empty()) {
        throw InputError::at(where, "path: must be given: a file, a glob, or a list of these");
    }
    const std::vector<PointSet> realizations = read_realizations(parameters, request.region.get());
    if (realizations.front().dimension != request.dimension) {
        throw path_error(parameters, to_string(ParameterValue(parameters.texts(path_key))),
                         fmt::format("holds {}D points; the experiment has dimension = {}",
                                     realizations.front().dimension, request.dimension));
    }
}

class FileSampler : public Sampler
{
public:
    explicit FileSampler(std::vector<PointSet> realizations) : realizations_(std::move(realizations)) {}

    PointSet sample(std::uint32_t realization) override
    {
        if (realization >= realizations_.size()) throw std::logic_error("more realizations asked than files hold");
        return realizations_[realization];
    }

private:
    std::vector<PointSet> realizations_;
};

}

SamplerSpec file_sampler()
{
    SamplerSpec spec;
    spec.name = "file";
    spec.title = "File";
    spec.summary = "point sets from text, CSV, PLY, NumPy or HDF5 files";
    spec.dimensions = {2, 3};
    spec.parameters = {{.key = path_key,
                        .kind = ParameterSpec::Kind::paths,
                        .help = "point files: names and globs, relative to the folder of the config"},
                       {.key = particles_key,
                        .kind = ParameterSpec::Kind::integer,
                        .help = "the type of a snapshot's particles that are the points: 0 for PartType0",
                        .minimum = 0,
                        .maximum = 6,
                        .unless_given = "its only type"}};
    spec.has_own_points = true;
    spec.check = check_file;
    spec.notes = [](const Parameters& parameters, const SampleRequest& request) {
        std::vector<std::string> notes;
        read_realizations(parameters, request.region.get(),
                          [&](const std::string& sentence) { notes.push_back(sentence); });
        return notes;
    };
    spec.available_realizations = [](const Parameters& parameters) {
        std::size_t count = 0;
        for (const auto& file : files_of(parameters))
            count += read_points(file, reading_of(parameters, any_coordinates)).size();
        return count;
    };
    spec.outside_input = [](const Parameters& parameters) {
        Xxh64 hash;
        for (const std::filesystem::path& file : files_of(parameters))
            for (const std::filesystem::path& part : files_of_points(file)) {
                const std::string content = read_whole_file(part);
                hash.add(fmt::format("{} ", content.size()));
                hash.add(content);
            }
        return hash.value();
    };
    spec.create = [](const Parameters& parameters, const SampleRequest& request, Engine, const DeviceProvider&) {
        return std::make_unique<FileSampler>(read_realizations(parameters, request.region.get()));
    };
    return spec;
}

}
