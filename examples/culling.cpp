// Culling in a plain OpenGL program. The visibility library finds the rooms that the eye sees; GLFW opens the window and
// OpenGL 3.3 draws. A house of twelve rooms with furniture; the eye turns around in one of them.
//
//     culling                                a window. Keys 1, 2, 3: draw all rooms, cull by scissor, cull by stencil
//     culling all|scissor|stencil FILE.ppm   draws one frame into a file, and prints triangles and regions

#include <limen/visibility/Flood.h>
#include <limen/visibility/GraphBuilder.h>
#include <limen/visibility/RegionPixels.h>
#include <limen/visibility/RegionPlanes.h>

#include <epoxy/gl.h>

#include <GLFW/glfw3.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

namespace vis = limen::visibility;
using limen::Vec3;

namespace {

constexpr std::uint32_t kColumns = 4, kRows = 3, kWidth = 640, kHeight = 480;
constexpr double kSide = 5, kCeiling = 3, kDoorLeft = 2, kDoorRight = 3, kDoorTop = 2.1; // metres
constexpr Vec3 kEye{7.5, 1.2, 1.6}; // in the second room of the first row

enum class Way { All, Scissor, Stencil };

struct Corner {
    float position[3], colour[3];
};
struct Run {
    GLint first = 0;
    GLsizei count = 0;
};
struct House {
    vis::BuiltGraph built;
    std::vector<Corner> corners;
    std::vector<Run> rooms; // by space
};

// The house.

/// Two triangles; the corners are counter-clockwise as seen from their front.
void addQuad(std::vector<Corner>& to, const std::array<Vec3, 4>& quad, const Vec3& colour) {
    for (const int i : {0, 1, 2, 0, 2, 3}) {
        const Vec3& at = quad[static_cast<std::size_t>(i)];
        to.push_back(
            {{static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z)},
             {static_cast<float>(colour.x), static_cast<float>(colour.y), static_cast<float>(colour.z)}});
    }
}

/// A part of a wall that begins at `corner` and runs along `along`: from `a` to `b` metres, from `low` to `high`.
std::array<Vec3, 4> wallPart(const Vec3& corner, const Vec3& along, double a, double b, double low,
                             double high) {
    const auto at = [&](double s, double z) { return corner + s * along + Vec3(0, 0, z); };
    return {at(a, low), at(b, low), at(b, high), at(a, high)};
}

void addWall(std::vector<Corner>& to, const Vec3& corner, const Vec3& along, bool hasDoor,
             const Vec3& colour) {
    if (!hasDoor)
        return addQuad(to, wallPart(corner, along, 0, kSide, 0, kCeiling), colour);
    addQuad(to, wallPart(corner, along, 0, kDoorLeft, 0, kCeiling), colour);
    addQuad(to, wallPart(corner, along, kDoorRight, kSide, 0, kCeiling), colour);
    addQuad(to, wallPart(corner, along, kDoorLeft, kDoorRight, kDoorTop, kCeiling), colour);
}

/// A crate of `size` metres on the floor, without its lower side.
void addCrate(std::vector<Corner>& to, const Vec3& at, double size, const Vec3& colour) {
    const Vec3 x(size, 0, 0), y(0, size, 0), z(0, 0, size);
    addQuad(to, {at, at + x, at + x + z, at + z}, 0.7 * colour);
    addQuad(to, {at + x, at + x + y, at + x + y + z, at + x + z}, 0.9 * colour);
    addQuad(to, {at + x + y, at + y, at + y + z, at + x + y + z}, 0.7 * colour);
    addQuad(to, {at + y, at, at + z, at + y + z}, 0.9 * colour);
    addQuad(to, {at + z, at + x + z, at + x + y + z, at + y + z}, colour);
}

/// All doors between neighbours are there, but for those that lead north from the columns 0 and 3.
bool opensNorth(std::uint32_t column, std::uint32_t row) {
    return row + 1 < kRows && column != 0 && column != 3;
}

