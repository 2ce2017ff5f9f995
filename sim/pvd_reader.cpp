#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "sim/vti_reader.hpp"
#include "sim/vtk_xml.hpp"

namespace waterlight {

namespace {

TimedFile timed_file(const VtkXml& collection, vtkXMLDataElement& element) {
    const std::string_view time = VtkXml::attribute(element, "timestep"), file = VtkXml::attribute(element, "file");
    if (time.empty() || file.empty()) collection.reject("has a DataSet without timestep or file");
    double time_s = 0;
    const auto [end, error] = std::from_chars(time.data(), time.data() + time.size(), time_s);
    if (error != std::errc() || end != time.data() + time.size() || !std::isfinite(time_s)) {
        collection.reject(fmt::format("has a DataSet with timestep \"{}\", which is no time", time));
    }
    return {time_s, collection.path().parent_path() / file};
}

}  // namespace

std::vector<TimedFile> read_pvd(const std::filesystem::path& path) {
    VtkXml file(path, "Collection");
    vtkXMLDataElement* collection = VtkXml::find(file.root(), "Collection");
    std::vector<TimedFile> files;
    if (collection != nullptr) {
        for (vtkXMLDataElement* element : VtkXml::find_all(*collection, "DataSet")) {
            files.push_back(timed_file(file, *element));
        }
    }
    if (files.empty()) file.reject("lists no files");
    std::stable_sort(files.begin(), files.end(), [](auto& a, auto& b) { return a.time_s < b.time_s; });
    return files;
}

}  // namespace waterlight
