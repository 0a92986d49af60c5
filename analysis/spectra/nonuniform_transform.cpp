// The grid's lines along x are made, transformed and dropped strip by strip; what is kept are their transforms, of
// frequencies 0 .. reach alone, those of each frequency together, so that lines along y are consecutive numbers. A
// strip is the work of one thread, over its points in a fixed order, and so is a line.
#include "analysis/spectra/nonuniform_transform.hpp"

#include "analysis/spectra/fftw_plan.hpp"
#include "analysis/spectra/spreading_kernel.hpp"
#include "analysis/spectra/uninitialized_vector.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace poissonlab {
namespace {

using Complex = std::complex<double>;

/// Grid points per frequency sample. Less than the usual 2, with a wider kernel: transforms take most of the time.
constexpr double grid_oversampling = 1.25;
constexpr std::size_t width = 12; ///< of the kernel, in grid points

constexpr std::size_t strip_rows = 64; ///< more than the kernel's width

using Weights = std::array<double, width>;

/// The grid points under the kernel around a coordinate: the first of them, and where it lies under the kernel.
struct Cover
{
    std::size_t first;
    double offset;
};

/// Points by the strip of their first row, in a strip in their order.
struct StripOrder
{
    std::vector<std::size_t> starts; ///< of each strip; one more than there are strips
    std::vector<std::uint32_t> points;

    std::span<const std::uint32_t> of(std::size_t strip) const
    {
        return std::span(points).subspan(starts[strip], starts[strip + 1] - starts[strip]);
    }
};

}

class NonuniformTransform::Plan
{
public:
    explicit Plan(int reach);

    HalfPlane forward(const PointSet& points, std::span<const double> weights);

    /// The sum over the grid points under each point, with weights along x and y: what(j, x, y, sum), where the
    /// kernel begins before the first of them, and what makes the sum of weights.
    template <class What>
    void backward(const HalfPlane& coefficients, const PointSet& points, const What& what);

    double grid() const { return static_cast<double>(grid_); }
    const SpreadingKernel& kernel() const { return kernel_; }

private:
    /// The memory in which a thread works, kept from strip to strip.
    struct Workspace
    {
        explicit Workspace(const Plan& plan)
            : rows((2 * strip_rows + width) * plan.stride()), columns(2 * transposed_lines * plan.line_),
              line(2 * plan.line_)
        {}
        Complex* column(std::size_t k, const Plan& plan) { return complex(columns) + k * plan.line_; }

        UninitializedVector<double> rows;
        UninitializedVector<double> columns, line; ///< complex
    };

    static Complex* complex(UninitializedVector<double>& values) { return reinterpret_cast<Complex*>(values.data()); }

    std::size_t stride() const { return grid_ + width; }
    std::size_t strips() const { return std::max<std::size_t>(1, grid_ / strip_rows); }
    std::size_t strip_begin(std::size_t strip) const { return strip == strips() ? grid_ : strip * strip_rows; }
    std::size_t column_blocks() const { return (columns_ + transposed_lines - 1) / transposed_lines; }
    std::size_t row_of(int v) const { return static_cast<std::size_t>(v < 0 ? v + static_cast<int>(grid_) : v); }
    double correction(std::size_t u, int v) const
    {
        return corrections_[u] * corrections_[static_cast<std::size_t>(std::abs(v))];
    }

    Cover cover_of(double coordinate) const;
    StripOrder order_of(const PointSet& points) const;
    void spread(const PointSet& points, std::span<const double> weights, std::span<const std::uint32_t> strip_points,
                std::size_t begin, std::size_t end, double* rows) const;
    void transform_rows(std::size_t begin, std::size_t end, Workspace& work);
    void finish_columns(std::size_t first, Workspace& work, HalfPlane& result);
    void begin_columns(std::size_t first, Workspace& work, const HalfPlane& coefficients);
    void make_rows(std::size_t begin, std::size_t count, Workspace& work, double* rows);