void addRoom(std::vector<Corner>& to, std::uint32_t column, std::uint32_t row) {
    const Vec3 at(kSide * column, kSide * row, 0), x(1, 0, 0), y(0, 1, 0);
    const Vec3 colour(0.4 + 0.15 * column, 0.9 - 0.2 * row, 0.45 + 0.1 * ((column + row) % 3));
    addWall(to, at + kSide * y, x, opensNorth(column, row), colour);                        // faces south
    addWall(to, at + kSide * x, -x, row > 0 && opensNorth(column, row - 1), 0.95 * colour); // faces north
    addWall(to, at, y, column > 0, 0.85 * colour);                                          // faces east
    addWall(to, at + kSide * (x + y), -y, column + 1 < kColumns, 0.8 * colour);             // faces west
    addQuad(to, {at, at + kSide * x, at + kSide * (x + y), at + kSide * y}, 0.5 * colour);  // floor
    const Vec3 top = at + Vec3(0, 0, kCeiling);
    addQuad(to, {top, top + kSide * y, top + kSide * (x + y), top + kSide * x}, Vec3(0.95)); // ceiling
    for (int i = 0; i < 12; ++i)
        addCrate(to, at + Vec3(0.4 + 1.3 * (i % 4), 3.3 + 0.5 * (i / 4), 0), 0.3 + 0.02 * i,
                 Vec3(0.8, 0.6, 0.35));
}

limen::Result<House> buildHouse() {
    House house;
    vis::GraphBuilder graph;
    for (std::uint32_t row = 0; row < kRows; ++row)
        for (std::uint32_t column = 0; column < kColumns; ++column) {
            const auto first = house.corners.size();
            addRoom(house.corners, column, row);
            graph.addSpace();
            house.rooms.push_back(
                {static_cast<GLint>(first), static_cast<GLsizei>(house.corners.size() - first)});
        }
    for (std::uint32_t row = 0; row < kRows; ++row)
        for (std::uint32_t column = 0; column < kColumns; ++column) {
            const std::uint32_t room = row * kColumns + column;
            const Vec3 at(kSide * column, kSide * row, 0), x(1, 0, 0), y(0, 1, 0);
            const auto door = [&](const Vec3& corner, const Vec3& along, std::uint32_t to) {
                const auto quad = wallPart(corner, along, kDoorLeft, kDoorRight, 0, kDoorTop);
                graph.addOpening({.from = room, .to = to, .polygon = {quad.begin(), quad.end()}});
            };
            if (column + 1 < kColumns)
                door(at + kSide * (x + y), -y, room + 1);
            if (opensNorth(column, row))
                door(at + kSide * y, x, room + kColumns);
        }
    auto built = graph.build();
    if (!built)
        return limen::Failure(built.error());
    house.built = std::move(*built);
    return house;
}

// OpenGL.

GLuint programOf(const char* vertexSource, const char* fragmentSource) {
    const GLuint program = glCreateProgram();
    for (const auto& [kind, source] :
         {std::pair{GL_VERTEX_SHADER, vertexSource}, std::pair{GL_FRAGMENT_SHADER, fragmentSource}}) {
        const GLuint shader = glCreateShader(static_cast<GLenum>(kind));
        glShaderSource(shader, 1, &source, nullptr);
        glCompileShader(shader);
        glAttachShader(program, shader);
    }
    glLinkProgram(program);
    GLint linked = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    return linked ? program : 0;
}

/// Positions to clip space: rows of right, up and forward, and a depth between 5 cm and 100 m. Column by column.
std::array<float, 16> clipFromWorld(const vis::View& view) {
    constexpr double near = 0.05, far = 100;
    const Vec3 rows[4] = {view.right / view.tanHalfX, view.up / view.tanHalfY,
                          view.forward * ((far + near) / (far - near)), view.forward};
    std::array<float, 16> matrix{};
    for (std::size_t row = 0; row < 4; ++row) {
        for (int axis = 0; axis < 3; ++axis)
            matrix[static_cast<std::size_t>(axis) * 4 + row] = static_cast<float>(rows[row][axis]);
        matrix[12 + row] = static_cast<float>(-glm::dot(rows[row], view.eye));
    }
    matrix[14] -= static_cast<float>(2 * far * near / (far - near));
    return matrix;
}

/// The buffers and programs. The stencil's triangles are positions in clip space.
struct Drawer {
    GLuint houseArray = 0, regionArray = 0, regionBuffer = 0, houseProgram = 0, regionProgram = 0;
    std::vector<limen::Vec4f> triangles;
};

