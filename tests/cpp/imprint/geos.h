// SPDX-License-Identifier: MIT
#pragma once

// GEOS as an oracle, through its C interface.

#include <geos_c.h>

#include <memory>
#include <string>
#include <vector>

namespace tessera::test
{

class Geos
{
public:
    Geos()
        : context_(GEOS_init_r())
    {}
    ~Geos() { GEOS_finish_r(context_); }
    Geos(const Geos&) = delete;
    Geos& operator=(const Geos&) = delete;

    struct Deleter
    {
        GEOSContextHandle_t context;
        void operator()(GEOSGeometry* g) const { GEOSGeom_destroy_r(context, g); }
    };
    using Geometry = std::unique_ptr<GEOSGeometry, Deleter>;

    Geometry read(const std::string& wkt) const
    {
        GEOSWKTReader* reader = GEOSWKTReader_create_r(context_);
        Geometry geometry = own(GEOSWKTReader_read_r(context_, reader, wkt.c_str()));
        GEOSWKTReader_destroy_r(context_, reader);
        return geometry;
    }
    double area(const GEOSGeometry* g) const
    {
        double area = -1.0;
        GEOSArea_r(context_, g, &area);
        return area;
    }
    /// Empty if valid.
    std::string whyInvalid(const GEOSGeometry* g) const
    {
        char* reason = GEOSisValidReason_r(context_, g);
        const std::string text = reason == nullptr ? "no geometry" : reason;
        GEOSFree_r(context_, reason);
        return text == "Valid Geometry" ? "" : text;
    }
    Geometry own(GEOSGeometry* g) const { return {g, Deleter {context_}}; }
    GEOSContextHandle_t context() const { return context_; }

    /// The well-known text of every polygon in a geometry.
    std::vector<std::string> polygonsOf(const GEOSGeometry* g) const
    {
        std::vector<std::string> texts;
        collectPolygons(g, texts);
        return texts;
    }

private:
    void collectPolygons(const GEOSGeometry* g, std::vector<std::string>& texts) const
    {
        const int type = GEOSGeomTypeId_r(context_, g);
        if (type == GEOS_POLYGON) {
            GEOSWKTWriter* writer = GEOSWKTWriter_create_r(context_);
            char* text = GEOSWKTWriter_write_r(context_, writer, g);
            texts.emplace_back(text);
            GEOSFree_r(context_, text);
            GEOSWKTWriter_destroy_r(context_, writer);
        }
        else if (type == GEOS_MULTIPOLYGON || type == GEOS_GEOMETRYCOLLECTION) {
            for (int i = 0; i < GEOSGetNumGeometries_r(context_, g); ++i) {
                collectPolygons(GEOSGetGeometryN_r(context_, g, i), texts);
            }
        }
    }

    GEOSContextHandle_t context_;
};

} // namespace tessera::test
