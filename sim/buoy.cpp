// A buoy's record as a directional spectrum: bins, their directions, and the tail.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "sim/buoy_directions.hpp"
#include "sim/buoy_tail.hpp"
#include "sim/error.hpp"
#include "sim/ndbc_reader.hpp"
#include "sim/spectrum.hpp"

namespace waterlight {

namespace {

/// Spectrum and directions at frequencies between which S D is linear, and the tail beyond them.
struct BuoySea {
    std::vector<double> frequency_hz;
    std::vector<double> density;
    std::vector<EntropyDistribution> directions;
    std::optional<BuoyTail> tail;

    double at(double f_hz, double theta_rad) const;
    double variance_m2() const;
};

double BuoySea::at(double f_hz, double theta_rad) const {
    if (f_hz < frequency_hz.front()) return 0;
    if (f_hz > frequency_hz.back())
        return tail && f_hz <= tail->end_hz ? tail->density(f_hz) * directions.back()(theta_rad) : 0;
    const auto above = std::upper_bound(frequency_hz.begin(), frequency_hz.end(), f_hz);
    const auto i = std::min(static_cast<std::size_t>(above - frequency_hz.begin()), frequency_hz.size() - 1) - 1;
    const double t = (f_hz - frequency_hz[i]) / (frequency_hz[i + 1] - frequency_hz[i]);
    return (1 - t) * density[i] * directions[i](theta_rad) + t * density[i + 1] * directions[i + 1](theta_rad);
}

double BuoySea::variance_m2() const {
    double sum = tail ? tail->variance_m2() : 0;
    for (std::size_t i = 0; i + 1 < frequency_hz.size(); ++i)
        sum += 0.5 * (density[i] + density[i + 1]) * (frequency_hz[i + 1] - frequency_hz[i]);
    return sum;
}

bool has_directions(const NdbcRecord& record, std::size_t i) {
    return !std::isnan(record.alpha1_deg[i]) && !std::isnan(record.alpha2_deg[i]) && !std::isnan(record.r1[i]) &&
           !std::isnan(record.r2[i]);
}

/// Moments of every bin; a bin without directions takes those between its nearest neighbours that have them.
std::vector<CircularMoments> moments_of(const NdbcRecord& record, const std::string& stem) {
    std::vector<std::size_t> known;
    for (std::size_t i = 0; i < record.frequency_hz.size(); ++i)
        if (has_directions(record, i)) known.push_back(i);
    if (known.empty())
        throw InputError(
            fmt::format("{}.swdir: no frequency of the record of \"{}\" has directions", stem, record.time));
    const auto at = [&](std::size_t i) {
        return buoy_moments(record.r1[i], record.alpha1_deg[i], record.r2[i], record.alpha2_deg[i]);
    };
    std::vector<CircularMoments> moments;
    for (std::size_t i = 0; i < record.frequency_hz.size(); ++i) {
        const auto upper = std::lower_bound(known.begin(), known.end(), i);
        const std::size_t above = upper == known.end() ? known.back() : *upper;
        const std::size_t below = upper == known.begin() || above == i ? above
                                  : upper == known.end()               ? above
                                                                       : *(upper - 1);
        const double span = record.frequency_hz[above] - record.frequency_hz[below];
        const double t = span > 0 ? (record.frequency_hz[i] - record.frequency_hz[below]) / span : 0;
        const CircularMoments a = at(below), b = at(above);
        moments.push_back({(1 - t) * a.c1 + t * b.c1, (1 - t) * a.c2 + t * b.c2});
    }
    return moments;
}

/// Mean of the moments of the bins that the tail was fitted to, weighted by their density.
CircularMoments tail_moments(const std::vector<CircularMoments>& moments, const std::vector<double>& density,
                             const BuoyTail& tail) {
    CircularMoments mean;
    double weight = 0;
    for (auto i = static_cast<std::size_t>(tail.first_fitted); i <= static_cast<std::size_t>(tail.last_clear); ++i) {
        mean.c1 += density[i] * moments[i].c1;
        mean.c2 += density[i] * moments[i].c2;
        weight += density[i];
    }
    return {mean.c1 / weight, mean.c2 / weight};
}

BuoySea make_sea(const NdbcRecord& record, const BuoySettings& settings, const Water& water) {
    const std::vector<CircularMoments> moments = moments_of(record, settings.stem.string());
    BuoySea sea;
    std::size_t bins = record.frequency_hz.size();
    if (settings.tail) {
        sea.tail = fit_tail(record.frequency_hz, record.density, water);
        bins = static_cast<std::size_t>(sea.tail->last_clear) + 1;
    }
    for (std::size_t i = 0; i < bins; ++i) {
        sea.frequency_hz.push_back(record.frequency_hz[i]);
        sea.density.push_back(record.density[i]);
        sea.directions.emplace_back(moments[i]);
    }
    if (sea.tail) {
        sea.frequency_hz.push_back(sea.tail->begin_hz);
        sea.density.push_back(sea.tail->density(sea.tail->begin_hz));
        sea.directions.emplace_back(tail_moments(moments, record.density, *sea.tail));
    }
    return sea;
}

std::string describe(const NdbcRecord& record, const BuoySettings& settings, const BuoySea& sea) {
    std::string text = fmt::format("NDBC buoy {}, {} UTC; directions by maximum entropy (Lygre & Krogstad 1986)",
                                   settings.stem.filename().string(), record.time);
    if (!sea.tail) return text + fmt::format("; nothing above {:g} Hz", record.frequency_hz.back());
    return text + fmt::format(
                      "; modelled from {:.3g} to {:.3g} Hz: {:.3g} f^-4 (Toba 1973), at most 0.0081 g^2 (2 pi)^-4 "
                      "f^-5 (Phillips 1958)",
                      sea.tail->begin_hz, sea.tail->end_hz, sea.tail->beta);
}

}  // namespace

DirectionalSpectrum read_buoy(const BuoySettings& settings, const Water& water) {
    const NdbcRecord record = read_ndbc(settings.stem, settings.time);
    if (std::all_of(record.density.begin(), record.density.end(), [](double s) { return s <= 0; }))
        throw InputError(
            fmt::format("{}.data_spec: the record of \"{}\" holds no waves", settings.stem.string(), record.time));
    const auto sea = std::make_shared<const BuoySea>(make_sea(record, settings, water));
    DirectionalSpectrum spectrum;
    spectrum.density = [sea](double f_hz, double theta_rad) { return sea->at(f_hz, theta_rad); };
    spectrum.f_min_hz = sea->frequency_hz.front();
    spectrum.f_max_hz = sea->tail ? sea->tail->end_hz : sea->frequency_hz.back();
    spectrum.variance_m2 = sea->variance_m2();
    spectrum.description = describe(record, settings, *sea);
    return spectrum;
}

}  // namespace waterlight
