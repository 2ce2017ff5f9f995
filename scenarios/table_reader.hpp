// The visitor that fills a scenario from TOML tables.
#pragma once

#include <toml++/toml.h>
#include <set>
#include <string>
#include <vector>

#include "scenarios/origin.hpp"
#include "scenarios/overrides.hpp"
#include "scenarios/schema.hpp"

namespace waterlight {

/// What all tables of one scenario share while it is read.
struct ReadContext {
    Origin& origin;
    const std::vector<Override>& overrides;
    const std::vector<std::string>& known;  ///< full keys of the whole schema, without indices

    /// "FILE:LINE:COL", or the last override that covers the path.
    std::string place(std::string_view path, const toml::node* node) const;
    const Override* override_of(std::string_view path) const;
};

/// Reads the keys of one table in the order of the schema; finish() then rejects keys that the schema does not have,
/// and after them those that are required and missing.
class TableReader : public Visitor {
  public:
    TableReader(ReadContext& context, const toml::table* table, std::string prefix);

    void value(const Key& key, Target target) override;
    void section(const Key& key, const Inside& inside) override;
    void optional_section(const Key& key, const Inside& inside) override;
    void list(const Key& key, const std::vector<Shape>& shapes) override;
    void finish() const;

  private:
    struct Missing {
        std::string path;
        std::string allowed;
    };

    const toml::node* take(const Key& key);
    void read_table(const toml::table* table, const std::string& path, const Inside& inside) const;
    void read_element(const toml::node& element, const std::string& path, const std::vector<Shape>& shapes) const;
    std::string path_of(std::string_view name) const;
    void reject_missing() const;
    [[noreturn]] void reject_unknown(const std::string& name, const toml::node& node) const;

    ReadContext& context_;
    const toml::table* table_;
    std::string prefix_;
    std::vector<std::string> names_;  ///< that the schema showed
    std::vector<Missing> missing_;
};

}  // namespace waterlight
