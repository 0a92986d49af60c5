#include "base/files/mapped_file.hpp"

#include "base/errors/errors.hpp"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace poissonlab {

MappedFile::MappedFile(const std::filesystem::path& path)
{
    const auto fail = [&](int error) {
        throw InputError::at({path.string()}, std::string("cannot be read: ") + std::strerror(error));
    };
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) fail(errno);
    struct stat info
    {
    };
    const bool is_file = ::fstat(file, &info) == 0 && S_ISREG(info.st_mode);
    if (!is_file) {
        ::close(file);
        throw InputError::at({path.string()}, "is not a file");
    }
    const auto size = static_cast<std::size_t>(info.st_size);
    void* const begin = size > 0 ? ::mmap(nullptr, size, PROT_READ, MAP_SHARED, file, 0) : nullptr;
    const int error = errno;
    ::close(file);
    if (begin == MAP_FAILED) fail(error);
    bytes_ = {static_cast<const char*>(begin), size};
    if (size > 0) ::madvise(begin, size, MADV_SEQUENTIAL);
}

MappedFile::~MappedFile()
{
    if (!bytes_.empty()) ::munmap(const_cast<char*>(bytes_.data()), bytes_.size());
}

void MappedFile::release_before(const char* place)
{
    constexpr std::size_t page = std::size_t{1} << 16; // a multiple of any
    const std::size_t end = static_cast<std::size_t>(place - bytes_.data()) / page * page;
    if (end <= released_) return;
    ::madvise(const_cast<char*>(bytes_.data()) + released_, end - released_, MADV_DONTNEED);
    released_ = end;
}

}
