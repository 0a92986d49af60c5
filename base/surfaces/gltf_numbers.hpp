// The numbers of a file of glTF: accessors, which lie in views of buffers.
#pragma once

#include "base/surfaces/gltf_file.hpp"

namespace poissonlab {

class GltfNumbers
{
public:
    explicit GltfNumbers(GltfFile& file);

    /// The numbers of the accessor that a member of an object names, row after row; whole ones that are normalized
    /// become fractions. `type` is what it must have, such as "VEC3", of `width` numbers a row.
    std::vector<double> read(const StoredObject& object, const std::string& member, const std::string& type,
                             std::size_t width);

    /// Returns the number of components of the accessor that a member names: 2 to 4 for VEC2 to VEC4, else 1.
    std::size_t width(const StoredObject& object, const std::string& member) const;

private:
    struct Rows;

    /// Returns the rows of numbers at a place; `form` is the object that says their type.
    Rows rows_at(const StoredObject& place, const StoredObject& form, std::size_t count, std::size_t width);
    void put_sparse(const StoredObject& accessor, std::size_t width, std::vector<double>& values);

    GltfFile& file_;
    std::vector<StoredObject> accessors_, views_;
};

}
