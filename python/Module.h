#pragma once

#include "core/Error.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

namespace limen::python {

namespace py = pybind11;

/// An error value as the exception limen.Error. The one place of the project that throws: Python has no other way.
class Raised : public std::runtime_error {
public:
    explicit Raised(const Error& error) : std::runtime_error(error.message()) {}
    explicit Raised(const std::string& message) : std::runtime_error(message) {}
};

/// The value; raises the error if there is none.
template <class T>
T valueOf(Result<T>&& result) {
    if (!result)
        throw Raised(result.error());
    if constexpr (!std::is_void_v<T>)
        return *std::move(result);
}

void addVisibility(py::module_& module);
void addDat(py::module_& module);

} // namespace limen::python
