#include "app/junit.hpp"

#include <fmt/format.h>

#include <string_view>

#include "app/check_table.hpp"

namespace waterlight {

namespace {

/// Length in bytes of the character of XML that the text starts with, if it is one beyond ASCII in UTF-8; else 0.
std::size_t utf8_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
    const unsigned first = byte(0), second = byte(1);
    const std::size_t length = first >= 0xf5 ? 0 : first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : first >= 0xc2 ? 2 : 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xc0) != 0x80) return 0;
    const bool overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
    const bool no_character = (first == 0xed && second >= 0xa0) || (first == 0xf4 && second >= 0x90) ||
                              (first == 0xef && second == 0xbf && byte(2) >= 0xbe);
    return overlong || no_character ? 0 : length;
}

/// XML 1.0 has no way to write most control characters; they and bytes that are not UTF-8 are replaced.
std::string escaped(std::string_view text) {
    std::string xml;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        const std::size_t length = utf8_length(text.substr(i));
        if (length > 0) {
            xml += text.substr(i, length);
            i += length - 1;
        } else if (std::string_view("&<>\"\n\t").find(text[i]) != std::string_view::npos) {
            xml += fmt::format("&#{};", c);
        } else if (c < 0x20 || c >= 0x7f) {
            xml += "\ufffd";
        } else {
            xml += text[i];
        }
    }
    return xml;
}

/// JUnit has no other word for what was not judged through no fault of its own.
bool is_skipped(const CheckOutcome& outcome) {
    return outcome.verdict == Verdict::skipped || outcome.verdict == Verdict::stopped;
}

struct Case {
    const CheckItem& item;
    const CheckOutcome& outcome;
    const CheckOptions& options;

    std::string name() const { return fmt::format("{} {}", outcome.name, outcome.expected); }
    std::string body() const {
        const std::string message = escaped(failure_text(outcome));
        if (outcome.verdict == Verdict::passed || outcome.verdict == Verdict::updated) return {};
        if (is_skipped(outcome)) return fmt::format("      <skipped message=\"{}\"/>\n", escaped(outcome.detail));
        const char* kind = outcome.verdict == Verdict::error ? "error" : "failure";
        const std::string text = fmt::format("{}\n{}", outcome.place, repeat_command(item, outcome.quantity, options));
        return fmt::format("      <{} message=\"{}\" type=\"check\">{}</{}>\n", kind, message, escaped(text), kind);
    }
    std::string xml() const {
        const std::string inside = body();
        const std::string text = fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\"",
                                             escaped(item.name), escaped(name()), outcome.wall_s);
        return text + (inside.empty() ? "/>\n" : fmt::format(">\n{}    </testcase>\n", inside));
    }
};

/// A scenario that did not run has one testcase that says why.
std::string instead_of_cases(const CheckItem& item) {
    const bool wrong = !item.wrong.empty();
    return fmt::format(
        "    <testcase classname=\"{}\" name=\"scenario\" time=\"0\">\n      <{} message=\"{}\"/>\n    </testcase>\n",
        escaped(item.name), wrong ? "error" : "skipped", escaped(wrong ? item.wrong : item.skipped));
}

struct Counts {
    int tests = 0, failures = 0, errors = 0, skipped = 0;

    void add(const CheckItem& item, const ItemOutcome& outcome) {
        if (outcome.checks.empty()) {
            ++tests;
            ++(item.wrong.empty() ? skipped : errors);
        }
        for (const CheckOutcome& check : outcome.checks) {
            ++tests;
            failures += check.verdict == Verdict::failed ? 1 : 0;
            errors += check.verdict == Verdict::error ? 1 : 0;
            skipped += is_skipped(check) ? 1 : 0;
        }
    }
    std::string attributes(double wall_s) const {
        return fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" time=\"{:.3f}\"", tests, failures,
                           errors, skipped, wall_s);
    }
};

std::string suite_xml(const CheckItem& item, const ItemOutcome& outcome, const CheckOptions& options) {
    Counts counts;
    counts.add(item, outcome);
    std::string text = fmt::format("  <testsuite name=\"{}\" file=\"{}\" {}>\n", escaped(item.name),
                                   escaped(item.file.string()), counts.attributes(outcome.wall_s));
    if (outcome.checks.empty()) text += instead_of_cases(item);
    for (const CheckOutcome& check : outcome.checks) text += Case{item, check, options}.xml();
    if (!outcome.log.empty()) text += fmt::format("    <system-err>{}</system-err>\n", escaped(outcome.log));
    return text + "  </testsuite>\n";
}

}  // namespace

std::string junit_xml(const std::vector<CheckItem>& items, const std::vector<ItemOutcome>& outcomes,
                      const CheckOptions& options, double wall_s) {
    Counts all;
    std::string suites;
    for (std::size_t i = 0; i < items.size(); ++i) {
        all.add(items[i], outcomes[i]);
        suites += suite_xml(items[i], outcomes[i], options);
    }
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"waterlight\" {}>\n{}</testsuites>\n",
        all.attributes(wall_s), suites);
}

}  // namespace waterlight
