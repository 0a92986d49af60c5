// Which pictures of a report are there already, drawn by this program from the same input: these are not drawn again.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace poissonlab {

/// The pictures of one report's folder. Their keys, hashes of input and program, are kept in a file there, so that what
/// is drawn depends on contents only and never on times. All members may be called by several threads.
class PictureStore
{
public:
    /// `list` is the file of keys, which may be missing or damaged: then everything is drawn.
    PictureStore(std::filesystem::path folder, std::filesystem::path list);

    /// True if all files are there and were drawn from that input.
    bool is_current(const std::vector<std::filesystem::path>& files, std::string_view input) const;

    /// Takes a note that the files have been drawn from that input.
    void note(const std::vector<std::filesystem::path>& files, std::string_view input);

    /// Calls draw(), which writes the files, unless they are current.
    template <class Draw>
    void draw_once(const std::vector<std::filesystem::path>& files, std::string_view input, const Draw& draw)
    {
        if (!is_current(files, input)) draw();
        note(files, input);
    }

    /// Writes the keys of the pictures that were noted. Throws StorageError.
    void save() const;

private:
    std::string name_of(const std::filesystem::path& file) const;

    std::filesystem::path folder_;
    std::filesystem::path list_;
    std::string program_;                      ///< a hash of this program; empty where it cannot be read
    std::map<std::string, std::string> known_; ///< by a picture's path in the folder
    std::map<std::string, std::string> noted_;
    mutable std::mutex mutex_;
};

}
