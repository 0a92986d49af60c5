// A JSON object that knows its place, so that every complaint names the file and the member.
#pragma once

#include "base/errors/errors.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// A view of one object inside a parsed file; the parsed file must outlive it.
///
/// Getters throw InputError, `file: member = value: must be ...`, when the member is missing or of another kind.
class StoredObject
{
public:
    /// `member` is the object's own place, for example "series[2].spectrum"; empty for the whole file.
    StoredObject(const nlohmann::json& value, std::filesystem::path file, std::string member = {});

    /// An object about results that have no names yet, and whose files are elsewhere: neither are checked. `title`
    /// stands in messages for the file.
    static StoredObject unplaced(const nlohmann::json& value, const std::string& title);

    /// True for such an object and those in it.
    bool is_unplaced() const { return is_unplaced_; }

    /// All integers up to here are doubles as well: 2^53.
    static constexpr std::int64_t largest_integer = std::int64_t{1} << 53;

    /// True when the member is there and not null.
    bool has(const std::string& name) const;

    std::string text(const std::string& name) const;
    bool boolean(const std::string& name) const;
    double number(const std::string& name) const;
    std::int64_t integer(const std::string& name, std::int64_t minimum, std::int64_t maximum = largest_integer) const;
    /// A list of integers of 64 bits.
    std::vector<std::int64_t> integers(const std::string& name) const;
    /// A list of integers of at least 0.
    std::vector<std::size_t> counts(const std::string& name) const;
    std::vector<double> numbers(const std::string& name) const;
    std::vector<std::string> texts(const std::string& name) const;
    StoredObject object(const std::string& name) const;
    std::vector<StoredObject> objects(const std::string& name) const;

    /// A scalar or list as it would be typed, strings without quotes; a sampler with its parameters as
    /// "dart-throwing (relative_radius = 0.7)".
    std::string shown(const std::string& name) const;
    /// A member of any kind as JSON.
    std::string json(const std::string& name) const;
    std::vector<std::string> names() const;

    /// A text that is the name of a folder: what is made of the results goes into one that is called so.
    std::string folder_name(const std::string& name) const;

    /// A file name inside the result folder: relative, without "..". `names` of the files that must be there.
    std::string file_name(const std::string& name) const;
    std::vector<std::string> file_names(const std::string& name) const;

    /// The InputError for a member of this object; shows the value where that is a single one.
    InputError error(const std::string& name, const std::string& problem) const;

private:
    const nlohmann::json& at(const std::string& name) const;
    std::string place_of(const std::string& name) const;
    StoredObject inner(const nlohmann::json& value, std::string member) const;
    std::string checked_file_name(const std::string& name, const std::string& value) const;

    const nlohmann::json* value_;
    std::filesystem::path file_;
    std::string member_;
    bool is_unplaced_ = false;
};

}
