// SPDX-License-Identifier: MIT
#include "io/atomic_file.h"
#include "io/drawing.h"
#include "io/expect_error.h"
#include "io/mesh_picture.h"
#include "io/sample_meshes.h"
#include "io/stage_pictures.h"
#include "io/system_memory.h"

#include <gtest/gtest.h>

#include <cairo/cairo.h>

#include <cmath>
#include <cstring>
#include <string>

namespace tessera
{
namespace
{

using samples::PlateMesh;
using samples::secondOrderPlate;
using testing::expectError;
using testing::TemporaryFolder;

/// A decoded .png.
class Pixels
{
public:
    explicit Pixels(const std::string& png)
        : rest_(png)
        , surface_(cairo_image_surface_create_from_png_stream(read, &rest_))
    {
        EXPECT_EQ(cairo_surface_status(surface_), CAIRO_STATUS_SUCCESS);
    }
    ~Pixels() { cairo_surface_destroy(surface_); }
    Pixels(const Pixels&) = delete;
    Pixels& operator=(const Pixels&) = delete;

    int width() const { return cairo_image_surface_get_width(surface_); }
    int height() const { return cairo_image_surface_get_height(surface_); }
    /// 0xRRGGBB
    std::uint32_t at(int x, int y) const
    {
        std::uint32_t pixel = 0;
        std::memcpy(&pixel,
                    cairo_image_surface_get_data(surface_)
                        + y * cairo_image_surface_get_stride(surface_) + 4 * x,
                    sizeof pixel);
        return pixel & 0xffffffU;
    }

private:
    static cairo_status_t read(void* rest, unsigned char* data, unsigned int length)
    {
        auto& text = *static_cast<std::string*>(rest);
        if (text.size() < length) {
            return CAIRO_STATUS_READ_ERROR;
        }
        std::memcpy(data, text.data(), length);
        text.erase(0, length);
        return CAIRO_STATUS_SUCCESS;
    }

