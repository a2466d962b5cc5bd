// SPDX-License-Identifier: MIT
#include "io/canvas.h"

#include "base/error.h"

#include <fmt/format.h>

#include <cairo-svg.h>
#include <cairo.h>

#include <algorithm>
#include <cmath>

namespace tessera
{

namespace
{

constexpr double kMargin = 0.03;         ///< of the longer side, on every side
constexpr double kGreatestRatio = 8.0;   ///< of the page's sides
constexpr double kFontSize = 26.0;       ///< pixels
constexpr double kCaptionHeight = 56.0;  ///< pixels

cairo_status_t append(void* content, const unsigned char* data, unsigned int length)
{
    static_cast<std::string*>(content)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
}

/// The box to show: never empty, never a point, not too long, with a margin.
Box2 shownBox(Box2 box)
{
    if (box.empty()) {
        box = {{-1.0, -1.0}, {1.0, 1.0}};
    }
    const Vec2 center = box.center();
    double halfWidth = 0.5 * box.max.x - 0.5 * box.min.x;
    double halfHeight = 0.5 * box.max.y - 0.5 * box.min.y;
    double longer = std::max(halfWidth, halfHeight);
    if (!(longer > 0.0)) {
        longer = std::max({std::fabs(center.x), std::fabs(center.y), 1.0}) * 1e-3;
    }
    halfWidth = std::max(halfWidth, longer / kGreatestRatio) + 2.0 * kMargin * longer;
    halfHeight = std::max(halfHeight, longer / kGreatestRatio) + 2.0 * kMargin * longer;
    return {{center.x - halfWidth, center.y - halfHeight},
            {center.x + halfWidth, center.y + halfHeight}};
}

} // namespace

struct Canvas::Surface
{
    cairo_surface_t* surface = nullptr;
    cairo_t* pen = nullptr;
    PictureFormat format = PictureFormat::Svg;
    std::string content; ///< SVG: written to while drawing

    ~Surface()
    {
        if (pen != nullptr) {
            cairo_destroy(pen);
        }
        if (surface != nullptr) {
            cairo_surface_destroy(surface);
        }
    }
};

Canvas::Canvas(const Box2& view, PictureFormat format, const std::string& caption)
    : view_(shownBox(view))
    , surface_(std::make_unique<Surface>())
{
    const double width = view_.max.x - view_.min.x;
    const double height = view_.max.y - view_.min.y;
    scale_ = kPictureSize / std::max(width, height);
    width_ = std::round(width * scale_);
    height_ = std::round(height * scale_);
    const double pageHeight = height_ + (caption.empty() ? 0.0 : kCaptionHeight);

    surface_->format = format;
    surface_->surface = format == PictureFormat::Svg
        ? cairo_svg_surface_create_for_stream(append, &surface_->content, width_, pageHeight)
        : cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width_),
                                     static_cast<int>(pageHeight));
    surface_->pen = cairo_create(surface_->surface);
    cairo_t* pen = surface_->pen;
    cairo_set_line_cap(pen, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(pen, CAIRO_LINE_JOIN_ROUND);
    cairo_set_source_rgb(pen, 1.0, 1.0, 1.0);
    cairo_paint(pen);
    if (!caption.empty()) {
        drawCaption(caption);
    }
    cairo_rectangle(pen, 0.0, 0.0, width_, height_);
    cairo_clip(pen);
}

Canvas::~Canvas() = default;

std::string Canvas::finish()
{
    std::string content;
    cairo_surface_t* surface = surface_->surface;
    cairo_status_t status = cairo_status(surface_->pen);
    if (surface_->format == PictureFormat::Png && status == CAIRO_STATUS_SUCCESS) {
        cairo_surface_flush(surface);
        status = cairo_surface_write_to_png_stream(surface, append, &content);
    }
    cairo_surface_finish(surface);
    if (surface_->format == PictureFormat::Svg) {
        content = std::move(surface_->content);
        if (status == CAIRO_STATUS_SUCCESS) {
            status = cairo_surface_status(surface);
        }
    }
    if (status != CAIRO_STATUS_SUCCESS) {
        throw Error(ErrorKind::Unwritable, fmt::format("The picture could not be drawn: {}.",
                                                       cairo_status_to_string(status)));
    }
    return content;
}

Canvas::Pixel Canvas::toPixel(Vec2 p) const
{
    // Far outside points would overflow the drawing library's fixed-point numbers.
    constexpr double kFarthest = 1e6;
    return {std::clamp((p.x - view_.min.x) * scale_, -kFarthest, kFarthest),
            std::clamp((view_.max.y - p.y) * scale_, -kFarthest, kFarthest)};
}