    int reach_;
    std::size_t columns_, grid_;
    std::size_t line_; ///< from the line along y of one u to the next
    SpreadingKernel kernel_;
    std::vector<double> corrections_;   ///< 1 / transform of the kernel, of frequency 0 .. reach
    UninitializedVector<double> lines_; ///< [u][y], complex
    tbb::enumerable_thread_specific<Workspace> workspaces_;
    FftwPlan row_, row_back_, column_, column_back_;
};

NonuniformTransform::Plan::Plan(int reach)
    : reach_(reach), columns_(static_cast<std::size_t>(reach) + 1),
      grid_(transform_size(std::max(grid_oversampling * (2.0 * reach + 1), 2.0 * width))), line_(padded_line(grid_)),
      kernel_(width, static_cast<double>(grid_) / (2.0 * reach + 1)), lines_(2 * columns_ * line_),
      workspaces_([this] { return Workspace(*this); })
{
    for (int u = 0; u <= reach; ++u) corrections_.push_back(1 / kernel_.transform(u / grid()));
    Workspace& work = workspaces_.local();
    const int size = static_cast<int>(grid_);
    double* const row = work.rows.data();
    fftw_complex* const column = fftw(complex(work.columns));
    fftw_complex* const line = fftw(complex(work.line));
    row_ = make_fftw_plan(fftw_plan_dft_r2c_1d, size, row, column, FFTW_ESTIMATE);
    row_back_ = make_fftw_plan(fftw_plan_dft_c2r_1d, size, column, row, FFTW_ESTIMATE);
    column_ = make_fftw_plan(fftw_plan_dft_1d, size, line, column, FFTW_FORWARD, FFTW_ESTIMATE);
    column_back_ = make_fftw_plan(fftw_plan_dft_1d, size, line, column, FFTW_BACKWARD, FFTW_ESTIMATE);
}

Cover NonuniformTransform::Plan::cover_of(double coordinate) const
{
    const double begin = coordinate * grid() - 0.5 * width;
    const double first = std::ceil(begin);
    return {static_cast<std::size_t>(first < 0 ? first + grid() : first), first - begin};
}

StripOrder NonuniformTransform::Plan::order_of(const PointSet& points) const
{
    std::vector<std::uint32_t> strip_of(points.size());
    StripOrder order{std::vector<std::size_t>(strips() + 1), std::vector<std::uint32_t>(points.size())};
    for (std::size_t j = 0; j < points.size(); ++j) {
        strip_of[j] = static_cast<std::uint32_t>(std::min(cover_of(points[j][1]).first / strip_rows, strips() - 1));
        ++order.starts[strip_of[j] + 1];
    }
    for (std::size_t strip = 0; strip < strips(); ++strip) order.starts[strip + 1] += order.starts[strip];
    std::vector<std::size_t> next = order.starts;
    for (std::size_t j = 0; j < points.size(); ++j) order.points[next[strip_of[j]]++] = static_cast<std::uint32_t>(j);
    return order;
}

/// Adds points to rows begin .. end - 1 of the grid, which have room for what goes beyond their end.
void NonuniformTransform::Plan::spread(const PointSet& points, std::span<const double> weights,
                                       std::span<const std::uint32_t> strip_points, std::size_t begin, std::size_t end,
                                       double* rows) const
{
    Weights along_x, along_y;
    for (const std::uint32_t j : strip_points) {
        const Cover x = cover_of(points[j][0]), y = cover_of(points[j][1]);
        const std::size_t to_end = begin + grid_ - y.first; // rows before the strip, where it begins later
        if (y.first < begin && begin - y.first >= width) continue;
        if (y.first >= end && to_end >= width) continue;
        kernel_.values(x.offset, along_x.data());
        kernel_.values(y.offset, along_y.data());
        const double times = weights.empty() ? 1 : weights[j];
        for (std::size_t k = 0; k < width; ++k) {
            const std::size_t row = y.first + k < grid_ ? y.first + k : y.first + k - grid_;
            if (row < begin || row >= end) continue;
            double* const values = rows + (row - begin) * stride() + x.first;
            const double along = times * along_y[k];
            for (std::size_t i = 0; i < width; ++i) values[i] += along * along_x[i];
        }
    }
}

