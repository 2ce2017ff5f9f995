#include "render/passes/water.hpp"

#include "shaders/water.hpp"
#include "shaders/water_mesh.hpp"

namespace waterlight {

namespace {

PassParameters mesh_parameters(const PassParameters& view, const WaterMesh& mesh) {
    PassParameters p = view;
    p.u0 = mesh.rectangle.x;
    p.v0 = mesh.rectangle.y;
    p.u1 = mesh.rectangle.z;
    p.v1 = mesh.rectangle.w;
    p.columns = mesh.columns;
    p.rows = mesh.rows;
    p.level_offset = mesh.level.offset;
    p.level_nx = mesh.level.nx;
    p.level_ny = mesh.level.ny;
    p.level_scale = mesh.level.scale;
    p.first_copy = mesh.first_copy;
    return p;
}

}  // namespace

WaterPass::WaterPass(std::shared_ptr<gpu::Context> context)
    : pass_(std::move(context), surface_settings("water", shaders::water_mesh, shaders::water)) {}

void WaterPass::record(const Frame& frame, const WaterMeshes& planned) {
    for (const WaterMesh& mesh : planned.meshes) {
        Variant variant = frame.variant;
        variant.coarse = mesh.coarse;
        const gpu::Strips strips{static_cast<std::uint32_t>(mesh.copies * mesh.rows),
                                 2 * static_cast<std::uint32_t>(mesh.columns + 1)};
        frame.commands.draw(pass_.bound(frame, variant), frame.radiance, strips, mesh_parameters(frame.view, mesh));
    }
}

}  // namespace waterlight
