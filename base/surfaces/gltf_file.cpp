#include "base/surfaces/gltf_file.hpp"

#include "base/files/byte_order.hpp"
#include "base/files/json_file.hpp"
#include "base/files/whole_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace poissonlab {
namespace {

constexpr std::string_view glb_magic = "glTF";
constexpr std::size_t bytes_of_glb_head = 12, bytes_of_chunk_head = 8;

/// Extensions that say nothing of places, or only what is read.
bool is_known_extension(std::string_view name)
{
    constexpr std::array<std::string_view, 6> beginnings{"KHR_materials_", "KHR_texture_", "EXT_texture_",
                                                         "MSFT_texture_",  "KHR_lights_",  "KHR_xmp"};
    return name == "KHR_mesh_quantization" ||
           std::ranges::any_of(beginnings, [&](std::string_view b) { return name.starts_with(b); });
}

std::uint32_t word_at(std::string_view bytes, std::size_t at)
{
    return load<std::uint32_t>(bytes.substr(at), std::endian::little);
}

/// The bytes of base64; nothing where a character is of no such text.
std::optional<std::string> bytes_of_base64(std::string_view text)
{
    while (text.ends_with('=')) text.remove_suffix(1);
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3 + 3);
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        const std::size_t digit = digits.find(c);
        if (digit == digits.npos) return std::nullopt;
        bits = bits << 6 | static_cast<std::uint32_t>(digit);
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes += static_cast<char>(bits >> count & 0xff);
    }
    return bytes;
}

}

GltfFile::GltfFile(const MeshBytes& file) : file_(file.name), description_(file.bytes)
{
    if (file.bytes.starts_with(glb_magic)) split_binary(file.bytes);
    json_ = parsed_json(description_, file.name);
    root_.emplace(json_, file_);
    check_version();
    check_extensions();
    buffers_ = list("buffers");
    contents_.resize(buffers_.size());
}

void GltfFile::split_binary(std::string_view bytes)
{
    if (bytes.size() < bytes_of_glb_head + bytes_of_chunk_head) fail("ends within its head");
    if (const std::uint32_t version = word_at(bytes, 4); version != 2)
        fail(fmt::format("is a file of glTF {}: only version 2 is read", version));
    if (const std::uint32_t size = word_at(bytes, 8); size != bytes.size())
        fail(fmt::format("has {} bytes, and {} by its head", bytes.size(), size));
    std::size_t chunk = 0;
    for (std::size_t at = bytes_of_glb_head; at < bytes.size(); ++chunk) {
        if (bytes.size() - at < bytes_of_chunk_head) fail(fmt::format("ends within the head of chunk {}", chunk));
        const std::size_t size = word_at(bytes, at);
        const std::string_view kind = bytes.substr(at + 4, 4);
        at += bytes_of_chunk_head;
        if (size > bytes.size() - at)
            fail(fmt::format("ends within chunk {}, which has {} bytes by its head", chunk, size));
        const std::string_view content = bytes.substr(at, size);
        if (chunk == 0 && kind != "JSON") fail("its first chunk must be JSON");
        if (chunk == 0) description_ = content;
        if (chunk == 1 && kind == std::string_view("BIN\0", 4)) binary_ = content;
        at += size;
    }
}

void GltfFile::check_version() const
{
    const StoredObject asset = root_->object("asset");
    if (const std::string version = asset.text("version"); !version.starts_with("2."))
        throw asset.error("version", "only glTF 2 is read");
    if (asset.has("minVersion") && asset.text("minVersion") != "2.0")
        throw asset.error("minVersion", "only glTF 2.0 is read");
}

void GltfFile::check_extensions() const
{
    if (!root_->has("extensionsRequired")) return;
    for (const std::string& name : root_->texts("extensionsRequired"))
        if (!is_known_extension(name))
            fail(fmt::format("extensionsRequired: {} is not known here, and without it the file cannot be read right: "
                             "store it without this extension",
                             shortened(name)));
}

std::vector<std::string> GltfFile::notes() const
{
    std::vector<std::string> notes;
    if (root_->has("extensionsUsed")) notes = root_->texts("extensionsUsed");
    std::erase_if(notes, [](const std::string& name) { return is_known_extension(name); });
    for (std::string& name : notes)
        name = "the extension " + shortened(printable(name)) + " of the file is not known here and was left out";
    const std::string without = " of the file were left out: the mesh has the shape without them";
    const auto is_morphed = [](const StoredObject& mesh) {
        return mesh.has("primitives") && std::ranges::any_of(mesh.objects("primitives"), [](const StoredObject& part) {
                   return part.has("targets");
               });
    };
    if (std::ranges::any_of(list("meshes"), is_morphed)) notes.push_back("morph targets" + without);
    if (!list("skins").empty()) notes.push_back("skins" + without);
    return notes;
}

std::vector<StoredObject> GltfFile::list(const std::string& name) const
{
    return root_->has(name) ? root_->objects(name) : std::vector<StoredObject>{};
}

std::string_view GltfFile::buffer(const StoredObject& view)
{
    const StoredObject& buffer = named_in(buffers_, view, "buffer");
    const auto index = static_cast<std::size_t>(&buffer - buffers_.data());
    const auto size = static_cast<std::size_t>(buffer.integer("byteLength", 0));
    const bool is_inside = !buffer.has("uri");
    if (is_inside && (index != 0 || binary_.data() == nullptr))
        throw buffer.error("uri", "is missing, and the file has no numbers of this buffer");
    if (!is_inside && !contents_[index]) contents_[index] = content_of(index);
    const std::string_view bytes = is_inside ? binary_ : std::string_view(*contents_[index]);
    if (bytes.size() < size) throw buffer.error("byteLength", fmt::format("there are {} bytes", bytes.size()));
    return bytes.substr(0, size);
}

std::string GltfFile::content_of(std::size_t index) const
{
    const StoredObject& buffer = buffers_[index];
    const std::string uri = buffer.text("uri");
    if (uri.starts_with("data:")) {
        const std::size_t comma = uri.find(',');
        auto bytes = uri.substr(0, comma).ends_with(";base64")
                         ? bytes_of_base64(std::string_view(uri).substr(std::min(comma, uri.size() - 1) + 1))
                         : std::nullopt;
        if (!bytes) throw buffer.error("uri", "must be base64 after `data:...;base64,`");
        return *std::move(bytes);
    }
    const std::filesystem::path file = file_of_uri(file_, uri);
    if (is_no_lasting_file(file) || !std::filesystem::is_regular_file(file))
        throw buffer.error("uri", fmt::format("{} must be a file that is there", file.string()));
    return read_whole_file(file);
}

void GltfFile::fail(const std::string& problem) const { throw InputError::at({file_.string()}, problem); }

std::size_t count_or(const StoredObject& object, const std::string& member, std::size_t otherwise)
{
    return object.has(member) ? static_cast<std::size_t>(object.integer(member, 0)) : otherwise;
}

const StoredObject& named_in(const std::vector<StoredObject>& list, const StoredObject& object,
                             const std::string& member)
{
    const auto index = static_cast<std::size_t>(object.integer(member, 0));
    if (index >= list.size()) throw object.error(member, fmt::format("is not there: there are {}", list.size()));
    return list[index];
}

std::filesystem::path file_of_uri(const std::filesystem::path& beside, std::string_view uri)
{
    std::string name;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        unsigned char byte = 0;
        const char* const digits = uri.data() + i + 1;
        if (uri[i] == '%' && i + 2 < uri.size() && std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
            name += static_cast<char>(byte);
            i += 2;
        } else {
            name += uri[i];
        }
    }
    return beside.parent_path() / name;
}

}
