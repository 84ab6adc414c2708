#include "Module.h"

PYBIND11_MODULE(limen, module) {
    namespace py = limen::python::py;
    module.doc() =
        "Portal visibility (limen.visibility) and records of .dat files (limen.dat). Lengths are metres.";
    py::register_exception<limen::python::Raised>(module, "Error", PyExc_ValueError);
    py::module_ visibility = module.def_submodule(
        "visibility", "Which spaces an eye sees, and through which parts of the screen.");
    py::module_ dat = module.def_submodule("dat", "Reads, writes and verifies .dat files.");
    limen::python::addVisibility(visibility);
    limen::python::addDat(dat);
    // So that `import limen.visibility` works, too.
    py::object modules = py::module_::import("sys").attr("modules");
    modules["limen.visibility"] = visibility;
    modules["limen.dat"] = dat;
}
