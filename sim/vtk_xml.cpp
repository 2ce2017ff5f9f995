#include "sim/vtk_xml.hpp"

#include <fmt/format.h>
#include <vtkLZ4DataCompressor.h>
#include <vtkLZMADataCompressor.h>
#include <vtkObjectFactory.h>
#include <vtkType.h>
#include <vtkZLibDataCompressor.h>

#include <algorithm>
#include <array>
#include <new>
#include <system_error>

#include "sim/error.hpp"

namespace waterlight {

vtkStandardNewMacro(VtkXmlParser);

VtkXml::VtkXml(std::filesystem::path path, std::string_view type) : path_(std::move(path)) {
    std::error_code error;
    bytes_ = std::filesystem::file_size(path_, error);
    if (error) reject("cannot be read: " + error.message());
    file_.open(path_, std::ios::binary);
    check_end();
    listener_->SetClientData(&first_error_);
    listener_->SetCallback([](vtkObject*, unsigned long event, void* client, void* text) {
        auto& first = *static_cast<std::string*>(client);
        if (event == vtkCommand::ErrorEvent && first.empty()) first = static_cast<const char*>(text);
    });
    parser_->AddObserver(vtkCommand::ErrorEvent, listener_);
    parser_->AddObserver(vtkCommand::WarningEvent, listener_);
    parser_->SetStream(&file_);
    const bool parsed = parser_->Parse() != 0;
    if (!parsed || !first_error_.empty()) reject("is not readable: " + complaint());
    if (attribute(root(), "type") != type) reject(fmt::format("is no VTK file of type \"{}\"", type));
    set_compressor();
}

void VtkXml::reject(const std::string& why) const { throw InputError(fmt::format("{}: {}", path_.string(), why)); }

/// VTK's message on one line, without the place in VTK's sources that it starts with.
std::string VtkXml::complaint() const {
    if (first_error_.empty()) return "its data are too short, or not what its header says";
    const std::size_t colon = first_error_.find("): ");
    std::string text = colon == std::string::npos ? first_error_ : first_error_.substr(colon + 3);
    while (!text.empty() && text.back() == '\n') text.pop_back();
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

/// Raw data may be cut without the parser noticing; the last tag of the file tells whether it is all there.
void VtkXml::check_end() {
    constexpr std::string_view last_tag = "</VTKFile>";
    constexpr std::uintmax_t longest_tail = 64;
    std::string tail(std::min(bytes_, longest_tail), '\0');
    file_.seekg(static_cast<std::streamoff>(bytes_ - tail.size()));
    if (!file_.read(tail.data(), static_cast<std::streamsize>(tail.size()))) reject("cannot be opened for reading");
    const std::size_t last = tail.find_last_not_of(" \t\r\n");
    if (last == std::string::npos || !std::string_view(tail).substr(0, last + 1).ends_with(last_tag)) {
        reject("is cut short or no VTK file: it does not end with </VTKFile>");
    }
    file_.seekg(0);
}

void VtkXml::set_compressor() {
    const std::string_view name = attribute(root(), "compressor");
    const auto use = [&](vtkDataCompressor* compressor) {
        compressor->AddObserver(vtkCommand::ErrorEvent, listener_);
        parser_->SetCompressor(compressor);
    };
    if (name == "vtkZLibDataCompressor") {
        use(vtkNew<vtkZLibDataCompressor>());
    } else if (name == "vtkLZ4DataCompressor") {
        use(vtkNew<vtkLZ4DataCompressor>());
    } else if (name == "vtkLZMADataCompressor") {
        use(vtkNew<vtkLZMADataCompressor>());
    } else if (!name.empty()) {
        reject(fmt::format("is compressed by \"{}\", which is not known", name));
    }
}

vtkXMLDataElement* VtkXml::find(vtkXMLDataElement& in, const char* name) { return in.FindNestedElementWithName(name); }

std::vector<vtkXMLDataElement*> VtkXml::find_all(vtkXMLDataElement& in, std::string_view name) {
    std::vector<vtkXMLDataElement*> found;
    for (int i = 0; i < in.GetNumberOfNestedElements(); ++i) {
        vtkXMLDataElement* element = in.GetNestedElement(i);
        if (name == element->GetName()) found.push_back(element);
    }
    return found;
}

std::string_view VtkXml::attribute(vtkXMLDataElement& element, const char* name) {
    const char* text = element.GetAttribute(name);
    return text != nullptr ? std::string_view(text) : std::string_view();
}

std::uint64_t VtkXml::header_word() {
    const bool wide = attribute(root(), "header_type") == "UInt64";
    std::array<unsigned char, 8> bytes{};
    if (!file_.read(reinterpret_cast<char*>(bytes.data()), wide ? 8 : 4)) return UINT64_MAX;
    if (attribute(root(), "byte_order") == "BigEndian") std::reverse(bytes.begin(), bytes.begin() + (wide ? 8 : 4));
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) word |= std::uint64_t{bytes[i]} << (8 * i);
    return word;
}

/// The parser believes the sizes that stand before raw data, and crashes on some. They are, each in a word: bytes; or,
/// of compressed data, blocks, bytes of a block, bytes of the last if shorter, and the compressed bytes of each block.
bool VtkXml::raw_data_fit(long long offset, std::uint64_t bytes) {
    const auto start =
        static_cast<std::uint64_t>(parser_->appended_data_position()) + static_cast<std::uint64_t>(offset);
    if (offset < 0 || start >= bytes_) return false;
    const std::uint64_t left = bytes_ - start;
    file_.clear();
    file_.seekg(static_cast<std::streamoff>(start));
    if (attribute(root(), "compressor").empty()) return header_word() == bytes && bytes <= left;
    const std::uint64_t blocks = header_word(), block = header_word(), last = header_word();
    constexpr std::uint64_t largest_block = std::uint64_t{1} << 32;
    if (blocks == 0 || block == 0 || block > largest_block || last >= block) return false;
    const std::uint64_t full = last == 0 ? blocks : blocks - 1;
    if (full > bytes / block || full * block + last != bytes) return false;
    std::uint64_t compressed = 0;
    for (std::uint64_t b = 0; b < blocks; ++b) {
        const std::uint64_t size = header_word();
        if (size > left - compressed) return false;
        compressed += size;
    }
    return true;
}

void VtkXml::read_words(vtkXMLDataElement& array, void* to, std::size_t count, int type) {
    const std::string_view format = attribute(array, "format");
    vtkXMLDataElement* appended = find(root(), "AppendedData");
    const bool is_raw = appended != nullptr && attribute(*appended, "encoding") == "raw";
    const std::uint64_t bytes = count * (type == VTK_DOUBLE ? sizeof(double) : sizeof(float));
    long long offset = 0;
    std::size_t read = 0;
    try {
        if (format != "appended") {
            read = parser_->ReadInlineData(&array, format == "ascii" ? 1 : 0, to, 0, count, type);
        } else if (array.GetScalarAttribute("offset", offset) != 0 && (!is_raw || raw_data_fit(offset, bytes))) {
            read = parser_->ReadAppendedData(offset, to, 0, count, type);
        }
    } catch (const std::bad_alloc&) {
        read = 0;  // A size in the data that no memory could hold.
    }
    if (read != count || !first_error_.empty()) {
        reject(fmt::format("array \"{}\" cannot be read whole: {}", attribute(array, "Name"), complaint()));
    }
}

template <class To>
std::vector<To> VtkXml::numbers(vtkXMLDataElement& array, std::size_t count) {
    const auto read_as = [&](auto word, int type) {
        std::vector<decltype(word)> words(count);
        read_words(array, words.data(), count, type);
        return std::vector<To>(words.begin(), words.end());
    };
    const std::string_view type = attribute(array, "type");
    if (type == "Float32") return read_as(float{}, VTK_FLOAT);
    if (type == "Float64") return read_as(double{}, VTK_DOUBLE);
    reject(fmt::format("array \"{}\" is of type {}; Float32 or Float64 is wanted", attribute(array, "Name"), type));
}

std::vector<float> VtkXml::floats(vtkXMLDataElement& array, std::size_t count) { return numbers<float>(array, count); }

std::vector<double> VtkXml::doubles(vtkXMLDataElement& array, std::size_t count) {
    return numbers<double>(array, count);
}

}  // namespace waterlight
