// Drawings as PNG: Cairo paints a band of rows at a time.
// Polygons may share edges, where Cairo's own smoothing, which blends one over the other, would leave seams. So where
// there are some, every shape is sampled in 4 x 4 places a pixel: a sample takes the colour of the last shape that it
// lies in, and pixels are the mean of their samples. Elsewhere Cairo smoothes, which is faster. Both take means of sRGB
// bytes, which makes the edges of black shapes on white darker than they are: where tones matter, pixels are the mean
// of the light of their samples.
#include "reports/drawings/drawing.hpp"

#include "base/errors/errors.hpp"
#include "base/images/srgb_light.hpp"

#include <fmt/format.h>

#include <cairo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <new>
#include <numbers>

namespace poissonlab {
namespace {

constexpr int band_rows = 64;        // of samples
constexpr int widest_surface = 8000; // pixels: Cairo's images end at 32,767 samples

/// Cairo's coordinates end at some 8 million samples.
constexpr double far_outside = 4e6;

using CairoSurface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

CairoSurface surface_of(int width, int height)
{
    CairoSurface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height), &cairo_surface_destroy);
    if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS) throw std::bad_alloc();
    return surface;
}

/// A row of pixels 0x00rrggbb.
std::uint32_t* row_of(cairo_surface_t* surface, int row)
{
    const std::ptrdiff_t offset = std::ptrdiff_t{row} * cairo_image_surface_get_stride(surface);
    return reinterpret_cast<std::uint32_t*>(cairo_image_surface_get_data(surface) + offset);
}

CairoSurface surface_of(const PngPixels& pixels)
{
    CairoSurface surface = surface_of(pixels.width, pixels.height);
    for (int row = 0; row < pixels.height; ++row)
        for (int column = 0; column < pixels.width; ++column) {
            std::uint32_t color = 0;
            for (int channel = 0; channel < 3; ++channel)
                color = color << 8 | pixels.values[pixels.at(column, row, std::min(channel, pixels.channels - 1))];
            row_of(surface.get(), row)[column] = color;
        }
    cairo_surface_mark_dirty(surface.get());
    return surface;
}

/// Sets a row of pixels to the means of samples, rounded, halves up; `row` is the first row of these. The number of
/// samples is known to the compiler, as this is done for every sample of every picture.
template <int samples>
void write_means(cairo_surface_t* surface, int row, std::uint8_t* pixel, int columns, int channels)
{
    constexpr std::uint32_t count = samples * samples, half = count / 2;
    std::array<const std::uint32_t*, samples> rows{};
    for (int y = 0; y < samples; ++y) rows[static_cast<std::size_t>(y)] = row_of(surface, row + y);
    for (int x = 0; x < columns; ++x, pixel += channels) {
        std::uint32_t red_and_blue = half << 16 | half, green = half; // 16 bits are enough for each sum
        for (const std::uint32_t* const line : rows)
            for (int i = 0; i < samples; ++i) {
                const std::uint32_t color = line[x * samples + i];
                red_and_blue += color & 0xff00ff;
                green += color >> 8 & 0xff;
            }
        pixel[0] = static_cast<std::uint8_t>((red_and_blue >> 16) / count);
        if (channels == 1) continue;
        pixel[1] = static_cast<std::uint8_t>(green / count);
        pixel[2] = static_cast<std::uint8_t>((red_and_blue & 0xffff) / count);
    }
}

constexpr int smooth_samples = 4; // a pixel in each direction, where there are polygons, and where tones are kept

/// Sets a row of pixels to the means of the light of samples.
void write_means_of_light(cairo_surface_t* surface, int row, std::uint8_t* pixel, int columns, int channels)
{
    constexpr int count = smooth_samples * smooth_samples;
    const std::array<float, 256>& light = light_of_bytes();
    for (int x = 0; x < columns; ++x, pixel += channels)
        for (int channel = 0; channel < channels; ++channel) {
            float sum = 0; // of whole numbers below 2^20
            for (int i = 0; i < count; ++i) {
                const std::uint32_t* const samples = row_of(surface, row + i / smooth_samples) + x * smooth_samples;
                sum += light[samples[i % smooth_samples] >> (16 - 8 * channel) & 0xff];
            }
            pixel[channel] = byte_of_light(sum / count);
        }
}

int samples_a_side(const Drawing& drawing)
{
    if (drawing.keeps_tones) return smooth_samples;
    const auto is_polygon = [](const Shape& shape) { return std::holds_alternative<Polygon>(shape.form); };
    return std::ranges::any_of(drawing.shapes, is_polygon) ? smooth_samples : 1;
}

