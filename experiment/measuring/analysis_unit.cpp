#include "experiment/measuring/analysis_unit.hpp"

#include "analysis/spectra/spectrum_file.hpp"
#include "base/errors/errors.hpp"
#include "base/files/byte_archive.hpp"
#include "base/files/json_members.hpp"
#include "base/files/whole_file.hpp"
#include "base/images/square_image.hpp"
#include "base/programs/side_by_side.hpp"
#include "results/curve_tables.hpp"
#include "results/file_names.hpp"

#include <chrono>
#include <utility>

namespace poissonlab {
namespace {

constexpr const char* part_file = "part";

/// Writes the spectrum, its volume and its radial curve, and measures it. Returns the names of the files.
std::vector<std::string> write_spectrum_files(SeriesAnalysis& series, UnitStore& store, const UnitKey& key,
                                              const std::map<std::string, std::string>& metadata)
{
    std::vector<std::string> files = {file_names::spectrum, file_names::radial};
    const Spectrum spectrum = series.mean_spectrum();
    // Sizes that nobody asked for are of sets of many points, and eighths of powers of two: so are their means.
    const bool has_means =
        spectrum.dimension == 2 && !series.options().keep_spectrum && series.options().spectrum_size == 0;
    const int block = has_means ? block_for(spectrum.size, largest_stored_spectrum) : 1;
    write_spectrum(store.file(key, file_names::spectrum), block > 1 ? block_means(spectrum, block) : spectrum,
                   metadata);
    if (series.options().volume) {
        write_spectrum_volume(store.file(key, file_names::spectrum_volume), spectrum, metadata);
        files.emplace_back(file_names::spectrum_volume);
    }
    write_whole_file(store.file(key, file_names::radial), radial_csv(series.radial_curve(spectrum)));
    series.measure_spectrum(spectrum);
    return files;
}

}

void store_part(const SeriesAnalysis& part, UnitStore& store, const UnitKey& key)
{
    write_whole_file(store.file(key, part_file), to_bytes(part));
    store.store(key, {}, {part_file});
}

bool load_part(SeriesAnalysis& part, const UnitStore& store, const UnitKey& key)
{
    const auto unit = store.find(key);
    if (!unit) return false;
    std::string bytes;
    try {
        bytes = read_whole_file(unit->files.at(part_file));
    } catch (const InputError&) {
        return false;
    }
    from_bytes(bytes, part);
    return true;
}

void store_analysis(SeriesAnalysis& series, UnitStore& store, const UnitKey& key,
                    const std::map<std::string, std::string>& metadata, const std::string& iterations)
{
    const auto begin = std::chrono::steady_clock::now();
    std::vector<std::string> files;
    const auto write_text = [&](const char* name, const std::string& text) {
        write_whole_file(store.file(key, name), text);
        files.emplace_back(name);
    };
    do_side_by_side(
        [&] {
            if (series.has_spectrum()) files = write_spectrum_files(series, store, key, metadata);
        },
        [&] { series.measure_first(); });
    if (const auto pairs = series.pair_correlation(); !pairs.empty())
        write_text(file_names::pair_correlation, pair_correlation_csv(pairs));
    if (const auto variance = series.number_variance(); !variance.empty())
        write_text(file_names::number_variance, number_variance_csv(variance));
    if (const auto curves = series.region_curves(); !curves.empty())
        write_text(file_names::region_curves, region_curves_csv(curves));
    if (!series.region_picture().empty()) write_text(file_names::region_picture, series.region_picture());
    if (const auto folded = series.folded_density()) {
        write_square_image(store.file(key, file_names::folded_density), *folded, metadata);
        files.emplace_back(file_names::folded_density);
    }
    if (!iterations.empty()) write_text(file_names::iterations, iterations);

    Series result = series.result();
    if (series.has_spectrum()) result.spectrum_file = file_names::spectrum;
    if (series.options().zone_plate) {
        write_square_image(store.file(key, file_names::zone_plate), series.zone_plate().first_image(), metadata);
        files.emplace_back(file_names::zone_plate);
        write_text(file_names::zone_plate_error, zone_plate_csv(series.zone_plate().curve()));
    }
    result.analysis_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    store.store(key, json_text([&](JsonMembers& m) { members(m, std::as_const(result)); }), files);
}

std::optional<StoredAnalysis> stored_analysis(const UnitStore& store, const UnitKey& key)
{
    const auto unit = store.find(key);
    if (!unit) return std::nullopt;
    StoredAnalysis analysis;
    read_unplaced(unit->record, "stored analysis", [&](JsonMembers& m) { members(m, analysis.result); });
    analysis.files = unit->files;
    return analysis;
}

}
