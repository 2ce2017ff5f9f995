#include "scenarios/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "scenarios/quantities.hpp"
#include "scenarios/scenario.hpp"
#include "scenarios/schema.hpp"

namespace waterlight {

namespace {

/// The visitor that writes down what it sees.
class Documenter : public Visitor {
  public:
    Documenter(std::vector<SchemaRow>& rows, std::string prefix, std::string shape)
        : rows_(rows), prefix_(std::move(prefix)), shape_(std::move(shape)) {}

    void value(const Key& key, Target target) override {
        std::string standard = key.required ? "required" : std::string(key.otherwise);
        if (standard.empty()) standard = value_text(target);
        rows_.push_back({prefix_ + std::string(key.name), shape_, allowed(key, target), std::string(key.unit), standard,
                         std::string(key.meaning), false});
    }
    void section(const Key& key, const Inside& inside) override { add(key, "a section", "", inside); }
    void optional_section(const Key& key, const Inside& inside) override {
        const std::string word(key.otherwise);
        add(key, word.empty() ? "a section" : fmt::format("\"{}\" or a section", word), word.empty() ? "none" : word,
            inside);
    }
    void list(const Key& key, const std::vector<Shape>& shapes) override {
        const std::string path = prefix_ + std::string(key.name) + "[]";
        rows_.push_back({path, shape_, "sections", "", "none", std::string(key.meaning), true});
        for (const Shape& shape : shapes) {
            Documenter inner(rows_, path + ".", std::string(shape.type));
            if (!shape.type.empty())
                rows_.push_back({path + ".type", std::string(shape.type), fmt::format("\"{}\"", shape.type), "",
                                 "required", std::string(shape.meaning), false});
            shape.visit(inner);
        }
    }

  private:
    void add(const Key& key, const std::string& allowed_text, const std::string& standard, const Inside& inside) {
        const std::string path = prefix_ + std::string(key.name);
        rows_.push_back({path, shape_, allowed_text, "", standard, std::string(key.meaning), true});
        Documenter inner(rows_, path + ".", shape_);
        inside(inner);
    }

    std::vector<SchemaRow>& rows_;
    std::string prefix_, shape_;
};

std::string in_context(const SchemaRow& row) {
    return row.shape.empty() ? row.key : fmt::format("{} ({})", row.key, row.shape);
}

/// "a | b" would end a cell of a Markdown table.
std::string cell(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        if (c == '|') escaped += '\\';
        escaped += c;
    }
    return escaped;
}

}  // namespace

std::vector<SchemaRow> schema_rows() {
    std::vector<SchemaRow> rows;
    Scenario defaults;
    Documenter documenter(rows, "", "");
    describe(documenter, defaults);
    return rows;
}

std::vector<std::string> known_keys() {
    std::vector<std::string> keys;
    for (const SchemaRow& row : schema_rows()) {
        std::string key = row.key;
        for (std::size_t at = key.find("[]"); at != std::string::npos; at = key.find("[]")) key.erase(at, 2);
        if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
    }
    return keys;
}

std::string schema_text() {
    std::string text;
    for (const SchemaRow& row : schema_rows()) {
        if (row.is_section) {
            text += fmt::format("\n{}: {}\n", row.key, row.meaning);
            continue;
        }
        const std::string unit = row.unit.empty() ? "" : fmt::format(" [{}]", row.unit);
        text += fmt::format("  {:<44} {}\n  {:<44} {}{}; {}\n", in_context(row), row.meaning, "", row.allowed, unit,
                            row.standard);
    }
    text += "\nNumbers that a [[check]] may judge:\n";
    for (const Quantity& q : run_quantities())
        text += fmt::format("  {:<44} {}{}\n", q.name, q.meaning, q.unit.empty() ? "" : fmt::format(" [{}]", q.unit));
    for (const Quantity& q : probe_quantities())
        text += fmt::format("  {:<44} {} [{}]\n", fmt::format("probe.NAME.{}", q.name), q.meaning, q.unit);
    for (const Quantity& q : field_quantities())
        text += fmt::format("  {:<44} {}{}\n", fmt::format("{}.STATISTIC", q.name), q.meaning,
                            q.unit.empty() ? "" : fmt::format(" [{}]", q.unit));
    for (const Quantity& q : field_statistics())
        text += fmt::format("  {:<44} {}, of the difference where reference is stated\n",
                            fmt::format("FIELD.{}", q.name), q.meaning);
    return text;
}

std::string schema_json() {
    nlohmann::ordered_json document;
    for (const SchemaRow& row : schema_rows())
        document["keys"].push_back({{"key", row.key},
                                    {"type", row.shape},
                                    {"section", row.is_section},
                                    {"allowed", row.allowed},
                                    {"unit", row.unit},
                                    {"default", row.standard},
                                    {"meaning", row.meaning}});
    const auto add = [&](const std::string& prefix, const Quantity& q) {
        document["quantities"].push_back({{"name", prefix + std::string(q.name)},
                                          {"unit", std::string(q.unit)},
                                          {"meaning", std::string(q.meaning)}});
    };
    for (const Quantity& q : run_quantities()) add("", q);
    for (const Quantity& q : probe_quantities()) add("probe.NAME.", q);
    const auto list = [&](const char* name, std::span<const Quantity> quantities) {
        for (const Quantity& q : quantities)
            document[name].push_back({{"name", q.name}, {"unit", q.unit}, {"meaning", q.meaning}});
    };
    list("fields", field_quantities());
    list("statistics", field_statistics());
    return document.dump(2) + "\n";
}

std::string schema_markdown() {
    std::string text =
        "# Scenario reference\n\nPrinted by `waterlight schema --markdown` from the one table that also reads and "
        "checks "
        "scenarios.\n";
    bool in_table = false;
    for (const SchemaRow& row : schema_rows()) {
        if (row.is_section) {
            text += fmt::format("\n## {}\n\n{} {}.\n", row.key, row.meaning,
                                row.standard.empty() ? "Always holds" : fmt::format("Default: {}", row.standard));
            in_table = false;
            continue;
        }
        if (!in_table) text += "\n| key | meaning | allowed | unit | default |\n|---|---|---|---|---|\n";
        in_table = true;
        text += fmt::format("| `{}`{} | {} | {} | {} | {} |\n", row.key,
                            row.shape.empty() ? "" : fmt::format(" ({})", row.shape), cell(row.meaning),
                            cell(row.allowed), row.unit, cell(row.standard));
    }
    text += "\n## Numbers that a `[[check]]` may judge\n\n| quantity | unit | meaning |\n|---|---|---|\n";
    for (const Quantity& q : run_quantities()) text += fmt::format("| `{}` | {} | {} |\n", q.name, q.unit, q.meaning);
    for (const Quantity& q : probe_quantities())
        text += fmt::format("| `probe.NAME.{}` | {} | {} |\n", q.name, q.unit, q.meaning);
    for (const Quantity& q : field_quantities())
        text += fmt::format("| `{}.STATISTIC` | {} | {} |\n", q.name, q.unit, q.meaning);
    text +=
        "\n`STATISTIC` is one of these; of the difference where the check states a `reference`.\n\n| statistic | "
        "meaning "
        "|\n|---|---|\n";
    for (const Quantity& q : field_statistics()) text += fmt::format("| `{}` | {} |\n", q.name, q.meaning);
    return text;
}

}  // namespace waterlight
