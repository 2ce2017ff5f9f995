// What a session's scenario began with and what was set since: all that it takes to write it down.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenarios/scenario.hpp"

namespace waterlight {

/// Of "key=value".
inline std::string key_of(const std::string& override) { return override.substr(0, override.find('=')); }

class Edits {
  public:
    /// Of a scenario as it was read.
    explicit Edits(const Scenario& scenario) : origin_(scenario.origin) {}

    const Origin& origin() const { return origin_; }
    /// All "key=value" that were laid over the text, the later over the earlier; each key once.
    const std::vector<std::string>& overrides() const { return origin_.overrides; }
    /// Those and more; one without "=" takes back what was laid over that key and within it.
    std::vector<std::string> with(const std::vector<std::string>& more) const;
    void set(std::vector<std::string> overrides) { origin_.overrides = std::move(overrides); }

    /// A drop that fell by hand.
    void add(const Drop& drop) { drops_.push_back(drop); }
    /// The water has begun again.
    void forget_drops() { drops_.clear(); }

    /// The scenario as text; `scenario` is as it was read with overrides().
    std::string text(const Scenario& scenario) const { return text_with(scenario, {}); }
    /// The same, that finds its data where it is to lie. Throws WorldError where it cannot be written.
    void save(const Scenario& scenario, const std::filesystem::path& file) const;

  private:
    std::string text_with(const Scenario& scenario, const std::vector<std::string>& more) const;

    Origin origin_;
    std::vector<Drop> drops_;
};

}  // namespace waterlight
