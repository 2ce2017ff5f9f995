#include "caustics/water_colour.hpp"

#include <array>
#include <cassert>

#include "caustics/kernels/water_colour.hpp"

namespace waterlight {

namespace {

constexpr double step_nm = 2.5;

/// 1/m, from 380 nm on. The minimum is 0.00442 at 417.5 nm.
constexpr std::array absorption_per_m{
    // clang-format off
    0.01137, 0.01044, 0.00941, 0.00917, 0.00851, 0.00829, 0.00813, 0.00775, 0.00663, 0.00579,
    0.0053, 0.00503, 0.00473, 0.00452, 0.00444, 0.00442, 0.00454, 0.00474, 0.00478, 0.00482,
    0.00495, 0.00504, 0.0053, 0.0058, 0.00635, 0.00696, 0.00751, 0.0083, 0.00922, 0.00969,
    0.00962, 0.00957, 0.00979, 0.01005, 0.01011, 0.0102, 0.0106, 0.0109, 0.0114, 0.0121,
    0.0127, 0.0131, 0.0136, 0.0144, 0.015, 0.0162, 0.0173, 0.0191, 0.0204, 0.0228,
    0.0256, 0.028, 0.0325, 0.0372, 0.0396, 0.0399, 0.0409, 0.0416, 0.0417, 0.0428,
    0.0434, 0.0447, 0.0452, 0.0466, 0.0474, 0.0489, 0.0511, 0.0537, 0.0565, 0.0593,
    0.0596, 0.0606, 0.0619, 0.064, 0.0642, 0.0672, 0.0695, 0.0733, 0.0772, 0.0836,
    0.0896, 0.0989, 0.11, 0.122, 0.1351, 0.1516, 0.1672, 0.1925, 0.2224, 0.247,
    0.2577, 0.2629, 0.2644, 0.2665, 0.2678, 0.2707, 0.2755, 0.281, 0.2834, 0.2904,
    0.2916, 0.2995, 0.3012, 0.3077, 0.3108, 0.322, 0.325, 0.335, 0.34, 0.358,
    0.371, 0.393, 0.41, 0.424, 0.429, 0.436, 0.439, 0.448, 0.448, 0.461,
    0.465, 0.478, 0.486, 0.502, 0.516, 0.538, 0.559, 0.592, 0.624,
    // clang-format on
};
static_assert(shortest_nm + step_nm * (absorption_per_m.size() - 1) == longest_nm);

}  // namespace

double pure_water_absorption(double wavelength_nm) {
    assert(wavelength_nm >= shortest_nm && wavelength_nm <= longest_nm);
    const double place = (wavelength_nm - shortest_nm) / step_nm;
    const std::size_t low = std::min(static_cast<std::size_t>(place), absorption_per_m.size() - 2);
    const double part = place - static_cast<double>(low);
    return absorption_per_m[low] + part * (absorption_per_m[low + 1] - absorption_per_m[low]);
}

WaterOptics optics_at(double wavelength_nm, const WaterState& state, const WaterOptics& more) {
    WaterOptics optics = more;
    optics.refractive_index = f64::water_index(wavelength_nm, state.temperature_c, state.salinity_permille);
    optics.absorption_per_m += pure_water_absorption(wavelength_nm);
    optics.scattering_per_m += f64::pure_water_scattering(wavelength_nm, state.salinity_permille);
    return optics;
}

std::vector<double> black_body_shares(std::span<const double> wavelengths_nm, double kelvin) {
    std::vector<double> shares;
    double sum = 0;
    for (const double nm : wavelengths_nm) {
        shares.push_back(f64::black_body(nm, kelvin));
        sum += shares.back();
    }
    for (double& share : shares) share /= sum;
    return shares;
}

}  // namespace waterlight
