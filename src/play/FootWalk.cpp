#include "play/FootWalk.h"

#include "engine/CheckView.h"
#include "engine/report/DecisionHash.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace limen::play {
namespace {

constexpr double kReached = 0.15;      // horizontal metres from a way point at which it counts as reached
constexpr double kPace = 2.5;          // metres a second, half the running speed: one step does not overshoot
constexpr double kLevel = 1.0;         // largest vertical distance to a reached way point, metres
constexpr double kTurningPace = 240.0; // degrees a second, yaw
constexpr double kNod = 60.0;          // degrees a second, pitch
constexpr double kAhead = 40.0;        // degrees off the heading: beyond this the body turns before it walks
constexpr double kPatience = 1.5;      // seconds without progress before the walker tries another way
constexpr std::array kSquares{0.25, 0.15}; // metres: squares of a way around obstacles, finer for narrow gaps
constexpr double kSwing = 1.5;             // seconds for a door to swing and for the body to return to it
constexpr double kBack = 0.5;              // seconds of these in which the body steps back from the leaf
constexpr int kUses = 2;                   // of doors on the way to one way point
constexpr std::size_t kTries = 8;          // consecutive way points missed before a jump
constexpr double kNearer = 0.02;           // metres, the least progress
constexpr double kAtPlace = 1.0;           // largest distance between a place and a way point at it, metres
constexpr double kWayPointHeight = 1.7;    // metres: way points are eye positions

double levelDistance(const Vec3& a, const Vec3& b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

class Walker {
public:
    Walker(engine::Session& session, const engine::FrameRequest& start,
           const std::vector<engine::ViewRequest>& points, const FootWalkOptions& options)
        : session_(session), play_(session, start), points_(points), options_(options), size_(start.size) {
        walk_.record.start = check::shotOptions(engine::viewOf(start, session.part().world));
    }

    Result<FootWalk> run(const std::function<void(std::size_t)>& done) {
        acts_.push_back({PlayActKind::Walk});
        if (options_.chase)
            acts_.push_back({PlayActKind::Chase});
        if (Result<void> began = frame({}); !began)
            return Failure(began.error());
        for (std::size_t i = 0, missed = 0; i < points_.size();) {
            if (i > 0 && isJump(points_[i - 1], points_[i])) {
                for (const std::size_t there = jumpBeyond(i - 1); i < there; ++i)
                    walk_.missed.push_back(i);
                if (i == points_.size())
                    break; // no named place is there
            }
            const Result<bool> there = goTo(points_[i]);
            if (!there)
                return Failure(there.error());
            if (!*there)
                walk_.missed.push_back(i);
            missed = *there ? 0 : missed + 1;
            i = missed < kTries ? i + 1 : jumpBeyond(i - missed + 1);
            missed %= kTries;
            if (done)
                done(std::min(i, points_.size()));
        }
        return std::move(walk_);
    }

private:
    [[nodiscard]] Vec3 feet() const { return play_.walk().body().standing.feet; }
    [[nodiscard]] static bool isJump(const engine::ViewRequest& from, const engine::ViewRequest& to) {
        const auto placeOf = [](const engine::ViewRequest& point) {
            world::Place place;
            place.eye = point.eye;
            place.cell = point.root.value_or(engine::RootChoice()).cell;
            return place;
        };
        return world::isJump(placeOf(from), placeOf(to));
    }
    [[nodiscard]] static Vec3 feetAt(const engine::ViewRequest& point) {
        return point.eye - Vec3(0.0, 0.0, kWayPointHeight);
    }

    /// Goes straight to a way point, and around obstacles if that fails. False if the body does not get there.
    Result<bool> goTo(const engine::ViewRequest& point) {
        const Vec3 target = feetAt(point);
        const double pitch = point.pitch.value_or(0.0);
        Result<bool> straight = goTo(target, pitch);
        if (!straight || *straight)
            return straight;
        for (const double square : kSquares) {
            Result<bool> there = goAround(target, pitch, square);
            if (!there || *there)
                return there;
        }
        return false;
    }
    Result<bool> goAround(const Vec3& target, double pitch, double square) {
        const motion::Detour detour = play_.walk().wayAround(target, square);
        if (!detour.reaches)
            return false;
        for (const Vec3& corner : detour.corners)
            if (Result<bool> there = goTo(corner, pitch); !there || !*there)
                return there;
        return true;
    }
    /// The same straight. False if the body makes no more progress.
    Result<bool> goTo(const Vec3& target, double pitch) {
        const double reached = std::max(kReached, kPace / options_.fps);
        double best = levelDistance(feet(), target), waited = 0.0;
        int uses = kUses;
        while (best >= reached) {
            if (waited > kPatience)
                return false;
            if (waited > 0.5 * kPatience && uses > 0 && useTheDoor()) {
                waited = -kSwing;
                --uses;
            }
            widenTheDoor();
            PlayInput input = towards(target, pitch);
            if (waited < kBack - kSwing) // leaves room for the leaf
                input.forward = -input.forward;
            if (Result<void> stepped = frame(std::move(input)); !stepped)
                return Failure(stepped.error());
            const double now = levelDistance(feet(), target);
            waited = now < best - kNearer ? 0.0 : waited + 1.0 / options_.fps;
            best = waited == 0.0 ? now : best;
        }
        return std::abs(feet().z - target.z) < kLevel;
    }

    [[nodiscard]] PlayInput towards(const Vec3& target, double pitch) const {
        const engine::Heading& heading = play_.request().camera.heading;
        const Vec3 way = target - feet();
        const double turn = std::remainder(glm::degrees(std::atan2(way.x, way.y)) - heading.yaw, 360.0);
        PlayInput input;
        input.turnRight = std::clamp(turn, -kTurningPace / options_.fps, kTurningPace / options_.fps);
        input.turnUp = std::clamp(pitch - heading.pitch, -kNod / options_.fps, kNod / options_.fps);
        input.forward = std::abs(turn) < kAhead ? 1.0 : 0.0;
        input.fast = options_.run;
        return input;
    }

    /// Opens a shut door, and shuts one whose open leaf is in the way.
    bool useTheDoor() {
        const std::optional<std::size_t> door = play_.doorInReach();
        if (!door || session_.part().world.doors[*door].portal == world::kNone)
            return false; // a chest is in nobody's way
        acts_.push_back({PlayActKind::Use});
        return true;
    }

    /// Opens a door that is ajar before the body is beside its leaf. The first use shuts it, the second opens
    /// it.
    void widenTheDoor() {
        const std::optional<std::size_t> door = play_.doorInReach();
        const std::vector<double>& open = play_.request().scene.eachDoor;
        if (!door || *door >= open.size() || !(open[*door] > 0.0 && open[*door] < 1.0))
            return;
        if (widened_.insert(session_.part().world.doors[*door].name).second)
            acts_.insert(acts_.end(), 2, {PlayActKind::Use});
    }

    Result<void> frame(PlayInput input) {
        input.seconds = 1.0 / options_.fps;
        input.size = size_;
        input.acts = std::exchange(acts_, {});
        if (Result<void> stepped = play_.step(input); !stepped)
            return stepped;
        if (Result<void> drawn = session_.draw(play_.request(), {}); !drawn)
            return drawn;
        const std::uint64_t decided =
            engine::decisionHash(play_.request(), session_.visible(), session_.dynamics());
        walk_.record.frames.push_back({std::move(input), decided, {}});
        return {};
    }

    /// Finds the first way point after `from` that is at a named place, and queues a jump to it. Returns its
    /// index, or the number of way points if there is none.
    std::size_t jumpBeyond(std::size_t from) {
        const std::vector<world::Place>& places = session_.source().file.places;
        for (std::size_t i = from + 1; i < points_.size(); ++i) {
            for (std::size_t p = 0; p < places.size(); ++p) {
                if (glm::length(places[p].eye - points_[i].eye) > kAtPlace)
                    continue;
                acts_.push_back({PlayActKind::Place, static_cast<double>(p)});
                walk_.jumps.push_back(places[p].name);
                return i;
            }
        }
        return points_.size();
    }

    engine::Session& session_;
    Play play_;
    const std::vector<engine::ViewRequest>& points_;
    const FootWalkOptions& options_;
    const engine::PixelSize size_;
    std::vector<PlayAct> acts_;     ///< of the next frame
    std::set<std::string> widened_; ///< names of doors that were ajar
    FootWalk walk_;
};

} // namespace

Result<FootWalk> walkOnFoot(engine::Session& session, const engine::FrameRequest& start,
                            const std::vector<engine::ViewRequest>& points, const FootWalkOptions& options,
                            const std::function<void(std::size_t)>& done) {
    return Walker(session, start, points, options).run(done);
}

} // namespace limen::play
