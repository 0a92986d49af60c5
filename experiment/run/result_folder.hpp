// The output folder while it comes into being: results are complete and in place, or the folder is as it was.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace poissonlab {

/// Collects an experiment's files in a hidden folder inside the output folder, and moves them into place at
/// the end. One process at a time.
///
/// Until publish() a previous result in the same folder stays as it is. Without publish() the destructor
/// removes what was written.
class ResultFolder
{
public:
    /// Creates `out` where it is missing, and removes what processes that were killed left unfinished there. `series`
    /// are the folders that will be published. Throws InputError when `out` is a file or a collection, or has a folder
    /// of such a name that is not a series, StorageError when it cannot be written.
    ResultFolder(const std::filesystem::path& out, const std::vector<std::string>& series);
    ~ResultFolder();

    /// Throws what the constructor throws of the InputErrors, and changes nothing.
    static void check(const std::filesystem::path& out, const std::vector<std::string>& series);

    ResultFolder(const ResultFolder&) = delete;
    ResultFolder& operator=(const ResultFolder&) = delete;

    /// Adds a series with its files, by their names there: as further links to the same files where the file system can
    /// do that, else as copies. Throws StorageError.
    void add(const std::string& series, const std::map<std::string, std::filesystem::path>& files) const;

    /// Puts everything in place: the series folders, results.json last. Removes the previous result, its
    /// report included. Throws StorageError.
    void publish(const std::string& results_json);

private:
    void create_folders();
    void remove_staging() noexcept;

    std::filesystem::path out_;
    std::filesystem::path staging_;
    std::vector<std::string> series_;
    std::vector<std::string> previous_; ///< series of the result that is there
};

}
