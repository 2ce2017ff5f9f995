#include "app/ledger_table.hpp"

namespace waterlight {

std::vector<std::string> ledger_columns(const std::string& follower) {
    std::vector<std::string> columns;
    for (const char* name : {"incident_w", "entered_w", "reflected_w", "absorbed_w", "scattered_w", "floor_w",
                             "walls_w", "outside_w", "objects_w", "lost_w", "closure"})
        columns.push_back(follower + "." + name);
    return columns;
}

std::vector<double> ledger_row(std::span<const LightLedger> ledgers) {
    std::vector<double> row;
    for (const LightLedger& l : ledgers)
        row.insert(row.end(), {l.incident_w, l.entered_w, l.reflected_w, l.absorbed_w, l.scattered_w, l.floor_w,
                               l.walls_w, l.outside_w, l.objects_w, l.lost_w, l.closure()});
    return row;
}

}  // namespace waterlight
