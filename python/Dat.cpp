#include "Module.h"

#include "dat/Archive.h"
#include "dat/Describe.h"
#include "dat/Verify.h"
#include "dat/Writer.h"

#include <memory>

namespace limen::python {

namespace {

struct EntryRow {
    std::uint32_t id, size, offset, flags;
};

py::array_t<EntryRow> entriesOf(const dat::File& file) {
    std::vector<EntryRow> rows;
    valueOf(file.forEach([&](const dat::Entry& entry) {
        rows.push_back({entry.id, entry.size, entry.offset, entry.flags});
        return true;
    }));
    py::array_t<EntryRow> table(static_cast<py::ssize_t>(rows.size()));
    std::copy(rows.begin(), rows.end(), table.mutable_data());
    return table;
}

py::bytes bytesOf(dat::ByteView bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

py::bytes payloadOf(const dat::File& file, dat::RecordId id) {
    dat::Bytes scratch;
    return bytesOf(valueOf(file.read(id, scratch)));
}

py::object recordOf(const dat::File& file, dat::RecordId id) {
    dat::Bytes scratch;
    const std::string text = valueOf(dat::describe(file.role(), id, valueOf(file.read(id, scratch))));
    return py::module_::import("json").attr("loads")(text);
}

/// The pixels of a RenderSurface as they are stored: format, width, height, bytes.
py::tuple pixelsOf(const dat::File& file, dat::RecordId id) {
    if (dat::kindOf(file.role(), id) != dat::RecordKind::RenderSurface)
        throw Raised(dat::idText(id) + " is no picture (RenderSurface)");
    dat::Bytes scratch;
    const dat::RenderSurface picture =
        valueOf(dat::decode<dat::RenderSurface>(id, valueOf(file.read(id, scratch))));
    py::array_t<std::uint8_t> pixels(static_cast<py::ssize_t>(picture.pixels.size()));
    std::copy(picture.pixels.begin(), picture.pixels.end(), pixels.mutable_data());
    return py::make_tuple(static_cast<std::uint32_t>(picture.format), picture.width, picture.height, pixels);
}

py::dict verified(const std::vector<std::string>& paths) {
    std::vector<dat::File> files;
    for (const std::string& path : paths)
        files.push_back(valueOf(dat::File::open(path)));
    std::vector<const dat::File*> pointers;
    for (const dat::File& file : files)
        pointers.push_back(&file);
    for (std::size_t i = 0; i < files.size(); ++i)
        for (std::size_t j = i + 1; j < files.size(); ++j)
            if (files[i].role() == files[j].role())
                throw Raised("two of the files have the same role: " + paths[i] + ", " + paths[j]);
    const dat::VerifyReport report = dat::verify(pointers);
    py::dict counts;
    for (std::size_t kind = 0; kind < report.byKind.size(); ++kind)
        if (report.byKind[kind].records > 0)
            counts[dat::nameOf(static_cast<dat::RecordKind>(kind))] = report.byKind[kind].records;
    py::list faults;
    for (const dat::Fault& fault : report.faults)
        faults.append(py::make_tuple(dat::nameOf(fault.kind), fault.id, fault.what));
    py::dict result;
    result["records"] = counts;
    result["faults"] = faults;
    result["warnings"] = report.warnings;
    return result;
}

dat::Writer writerOf(const std::string& kind) {
    if (kind == "portal")
        return dat::Writer(dat::FileTraits::portal());
    if (kind == "cell")
        return dat::Writer(dat::FileTraits::cell());
    throw Raised("unknown kind of file '" + kind + "'. Use 'portal' or 'cell'");
}

void add(dat::Writer& writer, dat::RecordId id, const std::string& payload, bool compressed) {
    const auto bytes = std::as_bytes(std::span(payload));
    writer.add(id, dat::Bytes(bytes.begin(), bytes.end()), compressed);
}

} // namespace

void addDat(py::module_& module) {
    PYBIND11_NUMPY_DTYPE(EntryRow, id, size, offset, flags);
    py::class_<dat::File, std::unique_ptr<dat::File>>(module, "File", "A .dat file, mapped for reading.")
        .def(py::init([](const std::string& path) {
                 return std::make_unique<dat::File>(valueOf(dat::File::open(path)));
             }),
             py::arg("path"))
        .def("entries", &entriesOf,
             "The records of the file by id, a structured array: id, size, offset, flags.")
        .def("read", &payloadOf, py::arg("id"), "The decompressed bytes of a record.")
        .def("record", &recordOf, py::arg("id"), "A record as the dict that `limen dat show` prints as JSON.")
        .def("pixels", &pixelsOf, py::arg("id"), "A picture as stored: format, width, height, bytes.")
        .def(
            "kind",
            [](const dat::File& file, dat::RecordId id) { return dat::nameOf(dat::kindOf(file.role(), id)); },
            py::arg("id"), "The name of the kind of a record.");
    py::class_<dat::Writer>(module, "Writer", "Collects records and writes a .dat file.")
        .def(py::init(&writerOf), py::arg("kind") = "portal")
        .def(
            "add",
            [](dat::Writer& writer, dat::RecordId id, const py::bytes& payload, bool compressed) {
                add(writer, id, payload, compressed);
            },
            py::arg("id"), py::arg("payload"), py::arg("compressed") = false, "Adds or replaces a record.")
        .def(
            "write", [](const dat::Writer& writer, const std::string& path) { valueOf(writer.write(path)); },
            py::arg("path"));
    module.def("verify", &verified, py::arg("paths"),
               "Decodes and encodes every record of the files and looks up references: a dict of records, "
               "faults and warnings.");
}

} // namespace limen::python