    std::string rest_;
    cairo_surface_t* surface_;
};

PictureOptions png(const std::string& caption = {})
{
    PictureOptions options;
    options.format = PictureFormat::Png;
    options.caption = caption;
    return options;
}

TEST(MeshPicture, ShowsRegionsHolesAndLines)
{
    const Pixels pixels(drawMesh(PlateMesh(9).mesh, png()));
    ASSERT_EQ(pixels.width(), 1600);
    ASSERT_EQ(pixels.height(), 1600);
    const double scale = 1600.0 / (9.0 * 1.06);
    const auto at = [&](double x, double y) {
        return pixels.at(static_cast<int>((x + 0.27) * scale),
                         static_cast<int>((9.27 - y) * scale));
    };
    EXPECT_EQ(at(4.5, 4.5), 0xffffffU); // the hole
    const std::uint32_t left = at(0.9, 0.45);
    const std::uint32_t right = at(8.1, 8.45);
    EXPECT_NE(left, 0xffffffU);
    EXPECT_NE(right, 0xffffffU);
    EXPECT_NE(left, right);
    EXPECT_LT(at(0.0, 4.5) & 0xffU, 0x80U); // the outline is dark
}

TEST(MeshPicture, SideRatioIsLimitedAndNothingIsNoError)
{
    Mesh thin;
    thin.nodes = {{0, 0}, {1000, 0}, {500, 1}};
    thin.nodeOrigin.resize(3);
    thin.triangles = {{0, 1, 2}};
    thin.triangleRegion = {0};
    thin.regions.resize(1);
    const Pixels pixels(drawMesh(thin, png()));
    EXPECT_EQ(pixels.width(), 1600);
    EXPECT_GE(pixels.height(), 200);
    EXPECT_EQ(Pixels(drawMesh(Mesh(), png())).width(), 1600);
    for (const double scale : {1e-140, 1e140}) {
        Mesh scaled = thin;
        for (Vec2& node : scaled.nodes) {
            node = scale * node;
        }
        EXPECT_EQ(Pixels(drawMesh(scaled, png())).width(), 1600);
    }
}

TEST(MeshPicture, CaptionTakesAStripBelow)
{
    const Pixels plain(drawMesh(PlateMesh(6).mesh, png()));
    const Pixels with(drawMesh(PlateMesh(6).mesh, png("A caption")));
    EXPECT_EQ(with.width(), plain.width());
    EXPECT_GT(with.height(), plain.height());
    Pixels(drawMesh(PlateMesh(6).mesh, png(std::string(500, 'W'))));
}

TEST(MeshPicture, SvgIsWholeAndCurvesForOrderTwo)
{
    Mesh straight = PlateMesh(6).mesh;
    Mesh curved = secondOrderPlate(6);
    straight.groups.clear(); // the dot of a named point is a curve, too
    curved.groups.clear();
    const std::string first = drawMesh(straight, {});
    EXPECT_TRUE(first.starts_with("<?xml"));
    EXPECT_TRUE(first.ends_with("</svg>\n"));
    EXPECT_EQ(first.find(" C "), std::string::npos);
    EXPECT_NE(drawMesh(curved, {}).find(" C "), std::string::npos);
}

TEST(Drawing, EverySideOnceWithItsClasses)
{
    const PlateMesh plate(6);
    DrawnTriangles triangles;
    triangles.points = plate.mesh.nodes;
    triangles.corners = plate.mesh.triangles;
    triangles.classOf = plate.mesh.triangleRegion;
    const auto sides = sidesOf(triangles);
    // Euler: V - E + F = 0 for one hole.
    EXPECT_EQ(sides.size(), plate.mesh.nodes.size() + plate.mesh.triangles.size());
    std::size_t outline = 0;
    std::size_t seam = 0;
    for (const DrawnEdge& side : sides) {
        outline += side.right == DrawnTriangles::kNone ? 1 : 0;
        seam += side.right != DrawnTriangles::kNone && side.left != side.right ? 1 : 0;
    }
    EXPECT_EQ(outline, 24U + 8U);
    EXPECT_EQ(seam, 4U);
    const auto colors = chooseColors(sides, 2);
    EXPECT_NE(colors[0].red, colors[1].red);
}

/// A grid of 30 x 30 classes: no two neighbors have one color.
TEST(Drawing, NeighborsDifferInColor)
{
    std::vector<DrawnEdge> sides;
    for (std::uint32_t i = 0; i < 900; ++i) {
        if (i % 30 != 29) {
            sides.push_back({0, 1, DrawnTriangles::kNone, i, i + 1});
        }
        if (i + 30 < 900) {
            sides.push_back({0, 1, DrawnTriangles::kNone, i, i + 30});
        }
    }
    const auto colors = chooseColors(sides, 900);
    for (const DrawnEdge& side : sides) {
        const Color a = colors[side.left];
        const Color b = colors[side.right];
        EXPECT_TRUE(a.red != b.red || a.green != b.green || a.blue != b.blue);
    }
}

TEST(StagePictures, AFolderThatCannotBeMade)
{
    const TemporaryFolder folder;
    testing::writeAll(folder / "file", "");
    expectError(ErrorKind::Unwritable, "cannot be made",
                [&] { StagePictures pictures(folder / "file"); });
    expectError(ErrorKind::Unwritable, "cannot be made",
                [&] { StagePictures pictures(folder / "file/below"); });
    StagePictures fine(folder / "a/b/c");
    EXPECT_TRUE(std::filesystem::is_directory(folder / "a/b/c"));
}

TEST(AtomicFile, AppearsWholeOrNotAtAll)
{
    const TemporaryFolder folder;
    testing::writeAll(folder / "a.txt", "old");
    {
        const AtomicFile file(folder / "a.txt");
        file.write("new");
        EXPECT_EQ(testing::readAll(folder / "a.txt"), "old");
        EXPECT_EQ(file.temporary().extension(), ".txt");
    }
    EXPECT_EQ(testing::readAll(folder / "a.txt"), "old");
    EXPECT_EQ(folder.fileCount(), 1U);
    AtomicFile file(folder / "a.txt");
    file.write("first, longer");
    file.write("new");
    file.commit();
    EXPECT_EQ(testing::readAll(folder / "a.txt"), "new");
    EXPECT_EQ(folder.fileCount(), 1U);
}

TEST(AtomicFile, LinksStayLinks)
{
    const TemporaryFolder folder;
    testing::writeAll(folder / "real.txt", "old");
    std::filesystem::create_symlink(folder / "real.txt", folder / "link.txt");
    AtomicFile file(folder / "link.txt");
    file.write("new");
    file.commit();
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.txt"));
    EXPECT_EQ(testing::readAll(folder / "real.txt"), "new");
}

TEST(AtomicFile, FullDisk)
{
    const TemporaryFolder folder;
    const AtomicFile file(folder / "a.txt");
    std::filesystem::remove(file.temporary());
    std::filesystem::create_symlink("/dev/full", file.temporary());
    expectError(ErrorKind::Unwritable, "No space left", [&] { file.write("x"); });
}

TEST(SystemMemory, IsPlausible)
{
    EXPECT_GT(peakMemoryBytes(), 1000000U);
    EXPECT_GT(availableMemoryBytes(), 10000000U);
    EXPECT_LT(availableMemoryBytes(), std::uint64_t {1} << 50U);
}

} // namespace
} // namespace tessera