Drawer makeDrawer(const House& house) {
    Drawer drawer;
    GLuint buffers[2], arrays[2];
    glGenBuffers(2, buffers);
    glGenVertexArrays(2, arrays);
    drawer.houseArray = arrays[0], drawer.regionArray = arrays[1], drawer.regionBuffer = buffers[1];
    glBindVertexArray(arrays[0]);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(house.corners.size() * sizeof(Corner)),
                 house.corners.data(), GL_STATIC_DRAW);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Corner), nullptr);
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(Corner),
                          reinterpret_cast<const void*>(offsetof(Corner, colour)));
    glEnableVertexAttribArray(0);
    glEnableVertexAttribArray(1);
    glBindVertexArray(arrays[1]);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[1]);
    glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(limen::Vec4f), nullptr);
    glEnableVertexAttribArray(0);
    drawer.houseProgram = programOf(
        "#version 330\nlayout(location = 0) in vec3 at; layout(location = 1) in vec3 colour; uniform mat4 "
        "clip;"
        "flat out vec3 paint; void main() { gl_Position = clip * vec4(at, 1); paint = colour; }",
        "#version 330\nflat in vec3 paint; out vec4 colour; void main() { colour = vec4(paint, 1); }");
    drawer.regionProgram =
        programOf("#version 330\nlayout(location = 0) in vec4 at; void main() { gl_Position = at; }",
                  "#version 330\nvoid main() {}");
    return drawer;
}

void drawRoom(const Drawer& drawer, const House& house, std::uint32_t room) {
    glUseProgram(drawer.houseProgram);
    glBindVertexArray(drawer.houseArray);
    glDrawArrays(GL_TRIANGLES, house.rooms[room].first, house.rooms[room].count);
}

/// Writes `value` into the stencil buffer where the region is, and lets later triangles pass there only.
void keepRegion(Drawer& drawer, std::span<const Vec3> region, GLint value) {
    vis::trianglesOf(region, drawer.triangles);
    glUseProgram(drawer.regionProgram);
    glBindVertexArray(drawer.regionArray);
    glBindBuffer(GL_ARRAY_BUFFER, drawer.regionBuffer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(drawer.triangles.size() * sizeof(limen::Vec4f)),
                 drawer.triangles.data(), GL_STREAM_DRAW);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDisable(GL_DEPTH_TEST);
    glStencilFunc(GL_ALWAYS, value, 0xff);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(drawer.triangles.size()));
    glStencilFunc(GL_EQUAL, value, 0xff);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    glEnable(GL_DEPTH_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

/// Draws the frame; returns the triangles drawn.
int draw(Drawer& drawer, const House& house, const vis::View& view, const vis::VisibleSet& seen, Way way) {
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_STENCIL_TEST);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glUseProgram(drawer.houseProgram);
    glUniformMatrix4fv(glGetUniformLocation(drawer.houseProgram, "clip"), 1, GL_FALSE,
                       clipFromWorld(view).data());
    int corners = 0;
    if (way == Way::All)
        for (std::uint32_t room = 0; room < house.rooms.size(); ++room)
            drawRoom(drawer, house, room), corners += house.rooms[room].count;
    GLint number = 0;
    for (const vis::Visit& visit : way == Way::All ? std::vector<vis::Visit>{} : seen.visits) {
        const auto region = seen.region(visit);
        if (way == Way::Scissor) {
            const vis::PixelRect box = vis::scissorOf(region, kWidth, kHeight);
            glEnable(GL_SCISSOR_TEST);
            glScissor(static_cast<GLint>(box.x), static_cast<GLint>(box.y), static_cast<GLsizei>(box.width),
                      static_cast<GLsizei>(box.height));
        } else {
            glEnable(GL_STENCIL_TEST);
            keepRegion(drawer, region, number++ % 255 + 1);
        }
        drawRoom(drawer, house, visit.space);
        corners += house.rooms[visit.space].count;
    }
    return corners / 3;
}

// The program.

bool writePicture(const char* path) {
    std::vector<unsigned char> pixels(std::size_t{3} * kWidth * kHeight);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, kWidth, kHeight, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
    std::FILE* file = std::fopen(path, "wb");
    if (file == nullptr)
        return false;
    std::fprintf(file, "P6\n%u %u\n255\n", kWidth, kHeight);
    for (std::size_t row = kHeight; row-- > 0;) // OpenGL's first row is the lowest
        std::fwrite(&pixels[row * 3 * kWidth], 3, kWidth, file);
    return std::fclose(file) == 0;
}

