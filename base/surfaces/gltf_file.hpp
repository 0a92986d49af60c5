// Files of glTF 2.0, https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html: what they describe, and their buffers.
#pragma once

#include "base/files/stored_object.hpp"
#include "base/surfaces/polygon_soup.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace poissonlab {

/// The description of a file, and the bytes of its buffers, which are in it, beside it, or in its text.
class GltfFile
{
public:
    /// Throws InputError: for what is no glTF 2.0, and for extensions that it requires and that are not known here.
    /// `file` must live as long.
    explicit GltfFile(const MeshBytes& file);
    GltfFile(const GltfFile&) = delete;
    GltfFile& operator=(const GltfFile&) = delete;

    const StoredObject& root() const { return *root_; }

    /// A sentence for each extension that the file uses, does not require, and that is not known here, and for morph
    /// targets and skins.
    std::vector<std::string> notes() const;

    /// A list of objects of the file; empty where there is none.
    std::vector<StoredObject> list(const std::string& name) const;

    /// The bytes of the buffer that a buffer view names.
    std::string_view buffer(const StoredObject& view);

private:
    void split_binary(std::string_view bytes);
    void check_version() const;
    void check_extensions() const;
    std::string content_of(std::size_t index) const;
    [[noreturn]] void fail(const std::string& problem) const;

    const std::filesystem::path file_;
    std::string_view description_, binary_; ///< the parts of .glb
    nlohmann::json json_;
    std::optional<StoredObject> root_;
    std::vector<StoredObject> buffers_;
    std::vector<std::optional<std::string>> contents_; ///< of buffers that were read
};

/// A whole number of at least 0 that may be left out.
std::size_t count_or(const StoredObject& object, const std::string& member, std::size_t otherwise);

/// One of a list, whose number is a member of an object. Throws InputError where it is not there.
const StoredObject& named_in(const std::vector<StoredObject>& list, const StoredObject& object,
                             const std::string& member);

/// The place of a file that a .gltf file names, in which characters such as blanks may be written as %20.
std::filesystem::path file_of_uri(const std::filesystem::path& beside, std::string_view uri);

}
