#include "base/images/float_image.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfCompression.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/openexr.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <system_error>

namespace poissonlab {
namespace {

constexpr int max_size = 1 << 15; // a larger picture is a damaged header

/// Bytes of pixels for each byte of the file, at most: what deflate, the best of the usual ones, makes of zeros.
constexpr double largest_ratio = 1032;

/// Reads by OpenEXRCore, which compares what a header claims with the size of the file before it takes memory for it.
/// Imf::InputFile does not, with setMaxImageSize() either: it takes gigabytes for a text that says it has them, and
/// reads on behind a list of channels that has no end.
class ExrReader
{
public:
    explicit ExrReader(const std::filesystem::path& path)
    {
        std::error_code error;
        size_ = std::filesystem::file_size(path, error); // an error for what is no file: a pipe would not open
        if (error) throw std::runtime_error("cannot be read: " + error.message());
        exr_context_initializer_t settings = EXR_DEFAULT_CONTEXT_INITIALIZER;
        settings.max_image_width = settings.max_image_height = max_size;
        settings.user_data = &said_;
        settings.error_handler_fn = [](exr_const_context_t file, exr_result_t, const char* message) {
            void* said = nullptr;
            exr_get_user_data(file, &said);
            if (said && static_cast<std::string*>(said)->empty()) *static_cast<std::string*>(said) = message;
        };
        const exr_result_t result = exr_start_read(&file_, path.c_str(), &settings);
        // Attributes that OpenEXR could do without do not stop it; a file with a wrong one is damaged all the same.
        if (result != EXR_ERR_SUCCESS || !said_.empty()) {
            exr_finish(&file_);
            fail(result);
        }
    }
    ExrReader(const ExrReader&) = delete;
    ExrReader& operator=(const ExrReader&) = delete;
    ~ExrReader() { exr_finish(&file_); }

    FloatImage read()
    {
        check_kind();
        FloatImage image = without_pixels();
        const auto width = static_cast<std::size_t>(image.width);
        for (auto& [name, pixels] : image.channels) pixels.resize(width * static_cast<std::size_t>(image.height));
        std::int32_t lines = 0;
        check(exr_get_scanlines_per_chunk(file_, 0, &lines));
        for (int row = 0; row < image.height; row += lines) read_chunk(image, row);
        return image;
    }

private:
    [[noreturn]] void fail(exr_result_t result) const
    {
        throw std::runtime_error(said_.empty() ? exr_get_default_error_message(result)
                                               : printable(shortened(said_, 200)));
    }

    void check(exr_result_t result) const
    {
        if (result != EXR_ERR_SUCCESS) fail(result);
    }

    void check_kind() const
    {
        int parts = 0;
        exr_storage_t storage{};
        check(exr_get_count(file_, &parts));
        check(exr_get_storage(file_, 0, &storage));
        if (parts != 1 || storage != EXR_STORAGE_SCANLINE)
            throw std::runtime_error("has tiles, deep pixels or several parts");
    }

    /// The image that the header describes; its channels are still empty.
    FloatImage without_pixels() const
    {
        FloatImage image;
        exr_attr_box2i_t window{};
        check(exr_get_data_window(file_, 0, &window));
        image.width = window.max.x - window.min.x + 1;
        image.height = window.max.y - window.min.y + 1;
        const exr_attr_chlist_t* channels = nullptr;
        check(exr_get_channels(file_, 0, &channels));
        check_pixels(image, *channels);
        if (window.min.x != 0 || window.min.y != 0 || image.width != image.height)
            throw std::runtime_error("it must be a square with its corner at (0, 0)");
        for (int i = 0; i < channels->num_channels; ++i) {
            const exr_attr_chlist_entry_t& channel = channels->entries[i];
            if (channel.pixel_type == EXR_PIXEL_FLOAT && channel.x_sampling == 1 && channel.y_sampling == 1)
                image.channels[channel.name.str];
        }
        std::int32_t count = 0;
        check(exr_get_attribute_count(file_, 0, &count));
        for (std::int32_t i = 0; i < count; ++i) {
            const exr_attribute_t* attribute = nullptr;
            check(exr_get_attribute_by_index(file_, 0, EXR_ATTR_LIST_FILE_ORDER, i, &attribute));
            if (attribute->type == EXR_ATTR_STRING)
                image.texts[attribute->name] = {attribute->string->str,
                                                static_cast<std::size_t>(attribute->string->length)};
        }
        return image;
    }

