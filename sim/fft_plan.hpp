// FFTW's single-precision complex transform, owned.
#pragma once

#include <memory>

struct fftwf_plan_s;

namespace waterlight {

/// `lines` complex lines of n values side by side (value j of line l at element j * lines + l, real and imaginary part
/// adjacent), transformed in place without a scale. Data must be aligned to 64 bytes. One object serves many threads.
class LineFft {
  public:
    LineFft(int n, int lines);

    /// Sums of X_m exp(+2 pi i m j / n).
    void to_space(float* data) const;
    /// Sums of x_j exp(-2 pi i m j / n).
    void to_slots(float* data) const;

  private:
    struct Destroy {
        void operator()(fftwf_plan_s* plan) const;
    };
    std::unique_ptr<fftwf_plan_s, Destroy> to_space_, to_slots_;
};

}  // namespace waterlight
