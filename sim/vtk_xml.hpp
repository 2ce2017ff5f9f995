// An XML file of VTK's, parsed without a word on the terminal.
#pragma once

#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLDataParser.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace waterlight {

/// The parser, which keeps to itself where the appended data begin. VTK's bounds neither how deep elements lie within
/// one another, and falls on some hundred thousand, nor their attributes, each of which it compares with all before.
class VtkXmlParser : public vtkXMLDataParser {
  public:
    static VtkXmlParser* New();
    vtkTypeInt64 appended_data_position() const { return AppendedDataPosition; }
    /// What is beyond bounds, from which on elements are left out; empty: nothing.
    const std::string& beyond_bounds() const { return beyond_bounds_; }

  protected:
    void StartElement(const char* name, const char** attributes) override;
    void EndElement(const char* name) override;

  private:
    int depth_ = 0, kept_ = 0;  ///< elements that are open, and those of them that are not left out
    std::string beyond_bounds_;
};

/// Elements and data of one file. vtkXMLImageDataReader, which stands on the same parser, takes missing data for zeros
/// and crashes on a short array of numbers (VTK 9.1); here the caller asks for an array and gets all of it or an error.
class VtkXml {
  public:
    /// Parses `path`, whose root must be <VTKFile type="`type`">. Throws InputError.
    VtkXml(std::filesystem::path path, std::string_view type);

    /// The first element `name` within `in`, or null.
    static vtkXMLDataElement* find(vtkXMLDataElement& in, const char* name);
    static std::vector<vtkXMLDataElement*> find_all(vtkXMLDataElement& in, std::string_view name);
    /// The attribute, or an empty text.
    static std::string_view attribute(vtkXMLDataElement& element, const char* name);

    vtkXMLDataElement& root() { return *parser_->GetRootElement(); }
    const std::filesystem::path& path() const { return path_; }
    std::uintmax_t bytes() const { return bytes_; }

    /// `count` numbers of a <DataArray>, which must be Float32 or Float64, in any format. Throws InputError.
    std::vector<float> floats(vtkXMLDataElement& array, std::size_t count);
    std::vector<double> doubles(vtkXMLDataElement& array, std::size_t count);

    /// Throws InputError "PATH: why".
    [[noreturn]] void reject(const std::string& why) const;

  private:
    template <class To>
    std::vector<To> numbers(vtkXMLDataElement& array, std::size_t count);
    void read_words(vtkXMLDataElement& array, void* to, std::size_t count, int type);
    void check_end();
    bool data_fit(std::uint64_t start, bool encoded, std::uint64_t bytes);
    std::uint64_t start_of_text(vtkXMLDataElement& array);
    void set_compressor();
    std::string complaint() const;

    std::filesystem::path path_;
    std::uintmax_t bytes_ = 0;
    std::ifstream file_;
    std::string first_error_;
    vtkNew<vtkCallbackCommand> listener_;
    vtkNew<VtkXmlParser> parser_;
};

}  // namespace waterlight
