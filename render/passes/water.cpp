#include "render/passes/water.hpp"

#include "shaders/water.hpp"
#include "shaders/water_mesh.hpp"

namespace waterlight {

WaterPass::WaterPass(std::shared_ptr<gpu::Context> context)
    : pass_(std::move(context), surface_settings("water", shaders::water_mesh, shaders::water)) {}

void WaterPass::record(const Frame& frame, const WaterMeshes& planned) {
    for (const WaterMesh& mesh : planned.meshes) {
        Variant variant = frame.variant;
        variant.coarse = mesh.coarse;
        frame.commands.draw(pass_.bound(frame, variant), frame.radiance, strips_of(mesh),
                            mesh_parameters(frame.view, mesh));
    }
}

}  // namespace waterlight