/// Paints a drawing, so many rows of pixels at a time.
class Painter
{
public:
    Painter(const Drawing& drawing, const PngLayout& layout)
        : layout_(layout), keeps_tones_(drawing.keeps_tones), samples_(band_rows / layout.rows_at_once),
          scale_(samples_ * (layout.width / drawing.width)),
          surface_(surface_of(std::min(layout.width, widest_surface) * samples_, band_rows)),
          cairo_(cairo_create(surface_.get()), &cairo_destroy)
    {
        cairo_set_antialias(cairo_.get(), samples_ > 1 ? CAIRO_ANTIALIAS_NONE : CAIRO_ANTIALIAS_GOOD);
        cairo_set_line_join(cairo_.get(), CAIRO_LINE_JOIN_ROUND);
        cairo_set_line_cap(cairo_.get(), CAIRO_LINE_CAP_ROUND);
        for (const Shape& shape : drawing.shapes) {
            const auto points = points_of(shape);
            if (points.empty()) continue;
            const auto [top, bottom] = std::ranges::minmax(points, {}, [](const DrawingPoint& p) { return p[1]; });
            const auto* image = std::get_if<Image>(&shape.form);
            shapes_.push_back({shape, (top[1] - reach_of(shape)) * scale_, (bottom[1] + reach_of(shape)) * scale_,
                               image ? surface_of(image->pixels) : CairoSurface(nullptr, &cairo_surface_destroy)});
        }
    }

    /// Sets rows of pixels, `top` and those below.
    void paint(std::uint8_t* pixels, int top, int rows)
    {
        for (int left = 0; left < layout_.width; left += widest_surface) {
            paint_samples(left * samples_, top * samples_, (top + rows) * samples_);
            const auto write = keeps_tones_   ? write_means_of_light
                               : samples_ > 1 ? write_means<smooth_samples>
                                              : write_means<1>;
            for (int row = 0; row < rows; ++row)
                write(surface_.get(), row * samples_,
                      pixels + (static_cast<std::ptrdiff_t>(row) * layout_.width + left) * layout_.channels,
                      std::min(widest_surface, layout_.width - left), layout_.channels);
        }
    }

private:
    struct Entry
    {
        const Shape& shape;
        double top, bottom;  ///< in rows of samples
        CairoSurface pixels; ///< of images
    };

    /// The columns of samples from `left` on, in rows from `top` to `bottom`.
    void paint_samples(int left, int top, int bottom)
    {
        cairo_identity_matrix(cairo_.get());
        set_color("#ffffff");
        cairo_paint(cairo_.get());
        cairo_translate(cairo_.get(), -left, -top);
        cairo_scale(cairo_.get(), scale_, scale_);
        for (const Entry& entry : shapes_)
            if (entry.bottom >= top && entry.top <= bottom) paint(entry);
        if (const auto status = cairo_status(cairo_.get()); status != CAIRO_STATUS_SUCCESS)
            throw StorageError(std::string("Cairo cannot draw a picture: ") + cairo_status_to_string(status));
        cairo_surface_flush(surface_.get());
    }

    void paint(const Entry& entry)
    {
        const Shape& shape = entry.shape;
        if (const auto* image = std::get_if<Image>(&shape.form)) return paint(*image, entry.pixels.get());
        std::visit([&](const auto& form) { add(form); }, shape.form);
        if (!shape.fill.empty()) {
            set_color(shape.fill);
            cairo_fill_preserve(cairo_.get());
        }
        if (!shape.stroke.empty()) {
            set_color(shape.stroke);
            cairo_set_line_width(cairo_.get(), shape.stroke_width);
            cairo_stroke_preserve(cairo_.get());
        }
        cairo_new_path(cairo_.get());
    }

    void set_color(const std::string& color)
    {
        const auto [red, green, blue] = color_channels(color);
        cairo_set_source_rgb(cairo_.get(), red / 255.0, green / 255.0, blue / 255.0);
    }

    void add(const Line& line)
    {
        const double limit = far_outside / scale_;
        for (const auto& [x, y] : line.points)
            cairo_line_to(cairo_.get(), std::clamp(x, -limit, limit), std::clamp(y, -limit, limit));
    }

    void add(const Polygon& corners)
    {
        add(Line{corners});
        cairo_close_path(cairo_.get());
    }

