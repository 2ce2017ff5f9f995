# The airy model, the transforms under it, and the spectra it starts from.
target_sources(waterlight_sim PRIVATE
    airy.cpp
    airy_dispersion.cpp
    airy_initial.cpp
    airy_margin.cpp
    airy_modes.cpp
    airy_phase.cpp
    airy_sources.cpp
    buoy.cpp
    buoy_directions.cpp
    buoy_tail.cpp
    fft_axis.cpp
    fft_lines.cpp
    fft_plan.cpp
    fft_plane.cpp
    ndbc_reader.cpp
    sea_state.cpp
    spectrum.cpp)