void Canvas::moveTo(Vec2 p)
{
    const Pixel pixel = toPixel(p);
    cairo_move_to(surface_->pen, pixel.x, pixel.y);
}

void Canvas::lineTo(Vec2 p)
{
    const Pixel pixel = toPixel(p);
    cairo_line_to(surface_->pen, pixel.x, pixel.y);
}

void Canvas::parabolaTo(Vec2 start, Vec2 middle, Vec2 end)
{
    constexpr double kVisible = 0.05; // pixels
    const Pixel a = toPixel(start);
    const Pixel m = toPixel(middle);
    const Pixel b = toPixel(end);
    if (std::hypot(m.x - 0.5 * (a.x + b.x), m.y - 0.5 * (a.y + b.y)) < kVisible) {
        cairo_line_to(surface_->pen, b.x, b.y);
        return;
    }
    // Control point of the quadratic Bezier curve, raised to a cubic one.
    const Pixel c {2.0 * m.x - 0.5 * (a.x + b.x), 2.0 * m.y - 0.5 * (a.y + b.y)};
    cairo_curve_to(surface_->pen, (a.x + 2.0 * c.x) / 3.0, (a.y + 2.0 * c.y) / 3.0,
                   (b.x + 2.0 * c.x) / 3.0, (b.y + 2.0 * c.y) / 3.0, b.x, b.y);
}

void Canvas::closePath()
{
    cairo_close_path(surface_->pen);
}

void Canvas::fill(Color color)
{
    cairo_set_source_rgb(surface_->pen, color.red, color.green, color.blue);
    cairo_fill(surface_->pen);
}

void Canvas::stroke(Color color, double width, bool dashed)
{
    const double dashes[] = {5.0 * width, 4.0 * width};
    cairo_set_dash(surface_->pen, dashes, dashed ? 2 : 0, 0.0);
    cairo_set_source_rgb(surface_->pen, color.red, color.green, color.blue);
    cairo_set_line_width(surface_->pen, width);
    cairo_stroke(surface_->pen);
}

void Canvas::dot(Vec2 center, double radius, Color color)
{
    const Pixel pixel = toPixel(center);
    cairo_new_sub_path(surface_->pen);
    cairo_arc(surface_->pen, pixel.x, pixel.y, radius, 0.0, 2.0 * M_PI);
    fill(color);
}

void Canvas::ring(Vec2 center, double radius, double width, Color color)
{
    const Pixel pixel = toPixel(center);
    cairo_new_sub_path(surface_->pen);
    cairo_arc(surface_->pen, pixel.x, pixel.y, radius, 0.0, 2.0 * M_PI);
    stroke(color, width);
}

void Canvas::line(Vec2 a, Vec2 b, double width, Color color, bool dashed)
{
    moveTo(a);
    lineTo(b);
    stroke(color, width, dashed);
}

void Canvas::label(Vec2 p, const std::string& text, Color color)
{
    constexpr double kGap = 9.0;
    const Pixel pixel = toPixel(p);
    cairo_t* pen = surface_->pen;
    cairo_select_font_face(pen, "sans-serif", CAIRO_FONT_SLANT_ITALIC, CAIRO_FONT_WEIGHT_BOLD);
    cairo_set_font_size(pen, kFontSize);
    cairo_move_to(pen, pixel.x + kGap, pixel.y - kGap);
    cairo_text_path(pen, text.c_str());
    const auto outline = cairo_copy_path(pen);
    stroke({1.0, 1.0, 1.0}, 6.0);
    cairo_append_path(pen, outline);
    cairo_path_destroy(outline);
    fill(color);
}

void Canvas::drawCaption(const std::string& caption)
{
    cairo_t* pen = surface_->pen;
    cairo_select_font_face(pen, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    double size = kFontSize;
    cairo_text_extents_t extents;
    do {
        cairo_set_font_size(pen, size);
        cairo_text_extents(pen, caption.c_str(), &extents);
        size *= 0.95;
    } while (extents.x_advance > width_ - 20.0 && size > 6.0);
    cairo_set_source_rgb(pen, 0.13, 0.15, 0.2);
    cairo_move_to(pen, std::max(10.0, 0.5 * (width_ - extents.x_advance)),
                  height_ + 0.62 * kCaptionHeight);
    cairo_show_text(pen, caption.c_str());
}

} // namespace tessera
