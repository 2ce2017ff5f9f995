// Whatever is wrong is said in one line: place, key, what was found, what is allowed.
#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "scenarios/document.hpp"
#include "scenarios/nearest.hpp"
#include "tests/unit/scenario_support.hpp"

namespace waterlight::test {
namespace {

class Rejected : public ::testing::TestWithParam<Bad> {};

TEST_P(Rejected, NamesPlaceKeyFoundAndAllowed) { expect_rejection(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Scenario, Rejected,
    ::testing::Values(
        Bad{"UnknownKey", "[light]\nheight = 3\n", "pool.toml:6:10: light.height: found an unknown key",
            "elevation_deg"},
        Bad{"TypoOfAKey", "[waves]\nduratoin_s = 3\n",
            "pool.toml:6:14: waves.duratoin_s:", "did you mean \"duration_s\"?"},
        Bad{"KeyOfAnotherSection", "[waves]\ncells = [4, 4]\n",
            "pool.toml:6:9: waves.cells:", "did you mean \"domain.cells\"?"},
        Bad{"WrongType", "[waves]\nduration_s = \"long\"\n",
            "pool.toml:6:14: waves.duration_s:", "found \"long\"; allowed: number >= 0"},
        Bad{"OutOfRange", "[light]\nelevation_deg = 91\n",
            "pool.toml:6:17: light.elevation_deg:", "found 91; allowed: number in (0, 90]"},
        Bad{"NotFinite", "[light]\nazimuth_deg = nan\n",
            "pool.toml:6:15: light.azimuth_deg:", "nan, which is not finite"},
        Bad{"WrongLength", "[caustics.floor]\npixels = [3, 4, 5]\n",
            "pool.toml:6:10: caustics.floor.pixels:", "found [3, 4, 5]; allowed: two integers"},
        Bad{"FractionOfAPixel", "[caustics.floor]\npixels = [3.5, 4]\n",
            "pool.toml:6:10: caustics.floor.pixels:", "two integers"},
        Bad{"UnknownChoice", "[waves]\nmodel = \"arry\"\n", "pool.toml:6:9: waves.model:", "did you mean \"airy\"?"},
        Bad{"UnknownFormat", "[output]\nformats = [\"gif\"]\n",
            "pool.toml:6:11: output.formats:", "list of vti, png, png16, exr"},
        Bad{"MissingKey", "[[waves.sine]]\namplitude_m = 0.1\n",
            "pool.toml:5:1: waves.sine[0].wavelength_m: found nothing", "required"},
        Bad{"MissingType", "[[waves.source]]\nat_m = [1, 1]\n",
            "pool.toml:5:1: waves.source[0].type:", "drop, rain, wavemaker"},
        Bad{"KeyOfAnotherType", "[[waves.source]]\ntype = \"drop\"\nat_m = [1, 1]\nperiod_s = 1\n",
            "pool.toml:8:12: waves.source[0].period_s:", "unknown key"},
        Bad{"SectionAsValue", "light = 3\n", "pool.toml:5:9: domain.light:", "unknown key"},
        Bad{"MalformedToml", "[waves\nmodel = 3\n", "pool.toml:5:", "malformed TOML"},
        Bad{"DuplicateKey", "depth_m = 3\n", "pool.toml:5:", "depth_m"},
        Bad{"SourceWithoutDynamics",
            "[waves]\nmodel = \"prescribed\"\n[[waves.source]]\ntype = \"drop\"\nat_m = [1, 1]\n",
            "pool.toml:7:1: waves.source:", "model linear or airy"},
        Bad{"SeaBetweenWalls", "[waves]\nboundary = { x = \"wall\" }\n[waves.spectrum]\n",
            "pool.toml:6:12: waves.boundary:", "periodic sides"},
        Bad{"TwoSeas", "[waves.spectrum]\n[waves.buoy]\nstem = \"a\"\n", "pool.toml:6:1: waves.buoy:", "one of both"},
        Bad{"CflOfAiry", "[waves]\ncfl = 0.5\n", "pool.toml:6:7: waves.cfl:", "model linear"},
        Bad{"MarginWithoutAbsorption", "[waves]\nmargin_m = 1\n", "pool.toml:6:12: waves.margin_m:", "absorbing side"},
        Bad{"OddHalfWaves",
            "[waves]\nboundary = { x = \"periodic\" }\n[[waves.standing]]\namplitude_m = 0.1\nhalf_waves_x = 3\n",
            "pool.toml:9:16: waves.standing[0].half_waves_x:", "even number"},
        Bad{"DropOutside", "[[waves.source]]\ntype = \"drop\"\nat_m = [9, 1]\n",
            "pool.toml:7:8: waves.source[0].at_m:", "[0, 8] x [0, 6] m"},
        Bad{"EvenWindow", "[caustics.floor]\npixels = [4, 4]\nwindow = { samples = 6 }\n",
            "pool.toml:7:22: caustics.floor.window.samples:", "odd"},
        Bad{"WindowOfTheTruth", "[caustics.floor]\nmethod = \"truth\"\npixels = [4, 4]\nwindow = { samples = 7 }\n",
            "pool.toml:8:10: caustics.floor.window:", "method two-pass"},
        Bad{"ProbeTwice", "[[probe]]\nname = \"a\"\nat_m = [1, 1]\n[[probe]]\nname = \"a\"\nat_m = [2, 1]\n",
            "pool.toml:9:8: probe[1].name:", "\"a\" twice"},
        Bad{"ProbeName", "[[probe]]\nname = \"a,b\"\nat_m = [1, 1]\n", "pool.toml:6:8: probe[0].name:", "letters"},
        Bad{"UnknownQuantity", "[[check]]\nquantity = \"waves.mas_drift\"\nbelow = 1\n",
            "pool.toml:6:12: check[0].quantity:", "did you mean \"waves.mass_drift\"?"},
        Bad{"QuantityWithoutFloor", "[[check]]\nquantity = \"floor.cv\"\nbelow = 1\n",
            "pool.toml:6:12: check[0].quantity:", "[caustics.floor]"},
        Bad{"CheckWithoutBound", "[[check]]\nquantity = \"waves.steps\"\n", "pool.toml:5:1: check[0]:", "below"},
        Bad{"EqualsWithoutTolerance", "[[check]]\nquantity = \"waves.steps\"\nequals = 1\n",
            "pool.toml:7:10: check[0].equals:", "tolerance"},
        Bad{"RowsRarerThanFrames", "[output]\nevery_s = 0.1\nprobe_every_s = 0.2\n",
            "pool.toml:7:17: output.probe_every_s:", "at most output.every_s = 0.1"},
        Bad{"TooManyRows", "[waves]\nduration_s = 1000\n[output]\nprobe_every_s = 1e-6\n",
            "pool.toml:8:17: output.probe_every_s:", "rows"},
        Bad{"TooManyFrames", "[waves]\nduration_s = 1e9\n", "pool.toml: output.every_s:", "frames"}),
    [](const auto& bad) { return bad.param.name; });

TEST(ScenarioErrors, UnknownKeyIsSaidBeforeTheMissingOneThatItMisspells) {
    const std::string message = rejection("[domain]\nsise_m = [1, 1]\ncells = [4, 4]\ndepth_m = 1\n");
    EXPECT_NE(message.find("did you mean \"size_m\"?"), std::string::npos) << message;
}

TEST(ScenarioErrors, NoScenarioFile) {
    try {
        read_scenario("/nowhere/pool.toml");
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_STREQ(
            error.what(),
            "/nowhere/pool.toml: scenario: found no file that can be read; allowed: the path of a scenario (.toml)");
    }
}

TEST(ScenarioErrors, ControlCharactersNeverBreakTheLine) {
    const std::string message = rejection(least + "[waves]\nmodel = \"a\\nb\\u001b[31m\"\n");
    EXPECT_TRUE(std::all_of(message.begin(), message.end(), [](char c) { return c >= ' ' && c != 0x7f; })) << message;
}

/// a.a.a ... of so many parts.
std::string dotted(std::size_t parts) {
    std::string key = "a";
    for (std::size_t n = 1; n < parts; ++n) key += ".a";
    return key;
}

TEST(ScenarioErrors, KeysOfAnyNumberOfPartsAreReadOrRejected) {
    const auto too_many = [](const std::string& text, const std::string& place) {
        const std::string message = rejection(least + text);
        return message.starts_with(place) && message.find("more than 32 parts") != std::string::npos
                   ? testing::AssertionSuccess()
                   : testing::AssertionFailure() << message.substr(0, 500);
    };
    EXPECT_NE(rejection(least + dotted(32) + " = 1\n").find("unknown key"), std::string::npos);
    EXPECT_TRUE(too_many(dotted(33) + " = 1\n", "pool.toml:5:64: "));
    for (const std::size_t parts : {1000, 1000000}) {
        const std::string key = dotted(parts);
        EXPECT_TRUE(too_many(fmt::format("{} = 1\n", key), "pool.toml:5:64: "));
        EXPECT_TRUE(too_many(fmt::format("[{}]\n", key), "pool.toml:5:65: "));
        EXPECT_TRUE(too_many(fmt::format("[[{}]]\n", key), "pool.toml:5:66: "));
        EXPECT_TRUE(too_many(fmt::format("x = {{ {} = 1 }}\n", key), "pool.toml:5:70: "));
        EXPECT_TRUE(too_many(fmt::format("title = 'it\"s # . '\n{} = 1\n", key), "pool.toml:6:64: "));
        EXPECT_TRUE(too_many(fmt::format("title = \"\"\"\na\"\"\\\"\"\"\"\"\"\n{} = 1\n", key), "pool.toml:7:64: "));
        const std::string message = rejection(least, {fmt::format("waves={{{} = 1}}", key)});
        EXPECT_NE(message.find("allowed: one TOML value"), std::string::npos) << message.substr(0, 500);
        EXPECT_NE(rejection(least, {fmt::format("{}=1", key)}).find("allowed: key=value"), std::string::npos);
    }
    // As deep as both bounds together let it be.
    std::string deep = "x = 1";
    for (int n = 0; n < 250; ++n) deep = fmt::format("{} = {{ {} }}", dotted(32), deep);
    EXPECT_NE(rejection(fmt::format("{}{}\n", least, deep)).find("unknown key"), std::string::npos);
}

TEST(ScenarioErrors, DotsThatPartNoKeyAreOfAnyNumber) {
    const std::string dots(1000, '.');
    std::string list = "[0.5";
    for (int n = 0; n < 1000; ++n) list += ", 0.5";
    for (const std::string& text :
         {"# " + dots + "\n", "[domain2] # " + dots + "\n", "title = \"" + dots + "\"\n", "title = '" + dots + "'\n",
          "title = \"\"\"\n" + dots + "\n\"\"\"\n", "x = " + list + "]\n"})
        EXPECT_EQ(rejection(least + text).find("parts"), std::string::npos) << text;
    EXPECT_EQ(rejection("title = \"\\\"" + dots + "\"\n" + least), "accepted");
}

TEST(ScenarioErrors, WhatIsFoundIsNotRepeatedAtAnyLength) {
    const std::string word(100000, 'x');
    for (const std::string& message :
         {rejection(least + "[waves]\nmodel = \"" + word + "\"\n"), rejection(least + word + " = 1\n"),
          rejection(least, {"waves.model=" + word}), rejection(least, {word + "=1"}), rejection(least, {word})}) {
        EXPECT_LT(message.size(), 2000U);
        EXPECT_NE(message.find("xxx..."), std::string::npos) << message;
    }
    std::string accents;
    for (int n = 0; n < 200; ++n) accents += "\u00e9";
    for (const std::string_view before : {"", "a"}) {
        const std::string message = rejection(least + fmt::format("[waves]\nmodel = \"{}{}\"\n", before, accents));
        EXPECT_NE(message.find("\u00e9..."), std::string::npos) << message;
    }
}

TEST(Nearest, DistanceIsASymmetricMetricWithSwaps) {
    EXPECT_EQ(edit_distance("", "abc"), 3);
    EXPECT_EQ(edit_distance("depth", "detph"), 1);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
    EXPECT_EQ(edit_distance("sitting", "kitten"), 3);
    EXPECT_EQ(nearest_word("duratoin_s", {"depth_m", "duration_s"}), "duration_s");
    EXPECT_EQ(nearest_word("quite_else", {"depth_m", "duration_s"}), "");
}

// Cut, swapped, doubled and broken texts are read or rejected in one line; nothing else may happen.
TEST(ScenarioErrors, MutatedTextsNeverBreakTheReader) {
    const std::string text =
        least +
        "[waves]\nmodel = \"airy\"\nboundary = { x = \"wall\", y = \"periodic\" }\nduration_s = 1e1\n[[waves.source]]\n"
        "type = \"drop\"\nat_m = [4.0, 3.0]\n[[waves.source]]\ntype = \"rain\"\nseed = 0x10\n[caustics.floor]\n"
        "pixels = [1024, 768]\nwindow = \"auto\"\n[[probe]]\nname = \"centre\"\nat_m = [4.0, 3.0]\n[[check]]\n"
        "quantity = \"floor.mean_irradiance\"\nequals = 850.0\nrelative_tolerance = 0.01\n";
    ASSERT_EQ(rejection(text), "accepted");
    const std::string alphabet = "[]{}=\"'.,#-+_ae019 \n\t\\\x01\x7f\xff\xc3\xa9";
    std::mt19937 random(20);
    const auto below = [&random](std::size_t n) {
        return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
    };
    int rejected = 0;
    for (int i = 0; i < 4000; ++i) {
        std::string mutated = text;
        for (std::size_t edits = 1 + below(4); edits > 0; --edits) {
            const std::size_t at = below(mutated.size());
            switch (below(4)) {
                case 0:
                    mutated[at] = alphabet[below(alphabet.size())];
                    break;
                case 1:
                    mutated.insert(at, 1, alphabet[below(alphabet.size())]);
                    break;
                case 2:
                    mutated.erase(at, 1 + below(12));
                    break;
                default:
                    mutated.insert(at, mutated.substr(below(mutated.size()), below(40)));
            }
        }
        const std::string message = rejection(mutated);
        if (message == "accepted") continue;
        ++rejected;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        EXPECT_NE(message.find("; allowed: "), std::string::npos) << message;
    }
    EXPECT_GT(rejected, 1000);
}

TEST(ScenarioErrors, MutatedOverridesNeverBreakTheReader) {
    const std::vector<std::string> seeds{"domain.cells=[8,8]", "waves.source[0].at_m=[1,1]", "waves.model=airy",
                                         "caustics.floor.window={samples=7}", "title='x'"};
    const std::string alphabet = "[]{}=\"'.,#-ae019 \n\\\xff";
    std::mt19937 random(21);
    const auto below = [&random](std::size_t n) {
        return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
    };
    for (int i = 0; i < 4000; ++i) {
        std::string override = seeds[below(seeds.size())];
        for (std::size_t edits = 1 + below(3); edits > 0; --edits)
            override.insert(below(override.size() + 1), 1, alphabet[below(alphabet.size())]);
        EXPECT_EQ(rejection(least, {override}).find('\n'), std::string::npos) << override;
    }
}

TEST(Schema, EveryKeySaysWhatItIs) {
    for (const SchemaRow& row : schema_rows()) {
        EXPECT_FALSE(row.meaning.empty()) << row.key;
        EXPECT_FALSE(row.allowed.empty()) << row.key;
        EXPECT_TRUE(row.is_section || !row.standard.empty()) << row.key;
        // The first ending that fits says the unit.
        const std::pair<const char*, const char*> endings[] = {
            {"_per_m", "1/m"}, {"_n_m", "N/m"},   {"_kg_m3", "kg/m3"}, {"_per_m2_s", "1/(m2 s)"},
            {"_m2_s", "m2/s"}, {"_m_s2", "m/s2"}, {"_m_s", "m/s"},     {"_w_m2", "W/m2"},
            {"_deg", "deg"},   {"_m", "m"},       {"_s", "s"}};
        for (const auto& [ending, unit] : endings) {
            if (!row.key.ends_with(ending)) continue;
            EXPECT_EQ(row.unit, unit) << row.key;
            break;
        }
    }
}

TEST(Schema, AllThreeFormsHaveAllKeys) {
    const std::string text = schema_text(), json = schema_json(), markdown = schema_markdown();
    for (const SchemaRow& row : schema_rows()) {
        EXPECT_NE(text.find(row.key), std::string::npos) << row.key;
        EXPECT_NE(json.find("\"" + row.key + "\""), std::string::npos) << row.key;
        EXPECT_NE(markdown.find(row.key), std::string::npos) << row.key;
    }
}

}  // namespace
}  // namespace waterlight::test
