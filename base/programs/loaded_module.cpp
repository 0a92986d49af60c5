#include "base/programs/loaded_module.hpp"

#include "base/errors/errors.hpp"
#include "base/errors/missing_module.hpp"

#include <dlfcn.h>

#include <system_error>

namespace fs = std::filesystem;

namespace poissonlab {
namespace {

/// The file that this code is in: the program, or a library that holds the laboratory.
fs::path own_file()
{
    Dl_info info{};
    std::error_code error;
    if (::dladdr(reinterpret_cast<const void*>(&function_of_module), &info) != 0 && info.dli_fname) {
        const fs::path file = info.dli_fname;
        if (file.extension() == ".so") return fs::absolute(file, error);
    }
    return fs::read_symlink("/proc/self/exe", error); // a program's name alone may be relative to anything
}

fs::path module_file(const std::string& name)
{
    const std::string file = "lib" + name + ".so";
    const fs::path folder = own_file().parent_path();
    std::error_code error;
    for (const fs::path& place :
         {folder, folder / POISSONLAB_INSTALLED_MODULES, folder / POISSONLAB_MODULES_FROM_PYTHON})
        if (fs::exists(place / file, error)) return place / file;
    return fs::path(POISSONLAB_BUILT_MODULES) / file;
}

}

void* function_of_module(const std::string& name, const char* function, const char* need, bool is_added_by_lab)
{
    const fs::path file = module_file(name);
    std::error_code error;
    if (!fs::exists(file, error)) {
        if (is_added_by_lab) throw MissingModule(name.substr(name.find('_') + 1));
        throw StorageError(std::string(need) + ": there is no " + file.filename().string() + " beside the program");
    }
    void* const module = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* const found = module ? ::dlsym(module, function) : nullptr;
    if (!found) throw StorageError(std::string(need) + ": " + ::dlerror());
    return found;
}

fs::path installed_data_folder() { return (own_file().parent_path() / POISSONLAB_INSTALLED_DATA).lexically_normal(); }

}
