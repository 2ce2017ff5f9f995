// What the parts of the accuracy report share: tables, times taken side by side, and what is cheapest.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "gpu/context.hpp"
#include "sim/field.hpp"

namespace waterlight::accuracy {

inline constexpr int yardstick_pixels = 256 * 256;

struct Options {
    bool quick = false;                     ///< a few settings only, on small maps
    std::shared_ptr<gpu::Context> context;  ///< null: no Vulkan device
    std::function<void()> yardstick;        ///< a map of yardstick_pixels: what costs are counted in
};

/// Pixels or cells along each side of what is timed, at least.
inline int map_side(const Options& options) { return options.quick ? 128 : 256; }

void print_row(const std::vector<std::string>& cells);
void print_heads(const std::vector<std::string>& heads);

/// A number to two digits and no exponent before 0.0001.
std::string digits(double value);

/// A part of one as per cent, to two digits.
std::string percent(double part);

/// One call's time.
struct Timed {
    double ms = 0;
    double ratio = 1;   ///< over that of the first of the calls beside it
    double pixels = 0;  ///< of the yardstick's map that take as long
};

/// Each round calls the works in turn, the first and the yardstick between any two, so that each has the same chance of
/// a quiet moment; the fastest of the rounds, since what others do on the machine only adds. Four rounds and up to 25,
/// until budget_s is spent; the first warms up and does not count.
std::vector<Timed> time_together(const Options& options, const std::vector<std::function<void()>>& works,
                                 double budget_s);

/// Means over boxes of bx x by values; what is over at the far sides is left out.
template <class T>
Field<double> box_means(const Field<T>& field, int bx, int by) {
    Field<double> means(field.nx() / bx, field.ny() / by);
    for (int j = 0; j < means.ny() * by; ++j)
        for (int i = 0; i < means.nx() * bx; ++i) means(i / bx, j / by) += field(i, j) / double(bx * by);
    return means;
}

/// RMS of the difference over the RMS of `exact`, over the part of `found` that `exact` covers.
double relative_rms(const Field<double>& found, const Field<double>& exact);

/// The order of convergence: least squares of log error against log resolution. NaN where an error is 0.
double order_of(const std::vector<int>& resolutions, const std::vector<double>& errors);

/// What was measured of one setting of one method: an error, and what it costs in the unit that its scene's name
/// states.
struct Measured {
    std::string setting;
    double error = 0;
    double cost = 0;
};

/// The cheapest settings by scene, in the order in which scenes were first added.
class Choices {
  public:
    void add(const std::string& scene, Measured measured);
    /// One row a scene: for each tolerance the cheapest setting whose error is no more.
    void print() const;

  private:
    struct Scene {
        std::string name;
        std::vector<Measured> measured;
    };
    std::vector<Scene> scenes_;
};

void report_floor(const Options& options, Choices& choices);
void report_light(const Options& options);
void report_beams(const Options& options, Choices& choices);
void report_waves(const Options& options, Choices& choices);

}  // namespace waterlight::accuracy
