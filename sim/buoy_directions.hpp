// Directional distribution of a buoy's bin by the method of maximum entropy.
//
// A. Lygre & H. E. Krogstad (1986), "Maximum entropy estimation of the directional distribution in ocean wave spectra",
// J. Phys. Oceanogr. 16, 2052, eqs. 13 to 15.
#pragma once

#include <complex>

namespace waterlight {

/// The first two circular moments of a distribution over the direction of travel: integral of D exp(i n theta).
struct CircularMoments {
    std::complex<double> c1{0, 0};
    std::complex<double> c2{0, 0};
};

/// Moments from what a buoy reports: r1, r2 in [0, 1]; alpha1, alpha2 in degrees clockwise from north from which the
/// waves come (x = east, y = north: theta = 270 - alpha). Noise can give moments that no distribution has: c1 is kept
/// within 0.98, and c2 within 0.9 of the way from c1^2 to where the distribution would be two points.
CircularMoments buoy_moments(double r1, double alpha1_deg, double r2, double alpha2_deg);

/// The distribution of largest entropy with given moments: positive, of integral 1 over the circle.
class EntropyDistribution {
  public:
    explicit EntropyDistribution(const CircularMoments& moments);
    /// Per radian, at the direction of travel.
    double operator()(double theta_rad) const;

  private:
    std::complex<double> phi1_, phi2_;
    double numerator_;
};

}  // namespace waterlight
