#include "render/passes/ground.hpp"

#include "shaders/ground.hpp"
#include "shaders/ground_mesh.hpp"

namespace waterlight {

GroundPass::GroundPass(std::shared_ptr<gpu::Context> context)
    : pass_(std::move(context), surface_settings("ground", shaders::ground_mesh, shaders::ground)) {}

void GroundPass::record(const Frame& frame, const WaterMeshes& planned) {
    gpu::Raster& raster = pass_.bound(frame, frame.variant);
    for (const WaterMesh& mesh : planned.ground)
        frame.commands.draw(raster, frame.radiance, strips_of(mesh), mesh_parameters(frame.view, mesh));
}

}  // namespace waterlight
