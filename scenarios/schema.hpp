// What a scenario may say. schema.cpp states every key once; a visitor makes of that a reader (reader.cpp) or the
// documentation (document.cpp).
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace waterlight {

struct Scenario;
struct Resolution;

/// Numbers from low to high, each end included unless excluded.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool excludes_low = false;
    bool excludes_high = false;

    bool contains(double x) const;
    /// "> 0", "in [0, 90]"; empty where any finite number is meant.
    std::string text() const;
};

/// What is said about a key or a section.
struct Key {
    std::string_view name;
    std::string_view unit = {};
    std::string_view meaning = {};
    Range range = {};
    bool required = false;
    std::string_view otherwise = {};  ///< what holds where the key is absent, where that is not the value itself
};

/// One word of a few, kept as an index (of an enumeration).
struct Choice {
    std::vector<std::string_view> names;
    int selected = 0;
    std::function<void(int)> select;
};

/// A list of words of a few.
struct Words {
    std::vector<std::string_view> names;
    std::vector<std::string>* values = nullptr;
};

/// Where the value of a key goes.
using Target = std::variant<double*, std::optional<double>*, int*, std::uint64_t*, bool*, std::string*,
                            std::optional<std::string>*, glm::dvec2*, std::optional<glm::dvec2>*, glm::ivec2*,
                            glm::dvec3*, std::optional<glm::ivec3>*, std::vector<double>*, std::vector<std::string>*,
                            std::vector<Resolution>*, Choice, Words>;

/// "number > 0", "two integers, each in [1, 1048576]", "one of wall, periodic".
std::string allowed(const Key& key, const Target& target);
/// The present value as TOML; empty for an optional without a value.
std::string value_text(const Target& target);

class Visitor {
  public:
    using Inside = std::function<void(Visitor&)>;
    /// A shape that an element of a list may take. visit() describes one new element and appends it.
    struct Shape {
        std::string_view type;  ///< the value of its key "type"; empty where there is only one shape
        std::string_view meaning;
        Inside visit;
    };

    virtual ~Visitor() = default;
    virtual void value(const Key& key, Target target) = 0;
    /// A section that always holds, stated or not.
    virtual void section(const Key& key, const Inside& inside) = 0;
    /// A section that counts only where it is stated; key.otherwise may be a word that says "not stated".
    virtual void optional_section(const Key& key, const Inside& inside) = 0;
    /// [[name]]
    virtual void list(const Key& key, const std::vector<Shape>& shapes) = 0;
};

/// Shows the visitor every key of a scenario.
void describe(Visitor& visitor, Scenario& scenario);

}  // namespace waterlight
