// SPDX-License-Identifier: MIT
#include "occt/read_cad.h"

#include "occt/read_shape.h"
#include "occt/rehearse.h"
#include "occt/shape_network.h"
#include "occt/silence.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IFSelect_ReturnStatus.hxx>
#include <Message.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS_Shape.hxx>

#include <algorithm>
#include <cctype>
#include <exception>
#include <fstream>
#include <iterator>
#include <mutex>
#include <sstream>
#include <string_view>

namespace tessera
{
namespace
{

Error unreadable(const std::string& name, const std::string& what)
{
    return {ErrorKind::Unreadable, name + ": " + what};
}

std::string readFile(const std::filesystem::path& path)
{
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) {
        throw unreadable(path.string(), "this is a folder; give a file.");
    }
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        throw unreadable(path.string(), "cannot be opened; check its name and permissions.");
    }
    std::string text {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (file.bad()) {
        throw unreadable(path.string(), "cannot be read to its end; check the disk.");
    }
    return text;
}

/// Takes the last line off the text, without the spaces around it.
std::string takeLastLine(std::string_view& text)
{
    const std::size_t newline = text.find_last_of('\n');
    std::string_view line = newline == std::string_view::npos ? text : text.substr(newline + 1);
    text = newline == std::string_view::npos ? std::string_view() : text.substr(0, newline);
    while (!line.empty() && std::isspace(static_cast<unsigned char>(line.back()))) {
        line.remove_suffix(1);
    }
    return std::string(line);
}

/// A .brep text ends with an empty line and the reference to its main shape, as "+1 0" or "-1 2";
/// nothing else in the format looks so. OpenCASCADE's own shell adds a line "0".
bool endsWithMainShape(std::string_view text)
{
    std::string line;
    while (!text.empty() && (line.empty() || line == "0")) {
        line = takeLastLine(text);
    }
    std::istringstream words(line);
    char sign = 0;
    int shape = 0;
    int location = -1;
    words >> sign >> shape >> location;
    const bool reference = words && (words >> std::ws).eof() && (sign == '+' || sign == '-')
        && shape > 0 && location >= 0;
    return reference && takeLastLine(text).empty();
}

} // namespace

TopoDS_Shape shapeFromBrep(const std::string& text, const std::string& name)
{
    if (text.find("CASCADE Topology V") == std::string::npos) {
        throw unreadable(name, "not a .brep file (no \"CASCADE Topology\" line); export it again.");
    }
    if (!endsWithMainShape(text)) {
        throw unreadable(name, "cut off (the main shape is missing at the end); export it again.");
    }
    TopoDS_Shape shape;
    try {
        std::istringstream stream(text);
        BRepTools::Read(shape, stream, BRep_Builder());
    }
    catch (const Standard_Failure& failure) {
        throw unreadable(name, std::string("damaged (") + failure.GetMessageString()
                                   + "); export it again.");
    }
    catch (const std::exception& failure) {
        throw unreadable(name, std::string("damaged (") + failure.what() + "); export it again.");
    }
    if (shape.IsNull()) {
        throw unreadable(name, "holds no shape; export it again.");
    }
    return shape;
}

namespace
{

TopoDS_Shape shapeFromStep(const std::string& text, const std::filesystem::path& path)
{
    const std::string name = path.string();
    if (text.find("ISO-10303-21;") == std::string::npos) {
        throw unreadable(name, "not a STEP file (no \"ISO-10303-21;\" line); export it again.");
    }
    if (text.rfind("END-ISO-10303-21;") == std::string::npos) {
        throw unreadable(name, "cut off (no \"END-ISO-10303-21;\" at the end); export it again.");
    }
    const Silence silence;
    TopoDS_Shape shape;
    try {
        STEPControl_Reader reader;
        if (reader.ReadFile(name.c_str()) != IFSelect_RetDone) {
            throw unreadable(name, "damaged STEP data; export it again.");
        }
        reader.TransferRoots();
        shape = reader.OneShape();
    }
    catch (const Standard_Failure& failure) {
        throw unreadable(name, std::string("damaged (") + failure.GetMessageString()
                                   + "); export it again.");
    }
    if (shape.IsNull()) {
        throw unreadable(name, "holds no shape; export it again.");
    }
    return shape;
}

} // namespace

TopoDS_Shape shapeFromFile(const std::filesystem::path& path)
{
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const bool step = extension == ".step" || extension == ".stp";
    if (!step && extension != ".brep" && extension != ".brp") {
        throw unreadable(path.string(), "not a .brep or .step file.");
    }
    const std::string text = readFile(path);
    const auto read = [&] {
        return step ? shapeFromStep(text, path) : shapeFromBrep(text, path.string());
    };
    // OpenCASCADE's STEP reader keeps global state.
    static std::mutex mutex;
    const std::lock_guard lock(mutex);
    if (!comesBack([&] { read(); }, text.size())) {
        throw unreadable(path.string(), "damaged; export it again.");
    }
    return read();
}

CadInput readBrepText(const std::string& text, const CadOptions& options, const std::string& name)
{
    return networkFromShape(shapeFromBrep(text, name), options);
}

std::vector<CadInput> readBrepTexts(std::span<const BrepText> shapes)
{
    std::vector<TopoDS_Shape> parsed;
    for (const BrepText& shape : shapes) {
        parsed.push_back(shapeFromBrep(shape.text, shape.name));
    }
    std::vector<CadInput> inputs;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        CadOptions options = shapes[i].options;
        options.plane = i > 0                     ? std::optional(inputs.front().frame)
            : options.plane || shapes.size() == 1 ? options.plane
                                                  : std::optional(planeOfShapes(parsed));
        try {
            inputs.push_back(networkFromShape(parsed[i], options));
        }
        catch (CadError& error) {
            error.setShape(i);
            throw;
        }
    }
    return inputs;
}

CadInput readCad(const std::filesystem::path& path, const CadOptions& options)
{
    const TopoDS_Shape shape = shapeFromFile(path);
    try {
        return networkFromShape(shape, options);
    }
    catch (const CadError& error) {
        throw CadError(error.kind(), path.string() + ": " + error.what(), error.where());
    }
}

} // namespace tessera
