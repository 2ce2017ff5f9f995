#include "caustics/photons/blur.hpp"

#include <cmath>
#include <vector>

namespace waterlight {

namespace {

/// Weights of pixels 0, 1, 2 ... away on one side; with both sides their sum is 1.
std::vector<double> weights(double sigma) {
    if (sigma <= 0) return {1};
    const int reach = static_cast<int>(std::ceil(6 * sigma));
    std::vector<double> w(static_cast<std::size_t>(reach) + 1);
    double sum = 0;
    for (int k = 0; k <= reach; ++k) {
        w[static_cast<std::size_t>(k)] = std::exp(-0.5 * (k / sigma) * (k / sigma));
        sum += (k == 0 ? 1 : 2) * w[static_cast<std::size_t>(k)];
    }
    for (double& weight : w) weight /= sum;
    return w;
}

/// Pixel of an axis of n that stands at k: round the axis, or in the mirrors at its sides.
int folded(int k, int n, bool round) {
    const int period = round ? n : 2 * n;
    const int at = ((k % period) + period) % period;
    return at < n ? at : 2 * n - 1 - at;
}

void blur_rows(const Field<double>& from, const std::vector<double>& w, bool round, Field<double>& to) {
    const int n = from.nx(), reach = static_cast<int>(w.size()) - 1;
#pragma omp parallel
    {
        std::vector<double> wide(static_cast<std::size_t>(n + 2 * reach));
#pragma omp for schedule(static)
        for (int j = 0; j < from.ny(); ++j) {
            for (int k = 0; k < n + 2 * reach; ++k)
                wide[static_cast<std::size_t>(k)] = from(folded(k - reach, n, round), j);
            const double* middle = wide.data() + reach;
            for (int i = 0; i < n; ++i) {
                double sum = w[0] * middle[i];
                for (int k = 1; k <= reach; ++k)
                    sum += w[static_cast<std::size_t>(k)] * (middle[i - k] + middle[i + k]);
                to(i, j) = sum;
            }
        }
    }
}

void blur_columns(const Field<double>& from, const std::vector<double>& w, bool round, Field<double>& to) {
    const int reach = static_cast<int>(w.size()) - 1;
#pragma omp parallel for schedule(static)
    for (int j = 0; j < from.ny(); ++j) {
        double* __restrict out = to.row(j);
        for (int i = 0; i < from.nx(); ++i) out[i] = w[0] * from(i, j);
        for (int k = 1; k <= reach; ++k) {
            const double *below = from.row(folded(j - k, from.ny(), round)),
                         *above = from.row(folded(j + k, from.ny(), round));
            for (int i = 0; i < from.nx(); ++i) out[i] += w[static_cast<std::size_t>(k)] * (below[i] + above[i]);
        }
    }
}

}  // namespace

Field<double> blurred(const Field<double>& map, const BlurSettings& settings) {
    if (settings.sigma_pixels <= 0) return map.clone();
    const std::vector<double> w = weights(settings.sigma_pixels);
    Field<double> rows(map.nx(), map.ny()), both(map.nx(), map.ny());
    blur_rows(map, w, settings.round_x, rows);
    blur_columns(rows, w, settings.round_y, both);
    return both;
}

Field<double> blur_bias(const Field<double>& smoothed, const BlurSettings& settings) {
    const std::vector<double> w = weights(settings.sigma_pixels);
    double variance = 0;
    for (std::size_t k = 1; k < w.size(); ++k) variance += 2 * w[k] * static_cast<double>(k * k);
    const int nx = smoothed.nx(), ny = smoothed.ny();
    Field<double> bias(nx, ny);
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i) {
            const double across =
                smoothed(folded(i - 1, nx, settings.round_x), j) + smoothed(folded(i + 1, nx, settings.round_x), j);
            const double along =
                smoothed(i, folded(j - 1, ny, settings.round_y)) + smoothed(i, folded(j + 1, ny, settings.round_y));
            bias(i, j) = variance / 2 * (across + along - 4 * smoothed(i, j));
        }
    return bias;
}

double blur_noise(double sigma_pixels) {
    const std::vector<double> w = weights(sigma_pixels);
    double squares = w[0] * w[0];
    for (std::size_t k = 1; k < w.size(); ++k) squares += 2 * w[k] * w[k];
    return squares;
}

}  // namespace waterlight
