// The bytes of a file that need not fit in memory: the system reads what is looked at.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

namespace poissonlab {

class MappedFile
{
public:
    /// Throws InputError for what is no file that can be read.
    explicit MappedFile(const std::filesystem::path& path);
    ~MappedFile();
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;

    std::string_view bytes() const { return bytes_; }

    /// The memory of the bytes before this place may serve others; they are read again when they are looked at again.
    void release_before(const char* place);

private:
    std::string_view bytes_;
    std::size_t released_ = 0;
};

}