void printRegions(const vis::VisibleSet& seen) {
    for (const vis::Visit& visit : seen.visits) {
        std::printf("region of %u:", visit.space);
        for (const Vec3& corner :
             seen.region(visit)) // pixels from the lower left corner; w > 0 but in the plane of the eye
            std::printf(" %.3f %.3f", (corner.x / corner.z + 1) / 2 * kWidth,
                        (corner.y / corner.z + 1) / 2 * kHeight);
        std::printf("\n");
    }
}

std::optional<Way> wayOf(const std::string& name) {
    if (name == "all")
        return Way::All;
    if (name == "scissor")
        return Way::Scissor;
    return name == "stencil" ? std::optional(Way::Stencil) : std::nullopt;
}

GLFWwindow* openWindow(bool visible) {
    if (!glfwInit())
        return nullptr;
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_RESIZABLE, GLFW_FALSE);
    glfwWindowHint(GLFW_VISIBLE, visible ? GLFW_TRUE : GLFW_FALSE);
    GLFWwindow* window = glfwCreateWindow(kWidth, kHeight, "culling", nullptr, nullptr);
    if (window != nullptr)
        glfwMakeContextCurrent(window);
    return window;
}

int fail(const char* text) {
    std::fprintf(stderr, "culling: %s\n", text);
    return 2;
}

/// Floods from the eye, which looks `degrees` clockwise from north.
limen::Result<vis::View> flood(const House& house, double degrees, vis::FloodScratch& scratch,
                               vis::VisibleSet& seen) {
    const double yaw = degrees * 3.14159265358979 / 180;
    auto view = vis::viewOf({.eye = kEye,
                             .target = kEye + Vec3(std::sin(yaw), std::cos(yaw), -0.05),
                             .heightDegrees = 60,
                             .aspect = static_cast<double>(kWidth) / kHeight,
                             .root = 1});
    if (!view)
        return view;
    if (const auto flooded = vis::flood(house.built.graph, {}, *view, {}, scratch, seen); !flooded)
        return limen::Failure(flooded.error());
    return view;
}

/// Draws until the window is closed. The eye turns once in twenty seconds.
int run(GLFWwindow* window, Drawer& drawer, const House& house) {
    vis::FloodScratch scratch;
    vis::VisibleSet seen;
    Way way = Way::Stencil;
    while (!glfwWindowShouldClose(window)) {
        const auto view = flood(house, 18 * glfwGetTime(), scratch, seen);
        if (!view)
            return fail(view.error().message().c_str());
        for (const auto& [key, chosen] :
             {std::pair{GLFW_KEY_1, Way::All}, std::pair{GLFW_KEY_2, Way::Scissor},
              std::pair{GLFW_KEY_3, Way::Stencil}})
            if (glfwGetKey(window, key) == GLFW_PRESS)
                way = chosen;
        const int triangles = draw(drawer, house, *view, seen, way);
        glfwSetWindowTitle(window, (std::to_string(triangles) + " triangles").c_str());
        glfwSwapBuffers(window);
        glfwPollEvents();
    }
    return 0;
}

int drawOnce(Drawer& drawer, const House& house, Way way, const char* path) {
    vis::FloodScratch scratch;
    vis::VisibleSet seen;
    const auto view = flood(house, 20, scratch, seen);
    if (!view)
        return fail(view.error().message().c_str());
    std::printf("%d triangles\n", draw(drawer, house, *view, seen, way));
    printRegions(seen);
    return writePicture(path) ? 0 : fail("the picture cannot be written");
}

} // namespace

int main(int argc, char** argv) {
    const std::optional<Way> way = argc == 3 ? wayOf(argv[1]) : std::nullopt;
    if (argc != 1 && !way)
        return fail("usage: culling [all|scissor|stencil FILE.ppm]");
    const auto house = buildHouse();
    if (!house)
        return fail(house.error().message().c_str());
    GLFWwindow* window = openWindow(!way);
    if (window == nullptr)
        return fail("no window with OpenGL 3.3 can be opened");
    Drawer drawer = makeDrawer(*house);
    const int result = drawer.houseProgram == 0 || drawer.regionProgram == 0
                           ? fail("a shader does not compile")
                       : way ? drawOnce(drawer, *house, *way, argv[2])
                             : run(window, drawer, *house);
    glfwTerminate();
    return result;
}
