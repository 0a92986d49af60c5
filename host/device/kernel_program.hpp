// The kernel files, what each needs of a device and the constants that it is built with, in one list: programs are made
// by it, and a test compiles every one of them for other devices.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace poissonlab {

/// A constant of a kernel file.
struct KernelConstant
{
    std::string name;
    std::vector<std::string> values; ///< that the host gives it, all of them or, where `has_more`, some
    bool has_more = false;
};

/// All that kernels need of a device beyond OpenCL 1.2 with little-endian 64-bit integers. None uses images, printf,
/// sub-groups or 64-bit atomics, which tests look for.
struct KernelNeeds
{
    bool double_precision = false;
    std::uint64_t local_bytes = 0; ///< of a work-group, whatever its size; at most

    bool operator==(const KernelNeeds&) const = default;

    /// Adds the needs of kernels that run before or after these.
    KernelNeeds& operator|=(const KernelNeeds& other);
};

struct KernelFile
{
    std::string name; ///< below kernels/
    std::string work; ///< what it is for, as users call it: a method or a command
    KernelNeeds needs;
    std::vector<KernelConstant> constants;
};

/// All kernel files. kernel_program.cpp lists them, and must list new ones.
const std::vector<KernelFile>& kernel_files();

/// The needs of these files together. Throws std::logic_error where one is not listed.
KernelNeeds needs_of(const std::vector<std::string>& files);

/// The needs of all files together.
KernelNeeds all_kernel_needs();

/// A kernel file with a value for each of its constants.
struct KernelProgram
{
    std::string file;
    std::string work;    ///< what it is for, as users call it
    std::string options; ///< for the compiler
    KernelNeeds needs;
};

/// The value that a constant is given.
struct KernelValue
{
    KernelValue(std::string name_, std::string value_) : name(std::move(name_)), value(std::move(value_)) {}
    KernelValue(std::string name_, std::integral auto value_) : KernelValue(std::move(name_), std::to_string(value_)) {}

    std::string name;
    std::string value;
};

/// Throws std::logic_error where kernel_files() lists the file with other constants, in another order, or without one
/// of these values.
KernelProgram kernel_program(const std::string& file, const std::vector<KernelValue>& values);

}
