// embed-shaders OUT.cpp OUT.d DIR NAME...: writes a C++ file with the sources DIR/NAME, includes resolved.
//
// An include is inserted once per shader. #line directives keep file (as a source number) and line; a source
// number is an index into the shader's file list. OUT.d is a depfile in make's format, so that a changed
// include triggers a rebuild.

#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

// One shader with all its includes.
struct Flattened {
    std::vector<std::string> parts; // one per stretch of a file; joined, they are the text
    std::vector<std::string> files; // relative to the shader folder; the index is the source number
};

// The name in `#include "name"`, or none.
std::optional<std::string> includedName(const std::string& line) {
    const std::size_t hash = line.find_first_not_of(" \t");
    if (hash == std::string::npos || line.compare(hash, 8, "#include") != 0)
        return std::nullopt;
    const std::size_t open = line.find('"', hash);
    const std::size_t close = open == std::string::npos ? open : line.find('"', open + 1);
    if (close == std::string::npos)
        return std::nullopt;
    return line.substr(open + 1, close - open - 1);
}

class Flattener {
public:
    explicit Flattener(fs::path root) : root_(std::move(root)) {}

    [[nodiscard]] bool add(const std::string& name, Flattened& out, std::set<std::string>& seen) {
        if (!seen.insert(name).second)
            return true;
        std::ifstream in(root_ / name);
        if (!in) {
            std::cerr << "embed-shaders: cannot read " << (root_ / name).string() << "\n";
            return false;
        }
        const std::size_t number = out.files.size();
        out.files.push_back(name);
        dependencies_.insert((root_ / name).string());
        out.parts.push_back("#line 1 " + std::to_string(number) + "\n");
        std::string line;
        for (std::size_t lineNumber = 1; std::getline(in, line); ++lineNumber) {
            const std::optional<std::string> included = includedName(line);
            if (!included) {
                out.parts.back() += line + "\n";
                continue;
            }
            if (!add("include/" + *included, out, seen)) {
                std::cerr << "  included from " << name << ":" << lineNumber << "\n";
                return false;
            }
            out.parts.push_back("#line " + std::to_string(lineNumber + 1) + " " + std::to_string(number) +
                                "\n");
        }
        return true;
    }

    [[nodiscard]] const std::set<std::string>& dependencies() const { return dependencies_; }

private:
    fs::path root_;
    std::set<std::string> dependencies_;
};

void writeShader(std::ostream& out, const std::string& name, const Flattened& shader) {
    out << "    {\"" << name << "\", {";
    for (const std::string& part : shader.parts)
        out << "R\"glsl(" << part << ")glsl\", ";
    out << "}, {";
    for (const std::string& file : shader.files)
        out << "\"" << file << "\", ";
    out << "}},\n";
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 5) {
        std::cerr << "usage: embed-shaders OUT.cpp OUT.d DIR NAME...\n";
        return 2;
    }
    Flattener flattener{fs::path(argv[3])};
    std::ofstream source(argv[1]);
    source
        << "// Made by embed-shaders from the folder shaders/.\n#include \"gpu/device/ShaderLibrary.h\"\n\n"
           "namespace limen::gpu {\n\nstd::span<const EmbeddedShader> embeddedShaders() {\n"
           "    static const EmbeddedShader kShaders[] = {\n";
    for (int i = 4; i < argc; ++i) {
        Flattened shader;
        std::set<std::string> seen;
        if (!flattener.add(argv[i], shader, seen))
            return 1;
        writeShader(source, argv[i], shader);
    }
    source << "    };\n    return kShaders;\n}\n\n} // namespace limen::gpu\n";
    std::ofstream depfile(argv[2]);
    depfile << argv[1] << ":";
    for (const std::string& dependency : flattener.dependencies())
        depfile << " \\\n  " << dependency;
    depfile << "\n";
    return source.flush() && depfile.flush() ? 0 : 1;
}
