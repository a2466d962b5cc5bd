// SPDX-License-Identifier: MIT
#pragma once

#include "base/box2.h"
#include "base/vec2.h"

#include <memory>
#include <string>

namespace tessera
{

/// Red, green and blue from 0 to 1; opaque.
struct Color
{
    double red = 0.0;
    double green = 0.0;
    double blue = 0.0;
};

enum class PictureFormat
{
    Svg,
    Png,
};

/// Longer side of a picture without its caption, pixels.
inline constexpr double kPictureSize = 1600.0;

/// A white page that shows a box of the plane, y up, with a caption below. Positions are in the
/// plane's unit, widths and radii in pixels.
class Canvas
{
public:
    /// Shows all of view with a small margin; the sides' ratio is limited to 8. An empty view or
    /// one without extent is enlarged.
    Canvas(const Box2& view, PictureFormat format, const std::string& caption);
    ~Canvas();
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    /// The picture's file content. The canvas cannot be drawn on any more. Throws Error(Unwritable)
    /// if the drawing library failed.
    std::string finish();

    double pixelsPerUnit() const { return scale_; }
    /// What is shown, margin included.
    const Box2& view() const { return view_; }

    void moveTo(Vec2 p);
    void lineTo(Vec2 p);
    /// A parabola from the current point through middle (its half-way point) to end.
    void parabolaTo(Vec2 start, Vec2 middle, Vec2 end);
    void closePath();
    /// Fills what the path winds around.
    void fill(Color color);
    void stroke(Color color, double width, bool dashed = false);

    void dot(Vec2 center, double radius, Color color);
    void ring(Vec2 center, double radius, double width, Color color);
    void line(Vec2 a, Vec2 b, double width, Color color, bool dashed = false);
    /// Text to the right of and above p.
    void label(Vec2 p, const std::string& text, Color color);

private:
    struct Pixel
    {
        double x;
        double y;
    };
    Pixel toPixel(Vec2 p) const;
    void drawCaption(const std::string& caption);

    struct Surface;
    Box2 view_;
    double scale_ = 1.0;
    double width_ = 0.0;
    double height_ = 0.0; ///< without the caption
    std::unique_ptr<Surface> surface_;
};

} // namespace tessera
