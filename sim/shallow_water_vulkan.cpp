#include "sim/shallow_water_vulkan.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <optional>

#include "gpu/buffer.hpp"
#include "gpu/commands.hpp"
#include "gpu/pass.hpp"
#include "shaders/shallow_flux.hpp"
#include "shaders/shallow_frame.hpp"
#include "shaders/shallow_record.hpp"
#include "shaders/shallow_update.hpp"
#include "sim/shallow_model.hpp"
#include "sim/shallow_records.hpp"
#include "sim/shallow_sides.hpp"

namespace waterlight {

namespace {

using f32::SideDemand;

#include "sim/shaders/shallow_parameters.glsl"

using gpu::BufferUse;

constexpr int frame = FramedRows<float>::frame;
constexpr std::array<std::uint32_t, 3> tile_workgroup{32, 8, 1};
constexpr std::array<std::uint32_t, 3> side_workgroup{64, 1, 1};

/// Three passes a stage: fluxes, what they make of the cells, and what lies beyond the sides then.
class VulkanSolver final : public ShallowSolver<float> {
  public:
    VulkanSolver(const ShallowWaterSettings& s, const std::shared_ptr<gpu::Context>& context)
        : constants_(s),
          sides_(s.sides),
          nx_(s.grid.nx),
          ny_(s.grid.ny),
          start_(nx_, ny_),
          fields_(nx_, ny_),
          flux_(context, pass("shallow water: flux", shaders::shallow_flux, tile_workgroup)),
          update_(context, pass("shallow water: update", shaders::shallow_update, tile_workgroup)),
          frame_(context, pass("shallow water: frame", shaders::shallow_frame, side_workgroup)),
          start_buffer_(context, cells() * sizeof(glm::vec2), BufferUse::from_host),
          now_(context, cells() * sizeof(glm::vec4), BufferUse::both),
          change_(context, cells() * sizeof(glm::vec4), BufferUse::device),
          flux_x_(context, cells() * sizeof(glm::vec4), BufferUse::device),
          flux_y_(context, cells() * sizeof(glm::vec4), BufferUse::device),
          peak_(context, sizeof(std::uint32_t), BufferUse::to_host),
          commands_(context) {
        for (gpu::Pass* pass : {&flux_, &update_, &frame_}) bind(*pass, peak_);
        set_start(s, start_, fields_);
        ShallowFrames<float>(s.grid, constants_.gravity, constants_.film).fill(side_demands(sides_, {0, 0, 0}), start_);
        const std::span<glm::vec2> start = start_buffer_.host<glm::vec2>();
        for_cells([&](int i, int j, std::size_t at) {
            start[at] = {start_.surface.row(j)[i], start_.depth.row(j)[i]};
        });
        std::ranges::fill(now_.host<glm::vec4>(), glm::vec4(0));
        commands_.upload(start_buffer_);
        if (s.keep_records) begin_records(context);
    }

    const ShallowStart<float>& start() const override { return start_; }

    ShallowFields<float>& fields() override {
        if (fields_are_new_) return fields_;
        commands_.download(now_);
        commands_.run();
        const std::span<const glm::vec4> now = now_.host<glm::vec4>();
        for_cells([&](int i, int j, std::size_t at) {
            fields_.rise.row(j)[i] = now[at].x;
            fields_.qx.row(j)[i] = now[at].y;
            fields_.qy.row(j)[i] = now[at].z;
        });
        fields_are_new_ = true;
        return fields_;
    }

    ShallowPeak look(double time_s) override {
        if (fields_are_new_) upload_fields();
        const ShallowParameters parameters = this->parameters({time_s, time_s, time_s}, 0, 0);
        commands_.clear(peak_);
        commands_.dispatch(update_, cells_extent(), parameters);
        commands_.dispatch(frame_, frame_extent(), parameters);
        return run();
    }

    ShallowPeak step(double time_s, double dt) override {
        const double end_s = time_s + dt;
        const ShallowMoment begin{time_s, time_s, end_s}, end{end_s, time_s, end_s}, after{end_s, end_s, end_s};
        const bool rubs = constants_.manning > 0;
        if (rubs) commands_.dispatch(update_, cells_extent(), parameters(begin, dt, 3));
        if (rubs || has_series(sides_)) commands_.dispatch(frame_, frame_extent(), parameters(begin, dt, 0));
        commands_.clear(peak_);
        dispatch_stage(parameters(begin, dt, 1), parameters(end, dt, 1));
        dispatch_stage(parameters(end, dt, 2), parameters(after, dt, 2));
        return run();
    }

    /// Runs with the next step.
    void record(double time_s) override {
        commands_.dispatch(*record_, cells_extent(), parameters({time_s, time_s, time_s}, 0, 0));
    }

    const ShallowRecords& records() override {
        commands_.download(*records_buffer_);
        commands_.run();
        const std::span<const glm::vec4> found = records_buffer_->host<glm::vec4>();
        for_cells([&](int i, int j, std::size_t at) {
            if (i < 0 || i >= nx_ || j < 0 || j >= ny_) return;
            const auto known = [](float value) { return std::abs(value) < beyond_all ? value : std::nanf(""); };
            records_.max_elevation_m(i, j) = known(found[at].x);
            records_.max_speed_m_s(i, j) = found[at].y;
            records_.arrival_s(i, j) = known(found[at].z);
        });
        return records_;
    }

    void exchange_state(StateArchive& state) override {
        // What is still to be done is done first.
        commands_.download(now_);
        if (records_buffer_) commands_.download(*records_buffer_);
        commands_.run();
        state.values(now_.host<glm::vec4>());
        if (records_buffer_) state.values(records_buffer_->host<glm::vec4>());
        if (!state.restores()) return;
        commands_.upload(now_);
        if (records_buffer_) commands_.upload(*records_buffer_);
        fields_are_new_ = false;
    }