/// Rows begin .. end - 1, which lie in the workspace, to frequencies along x, in lines along y.
void NonuniformTransform::Plan::transform_rows(std::size_t begin, std::size_t end, Workspace& work)
{
    for (std::size_t first = begin; first < end; first += transposed_lines) {
        const std::size_t count = std::min(transposed_lines, end - first);
        for (std::size_t k = 0; k < count; ++k) {
            double* const row = work.rows.data() + (first - begin + k) * stride();
            for (std::size_t i = 0; i < width; ++i) row[i] += row[grid_ + i];
            fftw_execute_dft_r2c(row_.get(), row, fftw(work.column(k, *this)));
        }
        for (std::size_t u = 0; u < columns_; ++u) {
            Complex* const target = complex(lines_) + u * line_ + first;
            for (std::size_t k = 0; k < count; ++k) target[k] = work.column(k, *this)[u];
        }
    }
}

/// Frequencies along y of a block of lines.
void NonuniformTransform::Plan::finish_columns(std::size_t first, Workspace& work, HalfPlane& result)
{
    const std::size_t count = std::min(transposed_lines, columns_ - first);
    for (std::size_t k = 0; k < count; ++k) {
        // Copying first is faster: memory far away comes faster in its own order than in that of a transform.
        std::copy_n(complex(lines_) + (first + k) * line_, grid_, complex(work.line));
        fftw_execute_dft(column_.get(), fftw(complex(work.line)), fftw(work.column(k, *this)));
    }
    for (int v = -reach_; v <= reach_; ++v) {
        Complex* const target = &result.at(static_cast<int>(first), v);
        for (std::size_t k = 0; k < count; ++k) target[k] = work.column(k, *this)[row_of(v)] * correction(first + k, v);
    }
}

HalfPlane NonuniformTransform::Plan::forward(const PointSet& points, std::span<const double> weights)
{
    const StripOrder order = order_of(points);
    tbb::parallel_for(std::size_t{0}, strips(), [&](std::size_t strip) {
        Workspace& work = workspaces_.local();
        const std::size_t begin = strip_begin(strip), end = strip_begin(strip + 1);
        std::fill_n(work.rows.data(), (end - begin) * stride(), 0.0);
        // Points of the strip before reach into this one.
        if (strips() > 1)
            spread(points, weights, order.of(strip == 0 ? strips() - 1 : strip - 1), begin, end, work.rows.data());
        spread(points, weights, order.of(strip), begin, end, work.rows.data());
        transform_rows(begin, end, work);
    });
    HalfPlane result(reach_);
    tbb::parallel_for(std::size_t{0}, column_blocks(),
                      [&](std::size_t b) { finish_columns(b * transposed_lines, workspaces_.local(), result); });
    return result;
}

/// A block of lines from their frequencies along y.
void NonuniformTransform::Plan::begin_columns(std::size_t first, Workspace& work, const HalfPlane& coefficients)
{
    const std::size_t count = std::min(transposed_lines, columns_ - first);
    for (std::size_t k = 0; k < count; ++k) std::fill_n(work.column(k, *this), grid_, 0.0);
    for (int v = -reach_; v <= reach_; ++v) {
        const Complex* const source = &coefficients.at(static_cast<int>(first), v);
        for (std::size_t k = 0; k < count; ++k) work.column(k, *this)[row_of(v)] = source[k] * correction(first + k, v);
    }
    for (std::size_t k = 0; k < count; ++k) {
        fftw_execute_dft(column_back_.get(), fftw(work.column(k, *this)), fftw(complex(work.line)));
        std::copy_n(complex(work.line), grid_, complex(lines_) + (first + k) * line_);
    }
}

