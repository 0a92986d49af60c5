#include "host/texture/masked_squares.hpp"

#include "analysis/spectra/fftw_plan.hpp"

#include <cmath>
#include <mutex>
#include <stdexcept>

namespace poissonlab {
namespace {

using Spectrum = std::vector<std::complex<double>>;

/// Transforms of pictures of one size, both ways. Plans are shared; each call has arrays of its own.
class PictureTransform
{
public:
    PictureTransform(int width, int height)
        : width_(width), height_(height), line_(static_cast<std::size_t>(width) / 2 + 1)
    {
        std::vector<double> values(pixels());
        Spectrum spectrum(size());
        forward_ = make_fftw_plan(fftw_plan_dft_r2c_2d, height, width, values.data(), fftw(spectrum.data()),
                                  FFTW_ESTIMATE | FFTW_UNALIGNED);
        backward_ = make_fftw_plan(fftw_plan_dft_c2r_2d, height, width, fftw(spectrum.data()), values.data(),
                                   FFTW_ESTIMATE | FFTW_UNALIGNED);
    }

    std::size_t pixels() const { return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_); }
    std::size_t size() const { return line_ * static_cast<std::size_t>(height_); }
    int width() const { return width_; }
    int height() const { return height_; }

    /// Overwrites the values.
    void forward(std::vector<double>& values, Spectrum& spectrum) const
    {
        spectrum.resize(size());
        fftw_execute_dft_r2c(forward_.get(), values.data(), fftw(spectrum.data()));
    }

    Spectrum spectrum(std::vector<double> values) const
    {
        Spectrum spectrum;
        forward(values, spectrum);
        return spectrum;
    }

    /// Overwrites the spectrum; values are those of the picture times the number of pixels.
    void backward(Spectrum& spectrum, std::vector<double>& values) const
    {
        values.resize(pixels());
        fftw_execute_dft_c2r(backward_.get(), fftw(spectrum.data()), values.data());
    }

private:
    int width_, height_;
    std::size_t line_;
    FftwPlan forward_, backward_;
};

/// Arrays as large as the exemplar, 24 bytes a pixel.
struct Scratch
{
    std::vector<double> values;
    Spectrum spectrum, product;
};

/// Lends each call its scratch: calls are many, and new memory takes as long as their transforms. There are as many as
/// calls at a time, and the memory is free when the pool is gone.
class ScratchPool
{
public:
    Scratch take()
    {
        const std::lock_guard lock(mutex_);
        if (idle_.empty()) return {};
        Scratch scratch = std::move(idle_.back());
        idle_.pop_back();
        return scratch;
    }

    void give_back(Scratch scratch)
    {
        const std::lock_guard lock(mutex_);
        idle_.push_back(std::move(scratch));
    }

private:
    std::mutex mutex_;
    std::vector<Scratch> idle_;
};

/// Adds a * conj(b), without the tests for infinite numbers that the operator makes.
void add_correlation(std::complex<double>& sum, const std::complex<double>& a, const std::complex<double>& b)
{
    sum += std::complex<double>(a.real() * b.real() + a.imag() * b.imag(), a.imag() * b.real() - a.real() * b.imag());
}

/// The nearest integer of a value that must be one but for rounding.
std::int64_t exact_integer(double value)
{
    const double nearest = std::nearbyint(value);
    if (!(std::abs(value - nearest) < 0.25)) throw std::logic_error("a correlation that is no integer");
    return static_cast<std::int64_t>(nearest);
}

/// A value for each pixel of the exemplar: f(values of its channels).
template <class Function>
std::vector<double> per_pixel(const PngPixels& exemplar, const Function& f)
{
    std::vector<double> values;
    values.reserve(exemplar.values.size() / static_cast<std::size_t>(exemplar.channels));
    for (std::size_t i = 0; i < exemplar.values.size(); i += static_cast<std::size_t>(exemplar.channels))
        values.push_back(f(&exemplar.values[i]));
    return values;
}

void check_fit(const PngPixels& exemplar, const PieceMask& mask)
{
    if (mask.width > exemplar.width || mask.height > exemplar.height)
        throw std::logic_error("a piece that is larger than its exemplar");
}

SquareSums empty_sums(const PngPixels& exemplar, const PieceMask& mask)
{
    check_fit(exemplar, mask);
    SquareSums result{exemplar.width - mask.width + 1, exemplar.height - mask.height + 1, {}};
    result.sums.resize(static_cast<std::size_t>(result.columns) * static_cast<std::size_t>(result.rows));
    return result;
}

}

