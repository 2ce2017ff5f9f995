// What a scenario says of objects, lamps and the methods that follow light to them.
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "scenarios/build.hpp"
#include "scenarios/resolve.hpp"
#include "scenarios/rewrite.hpp"
#include "tests/unit/scenario_support.hpp"

namespace waterlight::test {
namespace {

const std::string photons = floor_map + "method = \"photons\"\n";
const std::string ball = "[[object]]\ntype = \"sphere\"\nname = \"ball\"\ncentre_m = [4, 3, -1]\n";

TEST(ScenarioObjects, EachShapeHasItsKeys) {
    const Scenario s =
        parse(least +
              "[[object]]\ntype = \"sphere\"\nname = \"a\"\nradius_m = 0.25\ncentre_m = [1, 2, -1]\nrotation_deg = [0, "
              "90, 0]\n"
              "material = { type = \"glass\", index = 1.52, abbe_number = 59.0, absorption_per_m = 0.1 }\n"
              "[[object]]\ntype = \"box\"\nname = \"b\"\nsize_m = [1, 2, 3]\ncentre_m = [0, 0, 1]\n"
              "[object.material]\ntype = \"mirror\"\nreflectance = 0.9\n"
              "[[object]]\ntype = \"ring\"\nname = \"c\"\ninner_radius_m = 0.5\nouter_radius_m = 0.6\nheight_m = 0.3\n"
              "path = [{ time_s = 0, centre_m = [1, 1, 0] }, { time_s = 2.5, centre_m = [2, 1, 0] }]\n"
              "[[object]]\ntype = \"cup\"\nname = \"d\"\nbottom_radius_m = 0.2\ntop_radius_m = 0.3\nheight_m = 0.7\n"
              "wall_m = 0.02\nbase_m = 0.04\ncentre_m = [0, 0, 0]\n"
              "[[object]]\ntype = \"mesh\"\nname = \"e\"\nfile = \"bunny.ply\"\nscale = 0.01\nsmooth = true\n"
              "[[object.path]]\ntime_s = 1\ncentre_m = [3, 3, 0]\n");
    ASSERT_EQ(s.objects.size(), 5U);
    const Object& a = s.objects[0].object;
    EXPECT_EQ(std::get<Sphere>(a.shape).radius_m, 0.25);
    EXPECT_EQ(a.centre_m, glm::dvec3(1, 2, -1));
    EXPECT_EQ(a.rotation_deg, glm::dvec3(0, 90, 0));
    EXPECT_EQ(a.material.type, Material::Type::glass);
    EXPECT_EQ(a.material.index, 1.52);
    EXPECT_EQ(a.material.abbe_number, 59.0);
    EXPECT_EQ(a.material.absorption_per_m, 0.1);
    EXPECT_EQ(std::get<Box>(s.objects[1].object.shape).size_m, glm::dvec3(1, 2, 3));
    EXPECT_EQ(s.objects[1].object.material.type, Material::Type::mirror);
    EXPECT_EQ(s.objects[1].object.material.reflectance, 0.9);
    const Object& c = s.objects[2].object;
    EXPECT_EQ(std::get<Ring>(c.shape).outer_radius_m, 0.6);
    ASSERT_EQ(c.path.size(), 2U);
    EXPECT_EQ(c.centre_at(1.25), glm::dvec3(1.5, 1, 0));
    EXPECT_EQ(std::get<Cup>(s.objects[3].object.shape).wall_m, 0.02);
    EXPECT_EQ(s.objects[4].file, "bunny.ply");
    EXPECT_EQ(s.objects[4].file_scale, 0.01);
    EXPECT_TRUE(s.objects[4].smooth);
    EXPECT_EQ(s.objects[4].object.path.size(), 1U);
}

TEST(ScenarioObjects, LampsTakeTheSunsPlace) {
    EXPECT_FALSE(parse(least).lamp);
    EXPECT_FALSE(parse(least + "[light]\ntype = \"sun\"\nelevation_deg = 40\n").lamp);
    const Scenario s = parse(least + photons +
                             "[light]\ntype = \"spot\"\nat_m = [1, 2, 3]\ntowards_m = [4, 3, 0]\nhalf_angle_deg = 20\n"
                             "intensity_w_sr = 500\n");
    ASSERT_TRUE(s.lamp);
    EXPECT_EQ(s.lamp->type, Lamp::Type::spot);
    EXPECT_EQ(s.lamp->at_m, glm::dvec3(1, 2, 3));
    EXPECT_EQ(s.lamp->towards_m, glm::dvec3(4, 3, 0));
    EXPECT_EQ(s.lamp->half_angle_deg, 20);
    EXPECT_EQ(s.lamp->intensity_w_sr, 500);
}

TEST(ScenarioObjects, MethodsHaveTheirSections) {
    const Scenario s =
        parse(least + photons +
              "photons = { start = \"light\", branching = \"split\", map = 100, passes = 7, bounces = 3, "
              "tolerance = 0.1, blur_pixels = 1.5, seed = 9 }\n"
              "[caustics.floor.splat]\ngrid = 64\niterations = 2\nsize = \"fixed\"\n");
    EXPECT_EQ(s.floor->method, FloorMethod::photons);
    const PhotonOptions& p = s.floor->photons;
    EXPECT_EQ(p.start, PhotonOptions::Start::light);
    EXPECT_EQ(p.branching, PhotonOptions::Branching::split);
    EXPECT_EQ(p.map, 100);
    EXPECT_EQ(p.passes, 7);
    EXPECT_EQ(p.bounces, 3);
    EXPECT_EQ(p.tolerance, 0.1);
    EXPECT_EQ(p.blur_pixels, 1.5);
    EXPECT_EQ(p.seed, 9U);
    EXPECT_EQ(s.floor->splat.grid, 64);
    EXPECT_EQ(s.floor->splat.size, SplatOptions::Size::fixed);
    for (const char* name : floor_method_names)
        EXPECT_EQ(name_of(parse(least + floor_map + "method = \"" + name + "\"\n").floor->method), name);
}

TEST(ScenarioObjects, LightMeetsWhatWasRead) {
    Scenario s = parse(least + floor_map + ball);
    EXPECT_FALSE(floor_settings(s).objects) << "before read_data()";
    read_data(s);
    ASSERT_TRUE(floor_settings(s).objects);
    EXPECT_EQ(floor_settings(s).objects->objects().front().name, "ball");
}

TEST(ScenarioObjects, AreRewrittenInPlace) {
    const std::string text = least + ball + "material = { type = \"glass\" }\n";
    const std::string changed = rewritten(text, {"object[0].material.index=1.4", "object[0].radius_m=0.1",
                                                 "object[0].path=[{time_s=0, centre_m=[1, 1, 1]}]"});
    EXPECT_NE(changed.find("material = { index = 1.4, type = \"glass\" }"), std::string::npos) << changed;
    EXPECT_NE(changed.find("radius_m = 0.1"), std::string::npos) << changed;
    EXPECT_NE(changed.find("path = [{ centre_m = [1, 1, 1], time_s = 0 }]"), std::string::npos) << changed;
}

class RejectedObjects : public ::testing::TestWithParam<Bad> {};

TEST_P(RejectedObjects, NamesPlaceKeyFoundAndAllowed) { expect_rejection(GetParam()); }

#define BALL "[[object]]\ntype = \"sphere\"\nname = \"ball\"\ncentre_m = [4, 3, -1]\n"
#define MAP(method) "[caustics.floor]\npixels = [64, 48]\nmethod = \"" method "\"\n"
#define POINT "[light]\ntype = \"point\"\nat_m = [1, 1, 3]\n"

INSTANTIATE_TEST_SUITE_P(
    Scenario, RejectedObjects,
    ::testing::Values(
        Bad{"UnknownShape", "[[object]]\ntype = \"spere\"\n",
            "pool.toml:6:8: object[0].type:", "did you mean \"sphere\"?"},
        Bad{"KeyOfAnotherShape", BALL "height_m = 1\n", "pool.toml:9:12: object[0].height_m:", "an unknown key"},
        Bad{"NoName", "[[object]]\ntype = \"sphere\"\n", "pool.toml:5:1: object[0].name: found nothing", "required"},
        Bad{"NameOfSpaces", "[[object]]\ntype = \"sphere\"\nname = \"a ball\"\ncentre_m = [1, 1, 0]\n",
            "pool.toml:7:8: object[0].name: found \"a ball\"", "letters, digits"},
        Bad{"TwoOfOneName", BALL BALL, "pool.toml:11:8: object[1].name: found \"ball\" twice", "one object a name"},
        Bad{"Nowhere", "[[object]]\ntype = \"sphere\"\nname = \"ball\"\n", "pool.toml:5:1: object[0]: found neither",
            "one of both"},
        Bad{"TwicePlaced", BALL "path = [{ time_s = 0, centre_m = [1, 1, 1] }]\n",
            "pool.toml:8:12: object[0].centre_m: found it beside path", "one of both"},
        Bad{"PathBackInTime",
            "[[object]]\ntype = \"sphere\"\nname = \"ball\"\n[[object.path]]\ntime_s = 1\ncentre_m = [1, 1, "
            "1]\n[[object.path]]\ntime_s = 0.5\ncentre_m = [1, 1, 1]\n",
            "pool.toml:12:10: object[0].path[1].time_s: found 0.5", "later than the point before, 1 s"},
        Bad{"RingInsideOut",
            "[[object]]\ntype = \"ring\"\nname = \"r\"\ncentre_m = [1, 1, 0]\ninner_radius_m = 2\nouter_radius_m = 1\n",
            "pool.toml:10:18: object[0].outer_radius_m: found 1", "above inner_radius_m = 2"},
        Bad{"CupOfBaseAlone", "[[object]]\ntype = \"cup\"\nname = \"c\"\ncentre_m = [1, 1, 0]\nbase_m = 2\n",
            "pool.toml:5:1: object[0].height_m: found 1", "above base_m = 2"},
        Bad{"IndexOfAMirror", BALL "material = { type = \"mirror\", index = 1.5 }\n",
            "pool.toml:9:39: object[0].material.index: found it beside type = \"mirror\"", "type glass"},
        Bad{"ReflectanceOfGlass", BALL "material = { type = \"glass\", reflectance = 0.5 }\n",
            "pool.toml:9:44: object[0].material.reflectance:", "type diffuse or mirror"},
        Bad{"GlassThinnerThanAir", BALL "material = { type = \"glass\", index = 0.9 }\n",
            "pool.toml:9:38: object[0].material.index: found 0.9", "in [1, 4]"},
        Bad{"ObjectsOfTheTruth", MAP("truth") BALL, "pool.toml:7:10: caustics.floor.method: found \"truth\" beside",
            "two-pass, quads, splat or photons"},
        Bad{"ObjectsBeforeWalls", "[caustics.walls]\n" BALL, "pool.toml:5:1: caustics.walls: found it beside",
            "walls without objects"},
        Bad{"ObjectsAndErrors", MAP("two-pass") BALL "[accuracy]\nestimate = true\n",
            "pool.toml:13:12: accuracy.estimate:", "does not know objects"},
        Bad{"ObjectsUnderADisc", MAP("two-pass") BALL "[light]\ndisc_deg = 0.3\n",
            "pool.toml:13:12: light.disc_deg: found it beside [[object]]", "parallel light"},
        Bad{"DiscOfPhotons", MAP("photons") "[light]\ndisc_deg = 0.3\n",
            "pool.toml:9:12: light.disc_deg:", "two-pass, quads or splat"},
        Bad{"LampOfTwoPass", MAP("two-pass") POINT,
            "pool.toml:7:10: caustics.floor.method: found \"two-pass\" beside light.type = \"point\"",
            "splat or photons"},
        Bad{"LampOfQuads", MAP("quads") POINT, "pool.toml:7:10: caustics.floor.method:", "splat or photons"},
        Bad{"LampOfTruth", MAP("truth") POINT, "pool.toml:7:10: caustics.floor.method:", "splat or photons"},
        Bad{"LampOfBeams", "[caustics.beams]\n" POINT, "pool.toml:5:1: caustics.beams: found it beside", "a sun"},
        Bad{"LampOfWalls", "[caustics.walls]\n" POINT, "pool.toml:5:1: caustics.walls: found it beside", "a sun"},
        Bad{"SunsKeyOfALamp", POINT "azimuth_deg = 3\n",
            "pool.toml:8:15: light.azimuth_deg: found it beside type = ", "type sun"},
        Bad{"LampsKeyOfTheSun", "[light]\nat_m = [1, 1, 1]\n",
            "pool.toml:6:8: light.at_m: found it beside type = \"sun\"", "type point or spot"},
        Bad{"ConeOfAPoint", POINT "half_angle_deg = 3\n", "pool.toml:8:18: light.half_angle_deg:", "type spot"},
        Bad{"LampNowhere", "[light]\ntype = \"point\"\n", "pool.toml:5:1: light.at_m: found nothing", "required"},
        Bad{"SpotOfNoAxis", "[light]\ntype = \"spot\"\nat_m = [1, 1, 3]\n",
            "pool.toml:5:1: light.towards_m: found nothing", "required"},
        Bad{"SpotOnItself", "[light]\ntype = \"spot\"\nat_m = [1, 1, 3]\ntowards_m = [1, 1, 3]\n",
            "pool.toml:8:13: light.towards_m:", "another place"},
        Bad{"WindowOfQuads", MAP("quads") "window = { samples = 7 }\n",
            "pool.toml:8:10: caustics.floor.window:", "method two-pass"},
        Bad{"FootprintOfSplat", MAP("splat") "footprint = \"pixel\"\n",
            "pool.toml:8:13: caustics.floor.footprint:", "method two-pass"},
        Bad{"SamplesOfPhotons", MAP("photons") "samples_per_pixel = 2\n",
            "pool.toml:8:21: caustics.floor.samples_per_pixel:", "method two-pass or quads"},
        Bad{"ToleranceOfQuads", MAP("quads") "tolerance = 1e-3\n",
            "pool.toml:8:13: caustics.floor.tolerance:", "method truth"},
        Bad{"ErrorOfOnePass", MAP("photons") "photons = { passes = 1, tolerance = 0.1 }\n",
            "pool.toml:8:22: caustics.floor.photons.passes: found 1", "2 or more"},
        Bad{"GroundOfQuads", "[waves]\nmodel = \"shallow-water\"\n" MAP("quads") "receiver = \"ground\"\n",
            "pool.toml:10:12: caustics.floor.receiver: found ground beside", "method two-pass, splat or photons"},
        Bad{"PhotonErrorOfQuads", MAP("quads") "[[check]]\nquantity = \"floor.photon_error\"\nbelow = 1\n",
            "pool.toml:9:12: check[0].quantity:", "method photons"},
        Bad{"SplatPartsOfQuads", MAP("quads") "[[check]]\nquantity = \"floor.splat_missed\"\nbelow = 1\n",
            "pool.toml:9:12: check[0].quantity:", "method splat"},
        Bad{"QuadsOnVulkan",
            MAP("quads") "[[check]]\nquantity = \"floor.cv\"\nagrees = { backend = \"vulkan\", "
                         "tolerance = 1.0 }\n",
            "pool.toml:10:10: check[0].agrees:", "the CPU alone computes"}),
    [](const auto& bad) { return bad.param.name; });

}  // namespace
}  // namespace waterlight::test
