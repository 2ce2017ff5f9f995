#include "sim/fft_plan.hpp"

#include <fftw3.h>

#include <mutex>

#include "sim/field.hpp"

namespace waterlight {

namespace {

/// FFTW's planner keeps a state of its own that only one thread may touch at a time.
std::mutex& planner() {
    static std::mutex mutex;
    return mutex;
}

fftwf_complex* complex(float* data) { return reinterpret_cast<fftwf_complex*>(data); }

/// Estimated, not measured: planning costs under a millisecond and every run computes the same bits.
fftwf_plan plan_lines(int n, int lines, int sign, float* data) {
    const std::lock_guard lock(planner());
    return fftwf_plan_many_dft(1, &n, lines, complex(data), nullptr, lines, 1, complex(data), nullptr, lines, 1, sign,
                               FFTW_ESTIMATE);
}

}  // namespace

void LineFft::Destroy::operator()(fftwf_plan_s* plan) const {
    const std::lock_guard lock(planner());
    fftwf_destroy_plan(plan);
}

LineFft::LineFft(int n, int lines) {
    Field<float> data(2 * n, lines);
    to_space_.reset(plan_lines(n, lines, FFTW_BACKWARD, data.data()));
    to_slots_.reset(plan_lines(n, lines, FFTW_FORWARD, data.data()));
}

void LineFft::to_space(float* data) const { fftwf_execute_dft(to_space_.get(), complex(data), complex(data)); }

void LineFft::to_slots(float* data) const { fftwf_execute_dft(to_slots_.get(), complex(data), complex(data)); }

}  // namespace waterlight
