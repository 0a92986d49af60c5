// The kernel files and the constants that each is built with, in one list: programs are made by it, and a test compiles
// every one of them for other devices.
#pragma once

#include <concepts>
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

struct KernelFile
{
    std::string name; ///< below kernels/
    std::vector<KernelConstant> constants;
};

/// All kernel files. kernel_program.cpp lists them, and must list new ones.
const std::vector<KernelFile>& kernel_files();

/// A kernel file with a value for each of its constants.
struct KernelProgram
{
    std::string file;
    std::string options; ///< for the compiler
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
