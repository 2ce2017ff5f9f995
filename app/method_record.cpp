#include "app/method_record.hpp"

#include <algorithm>
#include <cmath>

#include "sim/field_norms.hpp"

namespace waterlight {

namespace {

double rms_of(const FloorMap& map) { return norms_of(std::span<const float>(map.irradiance.values())).l2; }

void add(const PhotonFloor& photons, double rms, MethodRecord& record) {
    record.passes = std::max(record.passes, photons.passes());
    record.photons += photons.photons();
    record.error_estimate += photons.error_estimate() * rms;
}

void add(const SplatReport& of_one, SplatReport& sum) {
    const auto squares = [](const SplatReport& r) {
        return r.last_step_m * r.last_step_m * static_cast<double>(r.vertices);
    };
    const double both = squares(of_one) + squares(sum);
    sum.vertices += of_one.vertices;
    sum.not_converged += of_one.not_converged;
    sum.missed += of_one.missed;
    sum.last_step_m = sum.vertices > 0 ? std::sqrt(both / static_cast<double>(sum.vertices)) : 0;
}

double part(std::int64_t of, std::int64_t all) {
    return all > 0 ? static_cast<double>(of) / static_cast<double>(all) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

double MethodRecord::not_converged_fraction() const { return part(splat.not_converged, splat.vertices); }
double MethodRecord::missed_fraction() const { return part(splat.missed, splat.vertices); }

// Photons of all wavelengths are drawn alike: their errors add.
MethodRecord method_record(FloorMethod method, const LitMapper& lit, const FloorMap& map) {
    MethodRecord record;
    record.method = method;
    if (method == FloorMethod::photons) record.error_estimate = 0;
    for (std::size_t k = 0; k < lit.own.size(); ++k) {
        const FloorMapper* mapper = *lit.own[k];
        if (const auto* splat = dynamic_cast<const SplatFloor*>(mapper)) add(splat->report(), record.splat);
        if (const auto* photons = dynamic_cast<const PhotonFloor*>(mapper))
            add(*photons, rms_of(lit.spectral ? lit.spectral->maps()[k].map : map), record);
    }
    if (method == FloorMethod::photons) record.error_estimate /= rms_of(map);
    return record;
}

}  // namespace waterlight
