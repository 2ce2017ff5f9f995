// What each method can do, and which to choose.
#include <fmt/format.h>

#include "tests/bench/methods/report.hpp"

namespace waterlight::methods {

void report_abilities() {
    fmt::print(R"(
## What each can do

| | two-pass | quads | splat | photons | beams | truth |
| --- | --- | --- | --- | --- | --- | --- |
| converges on water | `adaptive` yes, `pixel` no | yes | `jacobian` yes, `fixed` no | yes, as its noise falls | yes | yes, and says how far it is |
| receiver | flat floor, ground | flat floor | flat floor, ground | flat floor, ground | any depth, ground | flat floor |
| light | sun | sun | sun, lamps | sun, lamps | sun | sun |
| objects that stop light | yes | yes | yes | yes | yes | no |
| through glass, off mirrors | no | no | all ways, where neighbours go the same | all ways | no | no |
| light that meets the water from below | no | no | no | yes | no | no |
| water that hides or lights other water | no | no | what the light sees first | yes | what the light sees first | no |
| colour, each wavelength a map | yes | yes | yes | yes | no | no |
| the sun's disc | yes | yes | yes | no | no | no |
| its own error | by the truth | by the truth | counts of what did not land | from its passes' scatter | no | yes |
| loses light | where the window is too small; told | no | where the landing misses; told | after too many bounces; told | no | no |
| Vulkan | yes | no | yes | no | yes | no |

Which to choose:

- **waves on water, whatever the depth and resolution: two-pass, `adaptive`**, the default: below it is the fastest at
  every error but the largest, where `pixel` is. More samples a pixel before more pixels where edges must be sharp.
- **quads** where no light may be lost or laid twice at a fold, and as a check of the two-pass map by another road.
- **splat** where lamps, glass and mirrors must be followed without noise. On waves before their first focus `jacobian` is the most
  accurate of all at one sample a pixel, and slow.
- **photons** for everything: edges and corners of glass, light that meets the water from below. Its noise
  falls to a half or less with each doubling of the photons along an axis: take `passes` until its own estimate is as asked.
  A blur hides noise and widens every edge: on sharp caustics it does more harm than good.
- **beams** where the water between is wanted as well; the floor then comes with them.
- **truth** to judge the others.
)");
}

}  // namespace waterlight::methods
