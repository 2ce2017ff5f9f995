// ESRI ASCII grids:
// https://desktop.arcgis.com/en/arcmap/latest/manage-data/raster-and-images/esri-ascii-raster-format.htm
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "sim/ground_mixer.hpp"
#include "sim/ground_readers.hpp"
#include "sim/text_file.hpp"

namespace waterlight {

namespace {

constexpr const char* known_keys[] = {"ncols",     "nrows",    "xllcorner", "xllcenter", "yllcorner",
                                      "yllcenter", "cellsize", "dx",        "dy",        "nodata_value"};

/// The words before the first number that is no key's.
class EsriHeader {
  public:
    explicit EsriHeader(TextFile& file) : file_(file) {
        std::optional<std::string_view> word;
        while ((word = file.next_word()) && !number_in(*word)) read_key(*word);
        first_value_ = word.value_or("");
    }

    std::optional<double> find(const std::string& key) const {
        const auto found = values_.find(key);
        return found != values_.end() ? std::optional(found->second) : std::nullopt;
    }

    double get(const std::string& key) const {
        const std::optional<double> value = find(key);
        if (!value) file_.reject(fmt::format("the header of an ESRI ASCII grid lacks {}", key));
        return *value;
    }

    /// Of columns or rows; its cells must fit in the file.
    int count(const std::string& key) const {
        const double value = get(key);
        // A cell takes a digit and a blank.
        const double most = std::min(static_cast<double>(file_.bytes()) / 2 + 1,
                                     static_cast<double>(std::numeric_limits<int>::max()) - 1);
        if (value >= 1 && value <= most && value == std::floor(value)) return static_cast<int>(value);
        file_.reject(fmt::format("{} must be a whole number from 1 to what its {} bytes can hold, found {:g}", key,
                                 file_.bytes(), value));
    }

    /// The centre of the first column or row.
    double first_centre(const std::string& axis, double spacing) const {
        const std::optional<double> corner = find(axis + "llcorner");
        return corner ? *corner + spacing / 2 : get(axis + "llcenter");
    }

    /// The number that ended the header, as text; empty where the file ended.
    const std::string& first_value() const { return first_value_; }

  private:
    void read_key(std::string_view word) {
        const std::string key = lower_case(word), shown = quoted(word);
        if (std::ranges::find(known_keys, key) == std::end(known_keys)) {
            file_.fail(
                fmt::format("found {}; a number or one of ncols, nrows, xllcorner, xllcenter, yllcorner, "
                            "yllcenter, cellsize, dx, dy and NODATA_value is wanted",
                            shown));
        }
        const std::optional<std::string_view> text = file_.next_word();
        const std::optional<double> value = text ? number_in(*text) : std::nullopt;
        if (!value || (!std::isfinite(*value) && key != "nodata_value")) {
            file_.fail(fmt::format("{} must be a finite number, found {}", key, quoted(text.value_or(""))));
        }
        if (!values_.emplace(key, *value).second) file_.fail(fmt::format("{} is there twice", key));
    }

    TextFile& file_;
    std::map<std::string, double> values_;
    std::string first_value_;
};

/// Rows are numbered from the south, as y rises.
Lattice lattice_of(const EsriHeader& header, const TextFile& file) {
    Lattice lattice;
    lattice.nx = header.count("ncols");
    lattice.ny = header.count("nrows");
    const double cells = static_cast<double>(lattice.nx) * lattice.ny;
    if (cells > static_cast<double>(file.bytes()) / 2 + 1) {
        file.reject(fmt::format("claims {:g} cells, more than its {} bytes can hold", cells, file.bytes()));
    }
    const std::optional<double> dx = header.find("dx"), dy = header.find("dy");
    lattice.dx_m = dx ? *dx : header.get("cellsize");
    lattice.dy_m = dy ? *dy : header.get("cellsize");
    if (lattice.dx_m <= 0 || lattice.dy_m <= 0) {
        file.reject(fmt::format("cellsize must be above 0, found {:g}", std::min(lattice.dx_m, lattice.dy_m)));
    }
    lattice.x0_m = header.first_centre("x", lattice.dx_m);
    lattice.y0_m = header.first_centre("y", lattice.dy_m);
    return lattice;
}

/// The values of the cells in the file's order, of which the header has read the first.
class EsriValues {
  public:
    EsriValues(TextFile& file, const EsriHeader& header, const Lattice& lattice)
        : file_(file), first_(header.first_value()), announced_(static_cast<long long>(lattice.nx) * lattice.ny) {}

    double next() {
        const std::string first = std::exchange(first_, {});
        const std::optional<std::string_view> word = first.empty() ? file_.next_word() : first;
        if (!word) file_.reject(fmt::format("ends after {} of {} values", found_, announced_));
        const std::optional<double> value = number_in(*word);
        if (!value) file_.fail(fmt::format("a height is wanted, found {}", quoted(*word)));
        ++found_;
        return *value;
    }

    void expect_end() {
        if (const auto word = file_.next_word()) {
            file_.fail(fmt::format("goes on with {} after the {} values announced", quoted(*word), announced_));
        }
    }

  private:
    TextFile& file_;
    std::string first_;
    long long announced_ = 0, found_ = 0;
};

}  // namespace

Field<double> read_ground_esri(const GroundFile& file, const Grid& grid) {
    TextFile text(file.path);
    const EsriHeader header(text);
    const Lattice lattice = lattice_of(header, text);
    const double no_data = header.find("nodata_value").value_or(-9999);
    GroundMixer mixer(file, lattice, grid);
    EsriValues values(text, header, lattice);
    for (int row = lattice.ny - 1; row >= 0; --row) {
        for (int column = 0; column < lattice.nx; ++column) {
            const double value = values.next();
            const bool is_missing = value == no_data || (std::isnan(value) && std::isnan(no_data));
            if (!is_missing && !std::isfinite(value)) {
                text.fail(
                    fmt::format("heights must be finite numbers, found {} at {}", value, mixer.place(column, row)));
            }
            if (!is_missing) mixer.add(column, row, value);
            if (is_missing && file.outside == OutsideFile::refuse && mixer.needs(column, row)) {
                text.fail(
                    fmt::format("found no data ({:g}) at {}; outside = \"extend\" would take the nearest data "
                                "there",
                                value, mixer.place(column, row)));
            }
        }
    }
    values.expect_end();
    return mixer.heights();
}

}  // namespace waterlight