  private:
    /// Stands for a record that has no value yet: a device may not keep a NaN.
    static constexpr float beyond_all = 1e30F;

    static gpu::PassSettings pass(const char* name, std::span<const std::uint32_t> spirv,
                                  std::array<std::uint32_t, 3> workgroup) {
        using enum gpu::Texels;
        return {name, spirv, 5, sizeof(ShallowParameters), workgroup, {rg32f, rgba32f, rgba32f, rgba32f, rgba32f}};
    }

    /// To the fields and to what the pass alone has, its binding 4.
    void bind(gpu::Pass& pass, const gpu::Buffer& own) {
        pass.bind({&now_, &change_, &flux_x_, &flux_y_, &own}, {&start_buffer_, &now_, &change_, &flux_x_, &flux_y_});
    }

    void begin_records(const std::shared_ptr<gpu::Context>& context) {
        record_.emplace(context, pass("shallow water: record", shaders::shallow_record, tile_workgroup));
        records_buffer_.emplace(context, cells() * sizeof(glm::vec4), BufferUse::both);
        bind(*record_, *records_buffer_);
        records_ = empty_records(nx_, ny_);
        std::ranges::fill(records_buffer_->host<glm::vec4>(), glm::vec4(-beyond_all, 0, beyond_all, 0));
        commands_.upload(*records_buffer_);
    }

    std::size_t cells() const {
        return static_cast<std::size_t>(nx_ + 2 * frame) * static_cast<std::size_t>(ny_ + 2 * frame);
    }
    /// Calls work(i, j, at) for all cells and those of the frame; `at` is their place in the buffers.
    template <class Work>
    void for_cells(Work work) const {
#pragma omp parallel for schedule(static)
        for (int j = -frame; j < ny_ + frame; ++j) {
            std::size_t at = static_cast<std::size_t>(j + frame) * static_cast<std::size_t>(nx_ + 2 * frame);
            for (int i = -frame; i < nx_ + frame; ++i) work(i, j, at++);
        }
    }

    static gpu::Extent extent(int x, int y, int z) {
        return {static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), static_cast<std::uint32_t>(z)};
    }
    gpu::Extent cells_extent() const { return extent(nx_, ny_, 1); }
    gpu::Extent faces_extent() const { return extent(nx_ + 1, ny_ + 1, 1); }
    gpu::Extent frame_extent() const { return extent(std::max(nx_, ny_), frame, 4); }

    /// A stage, and the frame of what it leads to.
    void dispatch_stage(const ShallowParameters& stage, const ShallowParameters& reached) {
        commands_.dispatch(flux_, faces_extent(), stage);
        commands_.dispatch(update_, cells_extent(), stage);
        commands_.dispatch(frame_, frame_extent(), reached);
    }

    /// With the sides as they are at that moment.
    ShallowParameters parameters(const ShallowMoment& moment, double dt, int stage_number) const {
        const ShallowStage<float> stage = constants_.stage<float>(dt);
        ShallowParameters p{.nx = nx_,
                            .ny = ny_,
                            .dt = stage.dt,
                            .per_dx = stage.per_dx,
                            .per_dy = stage.per_dy,
                            .gravity = stage.gravity,
                            .film = stage.film,
                            .friction = stage.friction,
                            .wet = static_cast<float>(constants_.wet),
                            .datum = static_cast<float>(start_.datum_m),
                            .time = static_cast<float>(moment.at_s),
                            .stage = stage_number,
                            .sides = {}};
        const SideDemands demands = side_demands(sides_, moment);
        std::ranges::transform(demands, p.sides, [&](const f64::SideDemand& d) {
            const bool is_level = d.kind == BEYOND_LEVEL || d.kind == BEYOND_FLOW;
            const double value = is_level ? d.value - start_.datum_m : d.value;
            return SideDemand{d.kind, static_cast<float>(value), static_cast<float>(d.u), static_cast<float>(d.v)};
        });
        return p;
    }

    /// The carry, which the host knows nothing of, stays as it was downloaded.
    void upload_fields() {
        const std::span<glm::vec4> now = now_.host<glm::vec4>();
        for_cells([&](int i, int j, std::size_t at) {
            now[at] = {fields_.rise.row(j)[i], fields_.qx.row(j)[i], fields_.qy.row(j)[i], now[at].w};
        });
        commands_.upload(now_);
    }

    ShallowPeak run() {
        commands_.download(peak_);
        commands_.run();
        fields_are_new_ = false;
        const float rate = std::bit_cast<float>(peak_.host<std::uint32_t>().front());
        return {rate, std::isfinite(rate)};
    }

    ShallowConstants constants_;
    ShallowSides sides_;
    int nx_, ny_;
    ShallowStart<float> start_;
    ShallowFields<float> fields_;
    bool fields_are_new_ = true;
    gpu::Pass flux_, update_, frame_;
    gpu::Buffer start_buffer_, now_, change_, flux_x_, flux_y_, peak_;
    std::optional<gpu::Pass> record_;
    std::optional<gpu::Buffer> records_buffer_;
    ShallowRecords records_;
    gpu::Commands commands_;
};

}  // namespace

std::unique_ptr<ShallowWaterModel> make_shallow_water_vulkan(const ShallowWaterSettings& settings,
                                                             std::shared_ptr<gpu::Context> context) {
    check_shallow(settings);
    return std::make_unique<ShallowModel<float>>(settings, std::make_unique<VulkanSolver>(settings, context));
}

}  // namespace waterlight
