#include "export/vti.hpp"

#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkXMLImageDataWriter.h>

#include <cassert>
#include <cmath>
#include <numbers>

#include "export/atomic_file.hpp"

namespace waterlight {

namespace {

/// Stands between the writer's errors and VTK's printing of them; the writer's error code says what went wrong.
class Silence : public vtkCommand {
  public:
    static Silence* New() { return new Silence; }
    void Execute(vtkObject*, unsigned long, void*) override {}
};

vtkNew<vtkFloatArray> scalar(const VtiArray& from) {
    vtkNew<vtkFloatArray> array;
    const std::span<const float> values = from.components[0];
    // VTK borrows the values (save = 1) and only reads them.
    array->SetArray(const_cast<float*>(values.data()), static_cast<vtkIdType>(values.size()), 1);
    return array;
}

vtkNew<vtkFloatArray> vector(const VtiArray& from, std::size_t count) {
    vtkNew<vtkFloatArray> array;
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(static_cast<vtkIdType>(count));
    float* to = array->GetPointer(0);
    for (std::size_t c = 0; c < 3; ++c) {
        const std::span<const float> values = from.components[c];
        assert(values.empty() || values.size() == count);
        for (std::size_t i = 0; i < count; ++i) to[3 * i + c] = values.empty() ? 0.0F : values[i];
    }
    return array;
}

void place(vtkImageData& image, const VtiFrame& frame) {
    const double angle = frame.angle_deg * std::numbers::pi / 180;
    const double c = std::cos(angle), s = std::sin(angle);
    image.SetDimensions(frame.cells.x + 1, frame.cells.y + 1, frame.cells.z + 1);
    image.SetOrigin(frame.origin_m.x, frame.origin_m.y, frame.origin_m.z);
    image.SetSpacing(frame.pitch_m.x, frame.pitch_m.y, frame.pitch_m.z);
    image.SetDirectionMatrix(c, -s, 0, s, c, 0, 0, 0, 1);
}

vtkNew<vtkImageData> image_of(const VtiFrame& frame) {
    vtkNew<vtkImageData> image;
    place(*image, frame);
    for (const VtiArray& from : frame.arrays) {
        assert(from.components.size() == 1 || from.components.size() == 3);
        const bool is_scalar = from.components.size() == 1;
        assert(!is_scalar || from.components[0].size() == frame.values());
        vtkNew<vtkFloatArray> array = is_scalar ? scalar(from) : vector(from, frame.values());
        array->SetName(from.name.c_str());
        image->GetCellData()->AddArray(array);
    }
    vtkNew<vtkDoubleArray> time;
    time->SetName("TimeValue");
    time->InsertNextValue(frame.time_s);
    image->GetFieldData()->AddArray(time);
    return image;
}

void set_compression(vtkXMLImageDataWriter& writer, Compression compression) {
    switch (compression) {
        case Compression::none:
            writer.SetCompressorTypeToNone();
            writer.SetBlockSize(1 << 20);  // VTK's 32 KiB takes a hundred system calls a frame
            break;
        case Compression::lz4:
            writer.SetCompressorTypeToLZ4();
            break;
        case Compression::zlib:
            writer.SetCompressorTypeToZLib();
            writer.SetCompressionLevel(1);  // VTK's default of 5 saves 0.5 % more of a caustic map.
            break;
    }
}

}  // namespace

std::size_t VtiFrame::values() const {
    const auto count = [](int n) { return static_cast<std::size_t>(n > 0 ? n : 1); };
    return count(cells.x) * count(cells.y) * count(cells.z);
}

std::size_t VtiFrame::bytes() const {
    std::size_t components = 0;
    for (const VtiArray& array : arrays) components += array.components.size();
    return components * values() * sizeof(float);
}

void write_vti(const std::filesystem::path& path, const VtiFrame& frame, Compression compression) {
    PendingFile pending(path);
    const vtkNew<vtkImageData> image = image_of(frame);
    vtkNew<vtkXMLImageDataWriter> writer;
    vtkNew<Silence> silence;
    for (const auto event : {vtkCommand::ErrorEvent, vtkCommand::WarningEvent}) {
        writer->AddObserver(event, silence);
        writer->GetExecutive()->AddObserver(event, silence);
    }
    writer->SetFileName(pending.temporary().c_str());
    writer->SetInputData(image);
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    writer->SetHeaderTypeToUInt64();
    set_compression(*writer, compression);
    const bool written = writer->Write() == 1;
    const unsigned long code = writer->GetErrorCode();
    if (!written || code != vtkErrorCode::NoError) {
        throw_cannot_write(path, vtkErrorCode::GetStringFromErrorCode(code));
    }
    pending.commit();
}

}  // namespace waterlight
