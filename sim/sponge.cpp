#include "sim/sponge.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>

#include "sim/kernels/linear.hpp"

namespace waterlight {

double Sponge::rate(int n) const {
    assert(n >= 0 && n < cells);
    return f64::sponge_rate((n + 0.5) / cells, peak_rate);
}

Sponge make_sponge(double width_m, double domain_m, double cell_m, double wave_speed) {
    const double width = width_m > 0 ? width_m : std::max(domain_m / 4, sponge_least_cells * cell_m);
    Sponge sponge;
    sponge.cells = std::max(1, static_cast<int>(std::ceil(width / cell_m - 1e-9)));
    sponge.cell_m = cell_m;
    // One way the amplitude falls by exp(-integral of rate dx / c) = exp(-peak width / (4 c)).
    const double kept = 1e-3;
    sponge.peak_rate = -2 * std::log(kept) * wave_speed / (sponge.cells * cell_m);
    return sponge;
}

std::vector<double> sponge_decay(const Sponge& sponge, int domain_cells, double dt_s) {
    std::vector<double> decay(static_cast<std::size_t>(domain_cells + 2 * sponge.cells), 1.0);
    for (int n = 0; n < sponge.cells; ++n) {
        const double d = std::exp(-sponge.rate(n) * dt_s);
        decay[static_cast<std::size_t>(sponge.cells - 1 - n)] = d;
        decay[static_cast<std::size_t>(sponge.cells + domain_cells + n)] = d;
    }
    return decay;
}

double sponge_reflection(const Sponge& sponge, double wave_speed, double dt_s, double omega) {
    using complex = std::complex<double>;
    // With eta(n) = E z^n and v(n+1/2) = V z^(n+1/2), kick and drift together say
    //   E (z - 1) (1 - decay^2 / z) = decay (c dt)^2 L E.
    const complex z = std::polar(1.0, -omega * dt_s);
    const double courant = wave_speed * dt_s / sponge.cell_m;
    const auto second_difference = [&](double decay) {
        return (z - 1.0) * (1.0 - decay * decay / z) / (decay * courant * courant);
    };
    // From still water beyond the margin inwards: E(j-1) = 2 E(j) - E(j+1) + second difference.
    complex outer = 0;
    complex here = 1;
    for (int n = sponge.cells - 1; n >= 0; --n) {
        const complex inner = (2.0 + second_difference(std::exp(-sponge.rate(n) * dt_s))) * here - outer;
        outer = here;
        here = inner;
    }
    // In the domain E = A exp(i k x) + B exp(-i k x) with the discrete wave number: split the last two values.
    const double k_cell = 2 * std::asin(std::sin(0.5 * omega * dt_s) / courant);
    const complex step = std::polar(1.0, k_cell);
    const complex outgoing = outer - here / step;
    const complex incoming = here * step - outer;
    return std::abs(incoming / outgoing);
}

}  // namespace waterlight