    void add(const Disk& disk)
    {
        cairo_arc(cairo_.get(), disk.middle[0], disk.middle[1], disk.radius, 0, 2 * std::numbers::pi);
        cairo_close_path(cairo_.get());
    }

    /// Outlines of letters, as the font has them: no hinting, which would move them to whole samples.
    void add(const Text& text)
    {
        const std::unique_ptr<cairo_font_options_t, decltype(&cairo_font_options_destroy)> options(
            cairo_font_options_create(), &cairo_font_options_destroy);
        cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
        cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
        cairo_set_font_options(cairo_.get(), options.get());
        cairo_select_font_face(cairo_.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
        cairo_set_font_size(cairo_.get(), text.size);
        if (cairo_scaled_font_get_type(cairo_get_scaled_font(cairo_.get())) != CAIRO_FONT_TYPE_FT)
            throw StorageError(
                "Cairo finds no fonts for the letters of pictures: install the package fonts-dejavu-core");
        cairo_text_extents_t extents{};
        if (text.is_centred) cairo_text_extents(cairo_.get(), text.words.c_str(), &extents);
        cairo_move_to(cairo_.get(), text.start[0] - extents.x_advance / 2, text.start[1]);
        cairo_text_path(cairo_.get(), text.words.c_str());
    }

    void add(const Image&) {}

    /// Samples are the means of what they cover, where pixels are no whole number of samples wide.
    void paint(const Image& image, cairo_surface_t* pixels)
    {
        const double size = image.width / image.pixels.width, in_samples = size * scale_;
        cairo_save(cairo_.get());
        cairo_translate(cairo_.get(), image.corner[0], image.corner[1]);
        cairo_scale(cairo_.get(), size, size);
        cairo_set_source_surface(cairo_.get(), pixels, 0, 0);
        cairo_pattern_set_filter(cairo_get_source(cairo_.get()),
                                 in_samples == std::floor(in_samples) ? CAIRO_FILTER_NEAREST : CAIRO_FILTER_GOOD);
        cairo_pattern_set_extend(cairo_get_source(cairo_.get()), CAIRO_EXTEND_PAD);
        cairo_rectangle(cairo_.get(), 0, 0, image.pixels.width, image.pixels.height);
        cairo_fill(cairo_.get());
        cairo_restore(cairo_.get());
    }

    PngLayout layout_;
    bool keeps_tones_;
    int samples_;  ///< a pixel in each direction
    double scale_; ///< samples a unit
    CairoSurface surface_;
    std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo_;
    std::vector<Entry> shapes_;
};

bool is_grey(const Shape& shape)
{
    if (const auto* image = std::get_if<Image>(&shape.form); image && image->pixels.channels > 1) return false;
    return std::ranges::all_of(std::array{shape.fill, shape.stroke}, [](const std::string& color) {
        const auto [red, green, blue] = color_channels(color.empty() ? "#ffffff" : color);
        return red == green && green == blue;
    });
}

/// Pixels that the picture of a drawing is high.
int height_of(const std::filesystem::path& path, const Drawing& drawing, int pixels_wide)
{
    constexpr double rounding = 1e-9; // an exact fit is not a pixel more
    const double high = std::max(1.0, std::ceil(drawing.height * pixels_wide / drawing.width * (1 - rounding)));
    if (pixels_wide < 1 || pixels_wide > max_drawing_pixels || high > max_drawing_pixels)
        throw InputError(fmt::format("{}: a picture of {} x {} pixels: must be from 1 to {} each way", path.string(),
                                     pixels_wide, high, max_drawing_pixels));
    return static_cast<int>(high);
}

}

void write_drawing_png(const std::filesystem::path& path, const Drawing& drawing, int pixels_wide)
{
    check_drawing(drawing);
    PngLayout layout{pixels_wide, height_of(path, drawing, pixels_wide)};
    layout.channels = std::ranges::all_of(drawing.shapes, is_grey) ? 1 : 3;
    layout.rows_at_once = band_rows / samples_a_side(drawing);
    // Few colours: rows compress as they are.
    layout.compression = 3;
    layout.filters = false;
    Painter painter(drawing, layout);
    std::vector<std::uint8_t> pixels;
    write_png(path, layout, [&](int top, int rows) {
        pixels.resize(static_cast<std::size_t>(rows) * static_cast<std::size_t>(layout.width * layout.channels));
        painter.paint(pixels.data(), top, rows);
        return pixels.data();
    });
}

}
