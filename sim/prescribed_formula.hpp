// The sum of a tilt, sines and a Gerstner sea, at any place and along rows of a grid.
#pragma once

#include <optional>
#include <vector>

#include "sim/gerstner.hpp"
#include "sim/prescribed.hpp"

namespace waterlight {

class SumFormula : public SurfaceFormula {
  public:
    /// Sines travel with the frequency of Airy waves. Throws InputError where a setting is out of its range.
    explicit SumFormula(const PrescribedSettings& settings);

    SurfacePoint at(glm::dvec2 at_m, double time_s) const override;

    /// Sets elevation and slopes of the surface at time_s. Sines are exact to rounding in float, the Gerstner sea as
    /// GerstnerSea::add_row() says.
    void evaluate_on(Surface& surface, double time_s) const;

  private:
    struct Columns;

    std::vector<Columns> columns_of(const Grid& grid) const;
    void set_row(Surface& surface, int j, double time_s, const std::vector<Columns>& columns) const;

    glm::dvec2 slope_;
    std::vector<Sine> sines_;
    std::vector<double> omega_;  // one for each sine
    std::optional<GerstnerSea> gerstner_;
};

}  // namespace waterlight
