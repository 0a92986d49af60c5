#include "experiment/run/result_folder.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "experiment/config/plan.hpp"
#include "results/file_names.hpp"
#include "results/own_files.hpp"

#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace poissonlab {
namespace {

constexpr const char* staging_prefix = ".unfinished-";

void require(const std::error_code& error, const std::string& doing)
{
    if (error) throw StorageError("cannot " + doing + ": " + error.message());
}

void move(const fs::path& from, const fs::path& to)
{
    std::error_code error;
    fs::rename(from, to, error);
    require(error, "move " + from.string() + " to " + to.string());
}

/// The series that the results.json of a folder lists; none when there is no readable one.
std::vector<std::string> series_in(const fs::path& folder)
{
    std::vector<std::string> names;
    try {
        const auto json = nlohmann::json::parse(read_whole_file(folder / file_names::results));
        if (json.at("format") != "poissonlab-results") return {};
        for (const char* member : {"series", "tilings", "constructions", "distributions", "schemes"})
            for (const auto& series : json.value(member, nlohmann::json::array())) {
                const std::string name = series.at("name");
                // A name that leads elsewhere is not one that this program wrote.
                if (safe_name(name) == name) names.push_back(name);
            }
    } catch (const nlohmann::json::exception&) {
        return {};
    } catch (const InputError&) {
        return {};
    }
    return names;
}

/// True for a folder that may be replaced although no results.json lists it: it is empty, or a run that was killed
/// left it.
bool looks_like_series(const fs::path& folder)
{
    std::error_code error;
    return fs::is_directory(folder, error) &&
           (fs::is_empty(folder, error) || fs::exists(folder / file_names::realization(0), error) ||
            fs::exists(folder / file_names::tiles, error) || fs::exists(folder / file_names::construction, error) ||
            fs::exists(folder / file_names::distribution_numbers, error));
}

}

void ResultFolder::check(const fs::path& out, const std::vector<std::string>& series)
{
    std::error_code error;
    check_output_folder(out);
    if (fs::exists(out / file_names::collection, error))
        throw InputError("--out " + out.string() + ": is the folder of a collection; choose another folder");
    check_own_files(out);
    const std::vector<std::string> previous = series_in(out);
    for (const std::string& name : series) {
        const fs::path target = out / name;
        const bool known = std::ranges::find(previous, name) != previous.end();
        if (!known && fs::exists(target, error) && !looks_like_series(target))
            throw InputError("--out " + out.string() + ": has \"" + name +
                             "\", which is not a result of poissonlab; choose another folder");
    }
}

ResultFolder::ResultFolder(const fs::path& out, const std::vector<std::string>& series) : out_(out), series_(series)
{
    check(out, series);
    previous_ = series_in(out_);
    try {
        create_folders();
    } catch (...) {
        remove_staging();
        throw;
    }
}

ResultFolder::~ResultFolder() { remove_staging(); }

void ResultFolder::create_folders()
{
    std::error_code error;
    fs::create_directories(out_, error);
    require(error, "create the folder " + out_.string());
    for (const fs::directory_entry& entry : fs::directory_iterator(out_, error))
        if (entry.path().filename().string().starts_with(staging_prefix)) fs::remove_all(entry.path(), error);
    const fs::path staging = out_ / (staging_prefix + std::to_string(getpid()));
    fs::create_directory(staging, error);
    require(error, "write to the folder " + out_.string());
    staging_ = staging;
}

void ResultFolder::remove_staging() noexcept
{
    std::error_code error;
    if (!staging_.empty()) fs::remove_all(staging_, error);
}

void ResultFolder::add(const std::string& series, const std::map<std::string, fs::path>& files) const
{
    std::error_code error;
    const fs::path folder = staging_ / series;
    fs::create_directory(folder, error);
    require(error, "create the folder " + folder.string());
    for (const auto& [name, file] : files) {
        fs::create_hard_link(file, folder / name, error);
        if (error) fs::copy_file(file, folder / name, fs::copy_options::overwrite_existing, error);
        require(error, "write " + (out_ / series / name).string());
    }
}

void ResultFolder::publish(const std::string& results_json)
{
    write_whole_file(staging_ / file_names::results, results_json);
    const fs::path old = staging_ / ".previous";
    std::error_code error;
    fs::create_directory(old, error);
    require(error, "create the folder " + old.string());

    // The rest only renames. results.json goes first and comes last, so that a folder with a results.json is complete
    // at any moment.
    std::vector<std::string> leaving = {file_names::results, own_pages.front()};
    leaving.insert(leaving.end(), previous_.begin(), previous_.end());
    leaving.insert(leaving.end(), series_.begin(), series_.end());
    for (const std::string& name : leaving)
        if (fs::exists(fs::symlink_status(out_ / name, error))) move(out_ / name, old / name);
    for (const std::string& name : series_) move(staging_ / name, out_ / name);
    move(staging_ / file_names::results, out_ / file_names::results);
    remove_staging();
}

}