struct MaskedSquares::Spectra
{
    Spectra(const PngPixels& exemplar, const PieceMask& its_mask)
        : transform(exemplar.width, exemplar.height), mask(its_mask), empty(empty_sums(exemplar, its_mask)),
          channels(exemplar.channels)
    {
        for (int c = 0; c < channels; ++c)
            of_channels.push_back(transform.spectrum(per_pixel(exemplar, [c](const std::uint8_t* v) { return v[c]; })));
        const Spectrum of_squares = transform.spectrum(per_pixel(exemplar, [this](const std::uint8_t* v) {
            double sum = 0;
            for (int c = 0; c < channels; ++c) sum += v[c] * v[c];
            return sum;
        }));
        Scratch scratch;
        place(scratch.values, [](std::size_t) { return 1.0; });
        transform.forward(scratch.values, scratch.spectrum);
        scratch.product.resize(transform.size());
        for (std::size_t i = 0; i < of_squares.size(); ++i)
            add_correlation(scratch.product[i], of_squares[i], scratch.spectrum[i]);
        for_each_sum(scratch, [this](std::size_t, std::int64_t sum) { window_squares.push_back(sum); });
        pool.give_back(std::move(scratch));
    }

    /// The mask times a value of each of its pixels, in the corner of a picture of the exemplar's size.
    template <class Value>
    void place(std::vector<double>& values, const Value& value) const
    {
        values.assign(transform.pixels(), 0);
        for (int y = 0; y < mask.height; ++y)
            for (int x = 0; x < mask.width; ++x) {
                const auto pixel =
                    static_cast<std::size_t>(y) * static_cast<std::size_t>(mask.width) + static_cast<std::size_t>(x);
                if (mask.counts[pixel] == 0) continue;
                values[static_cast<std::size_t>(y) * static_cast<std::size_t>(transform.width()) +
                       static_cast<std::size_t>(x)] = value(pixel);
            }
    }

    /// Uses the sums of products at all places of the window that is inside, of which none wraps around.
    template <class Use>
    void for_each_sum(Scratch& scratch, const Use& use) const
    {
        transform.backward(scratch.product, scratch.values);
        const double scale = 1 / static_cast<double>(transform.pixels());
        std::size_t window = 0;
        for (int y = 0; y < empty.rows; ++y)
            for (int x = 0; x < empty.columns; ++x)
                use(window++,
                    exact_integer(
                        scale *
                        scratch.values[static_cast<std::size_t>(y) * static_cast<std::size_t>(transform.width()) +
                                       static_cast<std::size_t>(x)]));
    }

    PictureTransform transform;
    PieceMask mask;
    SquareSums empty;
    int channels;
    std::vector<Spectrum> of_channels;
    std::vector<std::int64_t> window_squares; ///< sum of m S^2 for each window
    mutable ScratchPool pool;
};

MaskedSquares::MaskedSquares(const PngPixels& exemplar, const PieceMask& mask)
    : spectra_(std::make_unique<Spectra>(exemplar, mask))
{}

MaskedSquares::~MaskedSquares() = default;

SquareSums MaskedSquares::sums(const PngPixels& piece) const
{
    const Spectra& s = *spectra_;
    const auto channels = static_cast<std::size_t>(s.channels);
    Scratch scratch = s.pool.take();
    scratch.product.assign(s.transform.size(), 0);
    std::int64_t squares = 0;
    for (std::size_t c = 0; c < channels; ++c) {
        s.place(scratch.values, [&](std::size_t pixel) {
            const int value = piece.values[pixel * channels + c];
            squares += value * value;
            return static_cast<double>(value);
        });
        s.transform.forward(scratch.values, scratch.spectrum);
        for (std::size_t i = 0; i < scratch.product.size(); ++i)
            add_correlation(scratch.product[i], s.of_channels[c][i], scratch.spectrum[i]);
    }
    SquareSums result = s.empty;
    s.for_each_sum(scratch, [&](std::size_t i, std::int64_t product) {
        result.sums[i] = static_cast<std::uint64_t>(squares - 2 * product + s.window_squares[i]);
    });
    s.pool.give_back(std::move(scratch));
    return result;
}

}
