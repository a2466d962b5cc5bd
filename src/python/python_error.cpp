// SPDX-License-Identifier: MIT
#include "python/python_error.h"

namespace py = pybind11;

namespace tessera::python
{
namespace
{

const char* className(ErrorKind kind)
{
    switch (kind) {
        case ErrorKind::InvalidInput:
            return "InvalidInputError";
        case ErrorKind::InvalidOption:
            return "InvalidOptionError";
        case ErrorKind::NoInside:
            return "NoInsideError";
        case ErrorKind::TooLarge:
            return "TooLargeError";
        case ErrorKind::Unreadable:
            return "UnreadableError";
        case ErrorKind::Unwritable:
            return "UnwritableError";
        case ErrorKind::Cancelled:
            return "CancelledError";
        case ErrorKind::TimeLimit:
            return "TimeLimitError";
    }
    return "Error";
}

py::object textOrNone(const std::string& text)
{
    return text.empty() ? py::object(py::none()) : py::object(py::str(text));
}

} // namespace

void raise(const Error& error, const std::vector<PlaceName>& names, const PlaneFrame& frame)
{
    const py::module_ errors = py::module_::import("tessera.errors");
    py::list places;
    for (std::size_t i = 0; i < error.places().size(); ++i) {
        const ErrorPlace& place = error.places()[i];
        const PlaceName name = i < names.size() ? names[i] : PlaceName {};
        const auto point = name.point.value_or(frame.toSpace(place.position));
        places.append(errors.attr("Place")(
            py::make_tuple(place.position.x, place.position.y),
            py::make_tuple(point[0], point[1], point[2]), textOrNone(name.curve),
            textOrNone(name.element),
            name.source < 0 ? py::object(py::none()) : py::object(py::int_(name.source))));
    }
    const py::object type = errors.attr(className(error.kind()));
    const py::object exception = type(error.what(), places);
    PyErr_SetObject(type.ptr(), exception.ptr());
    throw py::error_already_set();
}

} // namespace tessera::python
