// The answer to whether sets are blue noise, with its reasons. docs/glossary.md derives the limits.
#pragma once

#include <optional>
#include <string>

namespace poissonlab {

struct Series;

struct BlueNoiseVerdict
{
    std::string answer;  ///< yes, weakly, no, or unknown
    std::string because; ///< a clause without a full stop

    bool operator==(const BlueNoiseVerdict&) const = default;

    /// "Blue noise: weakly, because ..."
    std::string words() const;
};

/// The answer for sets of `dimension` 2 or 3. It is empty for sets without a spectrum and for those of a region that
/// follow a density, whose spectrum is that of the density as well.
std::optional<BlueNoiseVerdict> blue_noise_verdict(const Series& series, int dimension);

/// True where the spectrum is as large as the rule asks, so that it shows all peaks.
bool reaches_as_asked(const Series& series, int dimension);

/// A sentence on measures that are left out because the spectrum ends too early; empty where none is.
std::string short_spectrum_words(const Series& series, int dimension);

}
