#include "analysis/zone_plate/zone_plate_error.hpp"

#include "analysis/zone_plate/zone_plate_reference.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {

namespace {

struct MeanSquare
{
    double sum = 0;
    std::size_t count = 0;

    void add(double value)
    {
        sum += value * value;
        ++count;
    }
    double root() const { return std::sqrt(sum / static_cast<double>(count)); } // NaN of none
};

}

PlateError ZonePlateError::add(const SquareImage& image)
{
    const int size = image.size;
    if (first_size_ == 0) first_size_ = size;
    if (reference_.size != size) reference_ = zone_plate_reference(size);
    const double pixel = plate_side / size;
    const auto bins = static_cast<std::size_t>(plate_side * std::sqrt(2.0) / error_bin_width) + 1;
    squares_.resize(bins);
    pixels_.resize(bins);

    MeanSquare whole, resolved;
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column) {
            const double difference = image.at(column, row) - reference_.at(column, row);
            const double distance = pixel * std::hypot(column + 0.5, row + 0.5);
            const auto bin = static_cast<std::size_t>(distance / error_bin_width);
            squares_[bin] += difference * difference;
            ++pixels_[bin];
            whole.add(difference);
            if (plate_frequency(distance, size) <= 0.5) resolved.add(difference);
        }
    return {whole.root(), resolved.root()};
}

void ZonePlateError::append(const ZonePlateError& other)
{
    if (first_size_ == 0) first_size_ = other.first_size_;
    squares_.resize(std::max(squares_.size(), other.squares_.size()));
    pixels_.resize(squares_.size());
    for (std::size_t k = 0; k < other.squares_.size(); ++k) {
        squares_[k] += other.squares_[k];
        pixels_[k] += other.pixels_[k];
    }
}

std::vector<ErrorBin> ZonePlateError::curve() const
{
    std::vector<ErrorBin> curve;
    for (std::size_t k = 0; k < pixels_.size(); ++k) {
        if (pixels_[k] == 0) continue;
        const double distance = (static_cast<double>(k) + 0.5) * error_bin_width;
        curve.push_back({distance, plate_frequency(distance, first_size_),
                         std::sqrt(squares_[k] / static_cast<double>(pixels_[k])), pixels_[k]});
    }
    return curve;
}

}
