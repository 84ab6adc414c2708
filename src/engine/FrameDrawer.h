#pragma once

#include "core/Error.h"
#include "engine/OpenedWorld.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// Frames of a world for other projects (docs/tutorials/engine.md): without a window, or in an OpenGL program.
namespace limen::engine {

struct DrawerState;

/// The largest width or height of a frame in pixels. A driver may allow less.
inline constexpr std::uint32_t kMostPixelsPerSide = 16384;

/// All inputs of a frame but the world: equal descriptions give equal pictures on one driver.
struct FrameDescription {
    Viewpoint viewpoint;                      ///< the eye is within 1,000 km of the map's corner
    double fovDegrees = 60.0;                 ///< vertical field of view, 0.1 to 179
    std::uint32_t width = 1280, height = 720; ///< pixels, 1 to kMostPixelsPerSide
    double timeOfDay = 0.5;                   ///< 0 to 1; 0 and 1 are midnight
    double seconds = 0.0; ///< since the start of the world; moves people, clouds and smoke; within 1e9
    bool isRaining = false;
    std::optional<double> doors{}; ///< openness of all doors, 0 to 1; none: each as in the data
    /// Also draw the ids, for readIds, readDistances and surfaceAt. Such a frame has one sample a pixel, and tests the holes
    /// of leaves and fences exactly.
    bool withIds = false;
};

/// Options of a drawer.
struct DrawerOptions {
    int radius = 4;    ///< landblocks (192 m) each way around the eye's, loaded with everything; 0 to 16
    int farRadius = 0; ///< landblocks each way whose ground alone is loaded; 0 to 32
    std::uint32_t samples = 1; ///< samples a pixel: 1 or 4
};

/// Numbers of a drawn frame.
struct FrameCounts {
    std::uint32_t visits = 0;    ///< of the flood: one for each way by which rays of the eye reach a space
    std::uint32_t cellsSeen = 0; ///< without the outside
    std::uint32_t instances = 0; ///< meshes drawn
};

/// The surface at a pixel.
struct Surface {
    std::string kind;          ///< "shell", "terrain", "sky", "void", ...
    std::string space;         ///< "outside", the id of a cell as "0x%08X", or "none"
    std::string record;        ///< the record that has the surface, "0x%08X"; empty for sky and void
    std::uint32_t polygon = 0; ///< its polygon in the record
    std::uint64_t object = 0;  ///< equal for all surfaces of one object; 0 for sky and void
    std::string name;          ///< of an object of a `world.db`; else empty
    double distance = 0.0;     ///< metres along the pixel's ray; infinite for sky and void
};

/// Names of OpenGL objects that hold the last frame. They belong to the drawer: read them before the next call of draw, and
/// change nothing of them.
struct FrameObjects {
    std::uint32_t framebuffer = 0; ///< to copy from
    std::uint32_t colour = 0;      ///< 2D texture, RGBA8, sRGB values, one sample a pixel, bottom row first
    std::uint32_t ids = 0;         ///< 2D texture, R32UI; 0 for a frame of several samples a pixel
    /// 2D texture (multisampled, if the frame is), 32-bit float depth. The distance along the view's axis is nearPlane /
    /// depth; depth is 0 where nothing was hit.
    std::uint32_t depth = 0;
    double nearPlane = 0.0; ///< metres
};

/// Draws a world with OpenGL 4.5. It loads the landblocks around each eye, and keeps them until an eye is in another block.
///
/// **Threads.** One thread at a time. **Errors.** No function ends the program. After an error the drawer can be used again,
/// unless the device was reset. A drawer that was moved to another object gives BadArgument. **State.** Each call leaves the thread's current context, and all OpenGL state of the
/// caller's context, as before, but for pending GL errors, which are discarded.
class LIMEN_API FrameDrawer {
public:
    /// A drawer with a context of its own, for programs without a window. On Linux it is one of EGL; no GLX context may be
    /// current on the calling thread. Errors: BadArgument for options out of range; Driver.
    [[nodiscard]] static Result<FrameDrawer> headless(const OpenedWorld& world,
                                                      const DrawerOptions& options = {});
    /// A drawer in the caller's current context: a core profile, version 4.5 or later, of EGL, GLX or WGL. Each call needs
    /// the same context to be current, and no query, transform feedback or conditional rendering to be active. Errors:
    /// BadArgument without a current context or for options out of range; Driver, naming each feature that is missing.
    [[nodiscard]] static Result<FrameDrawer> onCurrentContext(const OpenedWorld& world,
                                                              const DrawerOptions& options = {});

    FrameDrawer(FrameDrawer&& other) noexcept;
    FrameDrawer& operator=(FrameDrawer&& other) noexcept;
    /// In the caller's context: if that is not current, the drawer's GL objects and memory stay until the process ends.
    ~FrameDrawer();

    /// Loads the landblocks around a viewpoint unless they are loaded, so that the next `draw` there need not. Cost: 0.1 s
    /// to seconds. Errors: as `draw`.
    [[nodiscard]] Result<void> load(const Viewpoint& viewpoint);
    /// Draws a frame into images of the drawer. Does not wait for the GPU. Errors: BadArgument for a description out of range
    /// (nothing is drawn); NotFound for a block or cell that does not exist; Malformed; Driver.
    [[nodiscard]] Result<FrameCounts> draw(const FrameDescription& frame);

    // The last frame. Errors of each: BadArgument before the first frame, after a failed one, or without ids where
    // they are needed; with the caller's context also if another context is current.

    /// Copies the picture into a framebuffer of the caller's context (0: the window's), its lower left corner at (x, y), at
    /// its own size; pixels beyond the framebuffer are left out. The framebuffer needs a colour image of RGB or RGBA values,
    /// which gets the sRGB values unchanged. Errors: BadArgument for a headless drawer, or a framebuffer that is not complete.
    [[nodiscard]] Result<void> copyTo(std::uint32_t framebuffer, std::int32_t x = 0, std::int32_t y = 0);
    /// Objects for other GL code, for example to draw objects of the caller in front of and behind surfaces. Errors:
    /// BadArgument for a headless drawer.
    [[nodiscard]] Result<FrameObjects> objects();
    /// R, G, B, A (255) bytes of each pixel, top row first, sRGB. Waits for the GPU.
    [[nodiscard]] Result<std::vector<std::uint8_t>> readColour();
    /// The id of each pixel's surface, top row first: 0 void, 1 sky, else a number within the loaded blocks. Needs ids.
    [[nodiscard]] Result<std::vector<std::uint32_t>> readIds();
    /// Metres from the eye along each pixel's ray, top row first; infinite for sky and void. Needs ids.
    [[nodiscard]] Result<std::vector<float>> readDistances();
    /// The surface at a pixel, counted from the upper left corner. Needs ids. Cost: reads three images. Errors: BadArgument
    /// for a pixel outside of the frame.
    [[nodiscard]] Result<Surface> surfaceAt(std::uint32_t x, std::uint32_t y);

    /// The driver in one line.
    [[nodiscard]] std::string driver() const;

private:
    explicit FrameDrawer(std::unique_ptr<DrawerState> state);

    std::unique_ptr<DrawerState> state_; ///< null after a move
};

} // namespace limen::engine
