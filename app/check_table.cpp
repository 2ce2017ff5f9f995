#include "app/check_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/process.hpp"

namespace waterlight {

namespace {

const char* word_of(Verdict verdict) {
    constexpr const char* words[] = {"passed", "FAILED", "updated", "skipped", "ERROR", "stopped"};
    return words[static_cast<int>(verdict)];
}

std::string within(const CheckOutcome& outcome) {
    return outcome.tolerance > 0 ? fmt::format(" within {:.3g}", outcome.tolerance) : "";
}

using Cells = std::vector<std::string>;

std::vector<Cells> rows_of(const std::vector<CheckItem>& items, const std::vector<ItemOutcome>& outcomes) {
    std::vector<Cells> rows{{"scenario", "check", "value", "expected", "result"}};
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (outcomes[i].checks.empty())
            rows.push_back({items[i].name, "", "", "", items[i].wrong.empty() ? "skipped" : "WRONG"});
        for (const CheckOutcome& c : outcomes[i].checks)
            rows.push_back(
                {items[i].name, c.name, fmt::format("{:.6g}", c.value), c.expected + within(c), word_of(c.verdict)});
    }
    return rows;
}

std::string counts_text(const std::vector<CheckItem>& items, const std::vector<ItemOutcome>& outcomes) {
    int count[6] = {}, all = 0, scenarios_skipped = 0, wrong = 0;
    for (std::size_t i = 0; i < items.size(); ++i) {
        wrong += items[i].wrong.empty() ? 0 : 1;
        scenarios_skipped += items[i].skipped.empty() ? 0 : 1;
        for (const CheckOutcome& c : outcomes[i].checks) {
            ++count[static_cast<int>(c.verdict)];
            ++all;
        }
    }
    std::string text = fmt::format("{} check{} of {} scenario{}: {} passed", all, all == 1 ? "" : "s", items.size(),
                                   items.size() == 1 ? "" : "s", count[0]);
    const auto add = [&text](int n, const char* what) {
        if (n > 0) text += fmt::format(", {} {}", n, what);
    };
    add(count[1], "failed");
    add(count[2], "updated");
    add(count[3], "skipped");
    add(count[4], "without a value");
    add(count[5], "stopped");
    add(scenarios_skipped, scenarios_skipped == 1 ? "scenario skipped" : "scenarios skipped");
    add(wrong, wrong == 1 ? "scenario wrong" : "scenarios wrong");
    return text;
}

}  // namespace

std::string failure_text(const CheckOutcome& outcome) {
    if (outcome.verdict == Verdict::error) return fmt::format("{}: {}", outcome.name, outcome.detail);
    const std::string detail = outcome.detail.empty() ? "" : fmt::format(" ({})", outcome.detail);
    return fmt::format("{}: value {:.9g}, expected {}{}{}", outcome.name, outcome.value, outcome.expected,
                       within(outcome), detail);
}

std::string repeat_command(const CheckItem& item, const std::string& quantity, const CheckOptions& options) {
    std::string filter;
    for (const char c : full_name(item, quantity)) {
        if (c == '*' || c == '?' || c == '[' || c == '\\') filter += '\\';
        filter += c;
    }
    std::vector<std::string> words{options.program, "check", item.file.string(), "--filter", filter};
    if (options.backend != "auto") words.insert(words.end(), {"--backend", options.backend});
    if (std::isfinite(options.timeout_s))
        words.insert(words.end(), {"--timeout", fmt::format("{}", options.timeout_s)});
    for (const std::string& override : options.overrides) words.insert(words.end(), {"--set", override});
    return shell_text(words);
}

std::string table_text(const std::vector<CheckItem>& items, const std::vector<ItemOutcome>& outcomes) {
    const std::vector<Cells> rows = rows_of(items, outcomes);
    std::vector<std::size_t> widths(rows.front().size());
    for (const Cells& row : rows)
        for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
    std::string text;
    for (const Cells& row : rows) {
        for (std::size_t k = 0; k + 1 < row.size(); ++k)
            text += k == 2 ? fmt::format("{:>{}}  ", row[k], widths[k]) : fmt::format("{:<{}}  ", row[k], widths[k]);
        text += row.back() + "\n";
    }
    return text;
}

std::string summary_text(const std::vector<CheckItem>& items, const std::vector<ItemOutcome>& outcomes,
                         const CheckOptions& options, double wall_s) {
    std::string text, skips;
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (!items[i].wrong.empty()) text += fmt::format("\nWRONG {}\n", items[i].wrong);
        if (!items[i].skipped.empty()) skips += fmt::format("skipped {}: {}\n", items[i].name, items[i].skipped);
        for (const CheckOutcome& c : outcomes[i].checks) {
            if (c.verdict == Verdict::skipped || c.verdict == Verdict::stopped)
                skips += fmt::format("{} {}: {}\n", word_of(c.verdict), full_name(items[i], c.quantity), c.detail);
            if (c.verdict != Verdict::failed && c.verdict != Verdict::error) continue;
            text += fmt::format("\n{} {}\n  {}\n  repeat: {}\n", word_of(c.verdict), c.place, failure_text(c),
                                repeat_command(items[i], c.quantity, options));
        }
    }
    return fmt::format("{}\n{}{}; {:.1f} s\n", text, skips, counts_text(items, outcomes), wall_s);
}

}  // namespace waterlight
