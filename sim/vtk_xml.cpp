#include "sim/vtk_xml.hpp"

#include <fmt/format.h>
#include <vtkBase64Utilities.h>
#include <vtkLZ4DataCompressor.h>
#include <vtkLZMADataCompressor.h>
#include <vtkObjectFactory.h>
#include <vtkType.h>
#include <vtkZLibDataCompressor.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <new>
#include <system_error>

#include "sim/error.hpp"
#include "sim/message.hpp"

namespace waterlight {

vtkStandardNewMacro(VtkXmlParser);

void VtkXmlParser::StartElement(const char* name, const char** attributes) {
    constexpr int deepest = 64, most_attributes = 256;
    int count = 0;
    for (const char** a = attributes; *a != nullptr; a += 2) ++count;
    if (++depth_ > deepest) beyond_bounds_ = fmt::format("has elements {} deep within one another", depth_);
    if (count > most_attributes) beyond_bounds_ = fmt::format("has an element with {} attributes", count);
    const char* none[] = {nullptr};
    const bool is_root = depth_ == 1;  // without which VTK falls
    if (beyond_bounds_.empty() || is_root) {
        vtkXMLDataParser::StartElement(name, beyond_bounds_.empty() ? attributes : none);
        kept_ = depth_;
    }
}

void VtkXmlParser::EndElement(const char* name) {
    if (depth_ == kept_) {
        vtkXMLDataParser::EndElement(name);
        --kept_;
    }
    --depth_;
}

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
    if (!parser_->beyond_bounds().empty()) reject(parser_->beyond_bounds());
    if (!parsed || !first_error_.empty()) reject("is not readable: " + complaint());
    if (attribute(root(), "type") != type) reject(fmt::format("is no VTK file of type \"{}\"", type));
    set_compressor();
}

void VtkXml::reject(const std::string& why) const {
    throw InputError(fmt::format("{}: {}", path_.string(), in_one_line(shortened(why))));
}

/// VTK's message, without the place in VTK's sources that it starts with.
std::string VtkXml::complaint() const {
    if (first_error_.empty()) return "its data are too short, or not what its header says";
    const std::size_t colon = first_error_.find("): ");
    std::string text = colon == std::string::npos ? first_error_ : first_error_.substr(colon + 3);
    while (!text.empty() && text.back() == '\n') text.pop_back();
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

namespace {

/// The words that stand before data, raw or in base64, which may be broken by blanks. UINT64_MAX past their end.
class HeaderWords {
  public:
    HeaderWords(std::istream& file, bool encoded, vtkXMLDataElement& root)
        : file_(file),
          encoded_(encoded),
          size_(VtkXml::attribute(root, "header_type") == "UInt64" ? 8 : 4),
          is_big_(VtkXml::attribute(root, "byte_order") == "BigEndian") {}

    int size() const { return size_; }
    std::uint64_t next() {
        std::uint64_t word = 0;
        for (int i = 0; i < size_; ++i) {
            const int byte = next_byte();
            if (byte < 0) return UINT64_MAX;
            word |= static_cast<std::uint64_t>(byte) << (8 * (is_big_ ? size_ - 1 - i : i));
        }
        return word;
    }

  private:
    int next_byte() {
        if (!encoded_) return file_.get();
        if (at_ == held_ && !decode()) return -1;
        return triplet_[at_++];
    }

    bool decode() {
        std::array<unsigned char, 4> letters{};
        for (unsigned char& letter : letters) {
            char c = 0;
            while (file_.get(c) && std::isspace(static_cast<unsigned char>(c)) != 0) {
            }
            letter = static_cast<unsigned char>(c);
        }
        at_ = 0;
        held_ = vtkBase64Utilities::DecodeTriplet(letters[0], letters[1], letters[2], letters[3], triplet_.data(),
                                                  &triplet_[1], &triplet_[2]);
        return file_ && held_ > 0;
    }

    std::istream& file_;
    bool encoded_;
    int size_;
    bool is_big_;
    std::array<unsigned char, 3> triplet_{};
    int at_ = 0, held_ = 0;
};

}  // namespace

/// The parser believes the sizes that stand before data, takes any memory for them, and crashes on some. They are, each
/// in a word: bytes; or, of compressed data, blocks, bytes of a block, bytes of the last if shorter, and the compressed
/// bytes of each block. `encoded`: in base64.
bool VtkXml::data_fit(std::uint64_t start, bool encoded, std::uint64_t bytes) {
    if (start >= bytes_) return false;
    const std::uint64_t left = bytes_ - start;
    file_.clear();
    file_.seekg(static_cast<std::streamoff>(start));
    HeaderWords header(file_, encoded, root());
    if (attribute(root(), "compressor").empty()) return header.next() == bytes && bytes <= left;
    const std::uint64_t blocks = header.next(), block = header.next(), last = header.next();
    constexpr std::uint64_t largest_block = std::uint64_t{1} << 32;
    if (blocks == 0 || blocks > left || block == 0 || block > largest_block || last >= block) return false;
    const std::uint64_t full = last == 0 ? blocks : blocks - 1;
    if (full > bytes / block || full * block + last != bytes) return false;
    std::uint64_t compressed = 0;
    for (std::uint64_t b = 0; b < blocks; ++b) {
        const std::uint64_t size = header.next();
        if (size > left - compressed) return false;
        compressed += size;
    }
    return true;
}

/// Where the text of an element begins.
std::uint64_t VtkXml::start_of_text(vtkXMLDataElement& array) {
    file_.clear();
    file_.seekg(static_cast<std::streamoff>(array.GetXMLByteIndex()));
    char c = 0;
    while (file_.get(c) && c != '>') {
    }
    return file_ ? static_cast<std::uint64_t>(file_.tellg()) : bytes_;
}

void VtkXml::read_words(vtkXMLDataElement& array, void* to, std::size_t count, int type) {
    const std::string_view format = attribute(array, "format");
    const std::uint64_t bytes = count * (type == VTK_DOUBLE ? sizeof(double) : sizeof(float));
    long long offset = 0;
    std::size_t read = 0;
    try {
        if (format == "ascii") {
            read = parser_->ReadInlineData(&array, 1, to, 0, count, type);
        } else if (format != "appended") {
            if (data_fit(start_of_text(array), true, bytes))
                read = parser_->ReadInlineData(&array, 0, to, 0, count, type);
        } else if (array.GetScalarAttribute("offset", offset) != 0 && offset >= 0) {
            vtkXMLDataElement* appended = find(root(), "AppendedData");
            const bool encoded = appended != nullptr && attribute(*appended, "encoding") != "raw";
            const auto start = static_cast<std::uint64_t>(parser_->appended_data_position() + offset);
            if (data_fit(start, encoded, bytes)) read = parser_->ReadAppendedData(offset, to, 0, count, type);
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
