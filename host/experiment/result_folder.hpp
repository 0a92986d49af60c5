// The output folder while it comes into being: results are complete and in place, or the folder is as it was.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// Collects an experiment's files in a hidden folder inside the output folder, and moves them into place at
/// the end.
///
/// Until publish() a previous result in the same folder stays as it is. Without publish() the destructor
/// removes what was written, and the folders that were created.
class ResultFolder
{
public:
    /// Creates `out` where it is missing. `series` are the folders that will be published. Throws InputError
    /// when `out` is a file or a collection, or has a folder of such a name that is not a series, StorageError when it cannot
    /// be written.
    ResultFolder(const std::filesystem::path& out, const std::vector<std::string>& series);
    ~ResultFolder();

    /// Throws what the constructor throws of the InputErrors, and changes nothing.
    static void check(const std::filesystem::path& out, const std::vector<std::string>& series);

    ResultFolder(const ResultFolder&) = delete;
    ResultFolder& operator=(const ResultFolder&) = delete;

    /// Where a series' files are to be written until publish(); created.
    std::filesystem::path series_folder(const std::string& name) const;

    /// Puts everything in place: the series folders, results.json last. Removes the previous result, its
    /// report included. Throws StorageError.
    void publish(const std::string& results_json);

private:
    void create_folders();
    void remove_staging() noexcept;

    std::filesystem::path out_;
    std::filesystem::path staging_;
    std::vector<std::string> series_;
    std::vector<std::string> previous_;          ///< series of the result that is there
    std::vector<std::filesystem::path> created_; ///< folders that were missing, outermost first
    bool published_ = false;
};

}
