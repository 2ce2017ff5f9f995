#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfVecAttribute.h>
#include <gtest/gtest.h>

#include <cstring>

#include "export/exr.hpp"
#include "tests/unit/export_support.hpp"

namespace waterlight::testing {
namespace {

TEST(Exr, EveryBitComesBackWithTheTopRowFirst) {
    const TemporaryFolder folder;
    const Field<float> field = noise(123, 45, 5);
    write_exr(folder / "f.exr", field, {"irradiance", "W/m2", 1.0 / 3, {0.1, 0.2}});

    Imf::InputFile file((folder / "f.exr").c_str());
    const Imf::Header& header = file.header();
    EXPECT_EQ(header.typedAttribute<Imf::StringAttribute>("quantity").value(), "irradiance");
    EXPECT_EQ(header.typedAttribute<Imf::StringAttribute>("unit").value(), "W/m2");
    EXPECT_EQ(header.typedAttribute<Imf::DoubleAttribute>("time_s").value(), 1.0 / 3);
    EXPECT_EQ(header.typedAttribute<Imf::V2dAttribute>("pitch_m").value(), Imath::V2d(0.1, 0.2));
    EXPECT_FLOAT_EQ(header.pixelAspectRatio(), 0.5F);
    EXPECT_EQ(header.channels()["Y"].type, Imf::FLOAT);

    Field<float> read(123, 45);
    Imf::FrameBuffer buffer;
    buffer.insert("Y",
                  Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(read.data()), sizeof(float), 123 * sizeof(float)));
    file.setFrameBuffer(buffer);
    file.readPixels(0, 44);
    for (int j = 0; j < 45; ++j) {
        EXPECT_EQ(std::memcmp(read.row(j), field.row(44 - j), 123 * sizeof(float)), 0) << "row " << j;
    }
}

}  // namespace
}  // namespace waterlight::testing