    /// Sees that the file is long enough for its pixels.
    void check_pixels(const FloatImage& image, const exr_attr_chlist_t& channels) const
    {
        double bytes = 0; // of a pixel
        for (int i = 0; i < channels.num_channels; ++i) {
            const exr_attr_chlist_entry_t& channel = channels.entries[i];
            bytes += (channel.pixel_type == EXR_PIXEL_HALF ? 2.0 : 4.0) / std::max(1, channel.x_sampling) /
                     std::max(1, channel.y_sampling);
        }
        exr_compression_t compression{};
        check(exr_get_compression(file_, 0, &compression));
        const double ratio = compression == EXR_COMPRESSION_NONE ? 1 : largest_ratio;
        if (bytes * image.width * image.height > static_cast<double>(size_) * ratio)
            throw std::runtime_error("its " + std::to_string(size_) + " bytes are too few for its " +
                                     std::to_string(image.width) + " x " + std::to_string(image.height) + " pixels");
    }

    /// The rows from this one on that the file stores together.
    void read_chunk(FloatImage& image, int row) const
    {
        exr_chunk_info_t chunk{};
        check(exr_read_scanline_chunk_info(file_, 0, row, &chunk));
        exr_decode_pipeline_t decoder = EXR_DECODE_PIPELINE_INITIALIZER;
        exr_result_t result = exr_decoding_initialize(file_, 0, &chunk, &decoder);
        for (int i = 0; i < decoder.channel_count; ++i) {
            exr_coding_channel_info_t& channel = decoder.channels[i];
            const auto wanted = image.channels.find(channel.channel_name);
            if (wanted == image.channels.end()) continue;
            float* const pixels = wanted->second.data() + static_cast<std::size_t>(row) * image.width;
            channel.decode_to_ptr = reinterpret_cast<std::uint8_t*>(pixels);
            channel.user_pixel_stride = sizeof(float);
            channel.user_line_stride = static_cast<std::int32_t>(sizeof(float)) * image.width;
        }
        if (result == EXR_ERR_SUCCESS) result = exr_decoding_choose_default_routines(file_, 0, &decoder);
        if (result == EXR_ERR_SUCCESS) result = exr_decoding_run(file_, 0, &decoder);
        exr_decoding_destroy(file_, &decoder);
        check(result);
    }

    exr_context_t file_ = nullptr;
    std::uintmax_t size_ = 0; ///< in bytes
    std::string said_;        ///< by OpenEXR, first of all
};

}

const std::string& FloatImage::text(const std::string& name) const
{
    const auto found = texts.find(name);
    if (found == texts.end()) throw std::runtime_error("the attribute " + name + " is missing");
    return found->second;
}

void write_float_image(const std::filesystem::path& path, const FloatImage& image)
{
    write_whole_file(path, [&](const std::filesystem::path& temporary) {
        try {
            Imf::Header header(image.width, image.height);
            header.compression() = Imf::NO_COMPRESSION;
            for (const auto& [name, text] : image.texts) header.insert(name, Imf::StringAttribute(text));
            Imf::FrameBuffer frame;
            for (const auto& [name, pixels] : image.channels) {
                header.channels().insert(name, Imf::Channel(Imf::FLOAT));
                char* const bytes = reinterpret_cast<char*>(const_cast<float*>(pixels.data())); // which it only reads
                frame.insert(name, Imf::Slice(Imf::FLOAT, bytes, sizeof(float),
                                              sizeof(float) * static_cast<std::size_t>(image.width)));
            }
            Imf::OutputFile file(temporary.c_str(), header);
            file.setFrameBuffer(frame);
            file.writePixels(image.height);
        } catch (const std::exception& error) {
            throw StorageError(path.string() + ": cannot be written: " + error.what());
        }
    });
}

FloatImage read_float_image(const std::filesystem::path& path) { return ExrReader(path).read(); }

}
