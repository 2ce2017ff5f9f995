// Closed surfaces from .obj, .ply and .stl: the same body from each, and what is no mesh refused by name.
#include "caustics/objects/mesh_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <glm/geometric.hpp>
#include <numbers>

#include "sim/error.hpp"

namespace waterlight {
namespace {

namespace fs = std::filesystem;

class MeshFile : public ::testing::Test {
  protected:
    MeshFile() { fs::create_directories(folder_); }
    ~MeshFile() override { fs::remove_all(folder_); }

    fs::path write(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
        return folder_ / name;
    }
    /// What is said of a file with these bytes.
    std::string refusal(const std::string& name, const std::string& bytes) const {
        try {
            read_mesh(write(name, bytes));
        } catch (const InputError& error) {
            EXPECT_EQ(std::string(error.what()).rfind((folder_ / name).string() + ": ", 0), 0U) << error.what();
            return error.what();
        }
        return "read";
    }

    fs::path folder_ = fs::temp_directory_path() / fmt::format("waterlight_mesh_{}", ::getpid());
};

double volume_of(const Mesh& mesh) {
    const auto corner = [&](int k) { return mesh.corners_m[static_cast<std::size_t>(k)]; };
    double six = 0;
    for (const glm::ivec3& t : mesh.triangles) six += glm::dot(corner(t.x), glm::cross(corner(t.y), corner(t.z)));
    return six / 6;
}

const glm::dvec3 corners[8]{{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0}, {0, 0, 3}, {1, 0, 3}, {1, 2, 3}, {0, 2, 3}};
const int faces[6][4]{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

std::string with(const std::string& text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    return fmt::format("{}{}{}", text.substr(0, at), to, text.substr(at + from.size()));
}

std::string obj() {
    std::string text = "# a box\no box\n";
    for (const glm::dvec3& p : corners) text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
    for (const auto& f : faces) text += fmt::format("f {} {} {} {}\n", f[0] + 1, f[1] + 1, f[2] + 1, f[3] + 1);
    return text;
}

std::string ply_header(const char* format) {
    return fmt::format(
        "ply\nformat {} 1.0\ncomment a box\nelement vertex 8\nproperty float x\nproperty float y\nproperty float "
        "z\nelement face 6\nproperty list uchar int vertex_indices\nend_header\n",
        format);
}

std::string ply() {
    std::string text = ply_header("ascii");
    for (const glm::dvec3& p : corners) text += fmt::format("{} {} {}\n", p.x, p.y, p.z);
    for (const auto& f : faces) text += fmt::format("4 {} {} {} {}\n", f[0], f[1], f[2], f[3]);
    return text;
}

template <class T>
void put(std::string& bytes, T value) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    bytes.append(raw, sizeof(T));
}

std::string binary_ply() {
    std::string bytes = ply_header("binary_little_endian");
    for (const glm::dvec3& p : corners)
        for (int axis = 0; axis < 3; ++axis) put(bytes, static_cast<float>(p[axis]));
    for (const auto& f : faces) {
        put(bytes, static_cast<unsigned char>(4));
        for (const int k : f) put(bytes, k);
    }
    return bytes;
}

std::string stl() {
    std::string text = "solid box\n";
    for (const auto& f : faces)
        for (const int second : {1, 2}) {
            text += "facet normal 0 0 0\nouter loop\n";
            for (const int k : {f[0], f[second], f[second + 1]})
                text += fmt::format("vertex {} {} {}\n", corners[k].x, corners[k].y, corners[k].z);
            text += "endloop\nendfacet\n";
        }
    return text + "endsolid box\n";
}

std::string binary_stl() {
    std::string bytes(80, ' ');
    put(bytes, std::uint32_t{12});
    for (const auto& f : faces)
        for (const int second : {1, 2}) {
            for (int k = 0; k < 3; ++k) put(bytes, 0.0F);
            for (const int k : {f[0], f[second], f[second + 1]})
                for (int axis = 0; axis < 3; ++axis) put(bytes, static_cast<float>(corners[k][axis]));
            put(bytes, std::uint16_t{0});
        }
    return bytes;
}

TEST_F(MeshFile, EachFormatGivesTheSameClosedBody) {
    const std::pair<const char*, std::string> all[]{
        {"a.obj", obj()}, {"b.ply", ply()}, {"c.PLY", binary_ply()}, {"d.stl", stl()}, {"e.stl", binary_stl()}};
    for (const auto& [name, bytes] : all) {
        SCOPED_TRACE(name);
        const Mesh mesh = read_mesh(write(name, bytes), 0.5);
        EXPECT_EQ(mesh.corners_m.size(), 8U);
        EXPECT_EQ(mesh.triangles.size(), 12U);
        EXPECT_TRUE(mesh.normals.empty());
        EXPECT_NEAR(volume_of(mesh), 6.0 / 8, 1e-12) << "corners are counter-clockwise seen from outside";
        EXPECT_NO_THROW(validate({.name = "box", .shape = mesh}));
    }
}

TEST_F(MeshFile, SmoothNormalsOfAGlobePointOutwards) {
    constexpr int rings = 24, around = 48;
    std::string text;
    const auto place = [](int i, int j) {
        const double theta = std::numbers::pi * i / rings, phi = 2 * std::numbers::pi * j / around;
        return glm::dvec3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
    };
    const auto line = [&](glm::dvec3 p) { text += fmt::format("v {:.9f} {:.9f} {:.9f}\n", p.x, p.y, p.z); };
    line({0, 0, 1});
    for (int i = 1; i < rings; ++i)
        for (int j = 0; j < around; ++j) line(place(i, j));
    line({0, 0, -1});
    const auto at = [](int i, int j) {
        return i == 0 ? 1 : i == rings ? 2 + (rings - 1) * around : 2 + (i - 1) * around + j % around;
    };
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < around; ++j) {
            if (i > 0) text += fmt::format("f {} {} {}\n", at(i, j), at(i + 1, j), at(i, j + 1));
            if (i + 1 < rings) text += fmt::format("f {} {} {}\n", at(i, j + 1), at(i + 1, j), at(i + 1, j + 1));
        }
    const Mesh mesh = read_mesh(write("globe.obj", text), 2, true);
    ASSERT_EQ(mesh.normals.size(), mesh.corners_m.size());
    EXPECT_NO_THROW(validate({.name = "globe", .shape = mesh}));
    for (std::size_t k = 0; k < mesh.normals.size(); ++k)
        EXPECT_GT(glm::dot(mesh.normals[k], glm::normalize(mesh.corners_m[k])), std::cos(0.05));
}

TEST_F(MeshFile, WhatIsNoMeshIsRefusedByName) {
    EXPECT_THROW(read_mesh(folder_ / "none.obj"), InputError);
    const auto expect = [&](const char* name, const std::string& bytes, const char* says) {
        const std::string message = refusal(name, bytes);
        EXPECT_NE(message.find(says), std::string::npos) << message;
    };
    expect("a.obj", "", "is empty");
    expect("a.off", "OFF\n", "ends in \".off\"; allowed: .obj, .ply or .stl");
    expect("b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "has no triangle");
    expect("c.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "line 4: it names a corner that is not there");
    expect("d.obj", "v 0 0 0\nv 1 0 x\n", "line 2: found no number");
    expect("e.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2/1 3/1\n", "line 4: it names a corner");
    expect("f.obj", std::string("v 0 0 0\0", 8), "is no text");
    expect("g.obj", "v 0 0 0\nv 1 0 nan\nv 0 1 0\nf 1 2 3\n", "");
    expect("a.ply", "solid", "line 1: it is not \"ply\", with which a .ply begins");
    expect("b.ply", with(ply(), "vertex 8", "vertex 4000000000"),
           "claims 4000000000 elements \"vertex\", more than its bytes can hold");
    expect("c.ply", ply().substr(0, ply().size() - 20), "is cut short");
    expect("d.ply", binary_ply().substr(0, binary_ply().size() - 5), "is cut short");
    expect("e.ply", with(ply(), " 7\n", " 9\n"), "line 20: a face names a corner that is none of its 8");
    expect("f.ply", with(ply(), "ascii 1.0", "ascii 2.0"), "line 2: format \"ascii 2.0\"; allowed: ascii, ");
    expect("g.ply", with(ply(), "int vertex", "float vertex"), "line 9: numbers of corners and lengths of lists");
    expect("h.ply", with(ply(), "float z", "real z"), "line 7: \"real\" is no type that a .ply has");
    expect("i.ply", with(ply(), "float z", "float y"), "line 7: there is this property already");
    expect("j.ply", with(ply(), "float z", "float w"), "has elements \"vertex\" without x, y or z");
    expect("k.ply", with(ply(), "vertex_indices", "colours"), "has elements \"face\" without a list vertex_indices");
    expect("l.ply", with(ply(), "face 6", "strip 6"), "has no element \"face\"");
    expect("m.ply", with(ply(), "face 6", "face -6"),
           "line 8: -6 elements \"face\"; allowed: a name and a whole number");
    expect("n.ply", with(ply(), "end_header", "header_end"), "line 10: \"header_end\" is not known in a header");
    expect("o.ply", with(ply(), "\n4 0 3 2 1\n", "\n2 0 3\n"), "line 19: a face has fewer than three corners");
    expect("p.ply", with(ply(), "\n4 0 3 2 1\n", "\n4 0 3 2\n"), "line 19: it has no number where the header says one");
    expect("q.ply", with(ply(), "\n4 0 3 2 1\n", "\n4 0 3 2 1 5\n"), "line 19: it has more than the header says");
    expect("r.ply", with(ply(), "\n4 0 3 2 1\n", "\n4 0 3 2 0.5\n"), "line 19: a face names a corner");
    expect("s.ply", with(ply(), "\n4 0 3 2 1\n", "\n-4 0 3 2 1\n"), "line 19: a list has a length that is no whole");
    expect("t.ply", with(binary_ply(), "end_header", ""), "in a header");
    std::string more;
    for (int n = 0; n < 3334; ++n) more += " 1 2 3";
    expect("h.obj", fmt::format("v 0 0 0\nv 1 0 0\nv 0 1 0\nf{}\n", more), "line 4: it has more than 10000 corners");
    expect("a.stl", "solid nothing\nendsolid nothing\n", "has no triangle");
    expect("b.stl", binary_stl().substr(0, 300), "claims 12 triangles, more than its 300 bytes can hold");
    expect("c.stl", "short", "is no .stl: text begins with \"solid\", and binary has 84 bytes");
    expect("d.stl", std::string(83, '\0'), "is no .stl");
    expect("e.stl", with(stl(), "facet", "faced"), "line 2: \"faced\" cannot stand here in an .stl");
    expect("f.stl", with(stl(), "endloop\n", "vertex 1 2 3\nendloop\n"), "line 7: \"vertex\" cannot stand here");
    expect("g.stl", with(stl(), "vertex 0", "vertex zero"), "line 4: found no number; allowed: three");
    expect("h.stl", with(stl(), "endsolid box\n", ""), "is cut short: it does not end with \"endsolid\"");
    expect("i.stl", with(stl(), "vertex 0", "vertex 1e39"), "corner 0 is not finite");
}

// VTK's reader takes rows of elements that it does not know for faces.
TEST_F(MeshFile, APlyMayHoldAnythingBesideItsFaces) {
    const auto expect_box = [&](const char* name, const std::string& bytes) {
        SCOPED_TRACE(name);
        const Mesh mesh = read_mesh(write(name, bytes));
        EXPECT_EQ(mesh.corners_m.size(), 8U);
        EXPECT_NEAR(volume_of(mesh), 6, 1e-12);
        EXPECT_NO_THROW(validate({.name = "box", .shape = mesh}));
    };
    const std::string edges = "element edge 2\nproperty int a\nproperty list uchar float b\nelement vertex";
    expect_box("edges.ply",
               with(with(ply(), "element vertex", edges), "end_header\n", "end_header\n\n7 0\n8 2 .5 1\n"));
    std::string properties = with(ply(), "property float x", "property list uint8 double u\nproperty double x");
    properties = with(properties, "property list uchar", "property uchar red\nproperty list uchar");
    std::string marked;
    bool in_rows = false;
    for (std::size_t begin = 0, end = 0; begin < properties.size(); begin = end + 1) {
        end = properties.find('\n', begin);
        const std::string line = properties.substr(begin, end - begin);
        marked += (in_rows ? "0 " : "") + line + "\r\n";
        in_rows |= line == "end_header";
    }
    expect_box("properties.ply", with(marked, "property list uchar int", "property list short uint16"));

    std::string faces_first =
        "ply\nformat binary_big_endian 1.0\nelement face 6\nproperty list int short vertex_index\n"
        "element vertex 8\nproperty int z\nproperty double x\nproperty char s\nproperty ushort y\nend_header\n";
    const auto put_big = [&](auto value) {
        std::string bytes;
        put(bytes, value);
        faces_first.append(bytes.rbegin(), bytes.rend());
    };
    for (const auto& f : faces) {
        put_big(std::int32_t{4});
        for (const int k : f) put_big(static_cast<std::int16_t>(k));
    }
    for (const glm::dvec3& p : corners) {
        put_big(static_cast<std::int32_t>(p.z));
        put_big(p.x);
        put_big(std::int8_t{-1});
        put_big(static_cast<std::uint16_t>(p.y));
    }
    expect_box("faces_first.ply", faces_first);
    EXPECT_NE(refusal("cut.ply", faces_first.substr(0, faces_first.size() - 1)).find("is cut short"),
              std::string::npos);
}

// What says "solid" may be binary all the same, as its length shows; text may hold several solids, and any case.
TEST_F(MeshFile, AnStlIsTextOrBinaryWhateverItBeginsWith) {
    const std::string pairs[][2]{{"solid.stl", with(binary_stl(), "     ", "solid")},
                                 {"more.stl", binary_stl() + "made by a careless program"},
                                 {"upper.stl", with(with(stl(), "solid", "SOLID"), "facet", "  Facet")},
                                 {"accents.stl", with(stl(), "box", "bo\xc3\xaete")}};
    for (const auto& [name, bytes] : pairs) {
        SCOPED_TRACE(name);
        EXPECT_NEAR(volume_of(read_mesh(write(name, bytes))), 6, 1e-12);
    }
    std::string two = stl();
    two.insert(two.find("\nfacet", two.size() / 2) + 1, "endsolid box\n\nsolid other half\n");
    EXPECT_NEAR(volume_of(read_mesh(write("two.stl", two))), 6, 1e-12);
}

// VTK's reader wrote beyond its arrays where some faces have textures and normals and others have none.
TEST_F(MeshFile, FacesOfAnObjNameTheirCornersInAnyWay) {
    const std::string points = "v 0 0 +0\nv 1 0 0 1 0.5 0.5 0.5\n  v 0 1 0\r\nv 0 0 1\nvn 0 0 1\nvt 0 0\nvt 1\n";
    const Mesh mesh = read_mesh(write("tetra.obj", points + "g a\nf 1/2/1 3/1/1 2/1/1\nf 1//1 2//1 4//1\n"
                                                            "f -3 -2 -1\nl 1 2\nf 1/ 4/1 3\n"));
    EXPECT_EQ(mesh.corners_m.size(), 4U);
    EXPECT_EQ(mesh.triangles.size(), 4U);
    EXPECT_DOUBLE_EQ(volume_of(mesh), 1.0 / 6);
    for (const char* face : {"1 2 5", "0 1 2", "1 2 -5", "1/3 2/1 3/1", "1//2 2//1 3//1", "1/-3 2 3", "1/1/1/1 2 3",
                             "1 2 x", "1 2 9223372036854775808"}) {
        const std::string said = refusal("wrong.obj", points + "f " + face + "\n");
        EXPECT_NE(said.find("line 8: it names a corner that is not there"), std::string::npos) << face << ": " << said;
    }
}

// What is closed in the file is for validate() to say.
TEST_F(MeshFile, ABoxWithoutItsLidIsNotClosed) {
    std::string open = obj();
    open.erase(open.rfind("f "));
    const Mesh mesh = read_mesh(write("open.obj", open));
    EXPECT_THROW(validate({.name = "box", .shape = mesh}), InputError);
}

}  // namespace
}  // namespace waterlight
