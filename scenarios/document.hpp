// The schema as documentation: a table to read, JSON for programs, Markdown for the docs.
#pragma once

#include <string>
#include <vector>

namespace waterlight {

/// One key. Lists and their elements have [] in the key; `shape` is the "type" for which it holds, where there are
/// several.
struct SchemaRow {
    std::string key;
    std::string shape;
    std::string allowed;
    std::string unit;
    std::string standard;  ///< the default; "required" where there is none
    std::string meaning;
    bool is_section = false;
};

/// All keys and sections, in the order of the schema.
std::vector<SchemaRow> schema_rows();
/// Full keys, without [].
std::vector<std::string> known_keys();

std::string schema_text();
std::string schema_json();
std::string schema_markdown();

}  // namespace waterlight
