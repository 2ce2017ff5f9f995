// The parts of check_combinations().
#pragma once

#include <string_view>
#include <vector>

#include "scenarios/scenario.hpp"

namespace waterlight {

/// Throws InputError where `key` is stated beside a model that does not know it.
void require_model(const Scenario& scenario, bool stated, std::string_view key, const std::vector<ModelChoice>& models);
/// Whether the scenario has ground in place of the flat floor.
bool has_ground(const Scenario& scenario);
void require_inside(const Scenario& scenario, const std::string& key, glm::dvec2 at);

/// Whether it can name a probe or an object, and what does in words.
bool is_plain_name(std::string_view name);
inline constexpr std::string_view plain_names = "letters, digits, _ and -";

/// Throws InputError where sides do not go together or with the model.
void check_sides(const Scenario& scenario);
/// Throws InputError where what only the model shallow-water knows is stated beside another, or contradicts itself.
void check_shallow(const Scenario& scenario);
/// Throws InputError where a camera or a probe in the water is stated without beams, or is not in the water.
void check_beams(const Scenario& scenario);
/// Throws InputError where a picture of the scene is asked for without a camera, or what it is to show is not there.
void check_picture(const Scenario& scenario);
/// Throws InputError where a check names what the run does not have, or contradicts itself.
void check_checks(const Scenario& scenario);
/// Throws InputError where the sun's disc or light in colour is stated beside what does not know it, or lists of one
/// value a wavelength are not.
void check_light(const Scenario& scenario);

/// Throws InputError where objects contradict themselves, or objects or a lamp are stated beside what does not know
/// them.
void check_objects(const Scenario& scenario);

}  // namespace waterlight