/// Rows from `begin` on, around the torus, each with its beginning again after its end.
void NonuniformTransform::Plan::make_rows(std::size_t begin, std::size_t count, Workspace& work, double* rows)
{
    for (std::size_t done = 0; done < count;) {
        const std::size_t row = (begin + done) % grid_;
        const std::size_t together = std::min({transposed_lines, count - done, grid_ - row});
        for (std::size_t u = 0; u < columns_; ++u) {
            const Complex* const source = complex(lines_) + u * line_ + row;
            for (std::size_t k = 0; k < together; ++k) work.column(k, *this)[u] = source[k];
        }
        for (std::size_t k = 0; k < together; ++k, ++done) {
            Complex* const frequencies = work.column(k, *this);
            std::fill(frequencies + columns_, frequencies + grid_ / 2 + 1, 0.0);
            double* const values = rows + done * stride();
            fftw_execute_dft_c2r(row_back_.get(), fftw(frequencies), values);
            std::copy_n(values, width, values + grid_);
        }
    }
}

template <class What>
void NonuniformTransform::Plan::backward(const HalfPlane& coefficients, const PointSet& points, const What& what)
{
    const StripOrder order = order_of(points);
    tbb::parallel_for(std::size_t{0}, column_blocks(),
                      [&](std::size_t b) { begin_columns(b * transposed_lines, workspaces_.local(), coefficients); });
    tbb::parallel_for(std::size_t{0}, strips(), [&](std::size_t strip) {
        if (order.of(strip).empty()) return;
        Workspace& work = workspaces_.local();
        const std::size_t begin = strip_begin(strip);
        make_rows(begin, strip_begin(strip + 1) - begin + width - 1, work, work.rows.data());
        for (const std::uint32_t j : order.of(strip)) {
            const Cover x = cover_of(points[j][0]), y = cover_of(points[j][1]);
            const double* const values = work.rows.data() + (y.first - begin) * stride() + x.first;
            what(j, x.offset, y.offset, [&](const Weights& along_x, const Weights& along_y) {
                double sum = 0;
                for (std::size_t k = 0; k < width; ++k) {
                    double of_row = 0;
                    for (std::size_t i = 0; i < width; ++i) of_row += along_x[i] * values[k * stride() + i];
                    sum += along_y[k] * of_row;
                }
                return sum;
            });
        }
    });
}

NonuniformTransform::NonuniformTransform(int reach) : plan_(std::make_unique<Plan>(reach)) {}
NonuniformTransform::~NonuniformTransform() = default;
NonuniformTransform::NonuniformTransform(NonuniformTransform&&) noexcept = default;

HalfPlane NonuniformTransform::forward(const PointSet& points, std::span<const double> weights)
{
    return plan_->forward(points, weights);
}

std::vector<double> NonuniformTransform::adjoint(const HalfPlane& coefficients, const PointSet& points)
{
    std::vector<double> result(points.size());
    plan_->backward(coefficients, points, [&](std::size_t j, double x, double y, const auto& sum) {
        Weights along_x, along_y;
        plan_->kernel().values(x, along_x.data());
        plan_->kernel().values(y, along_y.data());
        result[j] = sum(along_x, along_y);
    });
    return result;
}

std::vector<double> NonuniformTransform::adjoint_gradient(const HalfPlane& coefficients, const PointSet& points)
{
    std::vector<double> result(2 * points.size());
    const double scale = -plan_->grid(); // where a coordinate is larger, grid points lie farther to the left under it
    plan_->backward(coefficients, points, [&](std::size_t j, double x, double y, const auto& sum) {
        Weights along_x, along_y, slope_x, slope_y;
        plan_->kernel().values(x, along_x.data());
        plan_->kernel().values(y, along_y.data());
        plan_->kernel().slopes(x, slope_x.data());
        plan_->kernel().slopes(y, slope_y.data());
        result[2 * j] = scale * sum(slope_x, along_y);
        result[2 * j + 1] = scale * sum(along_x, slope_y);
    });
    return result;
}

}
