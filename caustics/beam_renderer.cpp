#include "caustics/beam_renderer.hpp"

#include "caustics/beam_picture.hpp"

namespace waterlight {

namespace {

class BeamRendererCpu final : public BeamRenderer {
  public:
    std::string_view backend() const override { return "cpu"; }
    void draw(const BeamImageSettings& settings, const Beams& beams, BeamImage& image) override {
        draw_beams(settings, beams, image);
    }
    void fill(const Beams& beams, glm::ivec3 cells, BeamVolume& volume) override { fill_volume(beams, cells, volume); }
};

}  // namespace

std::unique_ptr<BeamRenderer> make_beam_renderer_cpu() { return std::make_unique<BeamRendererCpu>(); }

void draw_beams(BeamRenderer& renderer, const BeamImageSettings& settings, const RefinedBeams& beams,
                BeamImage& image) {
    BeamImage fine;
    renderer.draw(settings, beams.coarse, image);
    renderer.draw(settings, beams.fine, fine);
    add(fine, image);
}

}  // namespace waterlight
