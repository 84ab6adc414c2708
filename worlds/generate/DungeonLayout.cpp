#include "worlds/generate/DungeonLayout.h"

#include "worlds/pictures/Noise.h"

#include <algorithm>
#include <map>

namespace limen::worlds {

namespace {

constexpr double kPitch = 16.0, kStorey = 10.0, kStep = 0.75; ///< metres; all exact in binary
constexpr double kDeadEnd = 3.0;                              ///< metres
constexpr double kMargin = 8.0;

class Grower {
public:
    Grower(std::uint32_t cells, double overlapShare, Random random)
        : wanted_(cells), overlapShare_(overlapShare), random_(random), seed_(random_.next()) {
        while (static_cast<std::uint64_t>(side_) * side_ * side_ < cells)
            ++side_;
    }

    DungeonLayout run() {
        addRoom({static_cast<int>(side_) / 2, static_cast<int>(side_) / 2, static_cast<int>(side_) / 2}, 0);
        while (out_.cells < wanted_)
            grow();
        for (LatticeRoom& room : out_.rooms)
            room.form = formOf(room);
        return std::move(out_);
    }

private:
    void addRoom(const std::array<int, 3>& node, std::uint8_t size) {
        LatticeRoom room;
        room.node = node;
        room.size = size;
        room.cell = out_.cells++;
        // Rows along x are level, which gives long sight lines; neighbouring rows differ in height.
        const std::uint32_t row = rowHash(node);
        room.floor = {kMargin + kPitch * node[0], kMargin + kPitch * node[1],
                      kStorey * (node[2] + 1) + kStep * (row % 3)};
        at_[node] = static_cast<std::uint32_t>(out_.rooms.size());
        out_.rooms.push_back(room);
    }

    [[nodiscard]] std::uint32_t rowHash(const std::array<int, 3>& node) const {
        return hash(static_cast<std::uint32_t>(node[1]), static_cast<std::uint32_t>(node[2]), seed_);
    }

    [[nodiscard]] std::uint32_t roomAt(const std::array<int, 3>& node) const {
        const auto found = at_.find(node);
        return found == at_.end() ? kNothing : found->second;
    }

    [[nodiscard]] bool inside(const std::array<int, 3>& node) const {
        return std::all_of(node.begin(), node.end(),
                           [&](int v) { return v >= 0 && v < static_cast<int>(side_); });
    }

    static std::array<int, 3> step(std::array<int, 3> node, std::size_t way, int steps) {
        node[way / 2] += way % 2 == 0 ? -steps : steps;
        return node;
    }

    /// Tries once to add a dead end, a passage through a room, a loop, or a room.
    void grow() {
        const auto count = static_cast<std::uint32_t>(out_.rooms.size());
        const bool onwards = random_.chance(0.6);
        const std::uint32_t room = onwards ? count - 1 : random_.below(count);
        std::size_t way = random_.chance(0.15) ? 4 + random_.below(2) : random_.below(4);
        if (onwards && random_.chance(0.6))
            way = lastWay_;
        const std::uint32_t left = wanted_ - out_.cells;
        if (out_.crossings < overlapShare_ * out_.cells) {
            constexpr int kTries = 24; // few rows have three rooms with free sides
            for (int k = 0; k < kTries; ++k)
                if (addCrossing(random_.below(count)))
                    return;
        }
        if (random_.chance(left == 1 ? 0.5 : 0.04)) {
            addDeadEnd(random_.below(count), random_.chance(0.5) ? 1 : 3);
            return;
        }
        const std::array<int, 3> node = step(out_.rooms[room].node, way, 1);
        if (out_.rooms[room].doors[way] != Door::None || !inside(node))
            return;
        std::uint32_t other = roomAt(node);
        if (other != kNothing &&
            (out_.rooms[other].doors[opposite(way)] != Door::None || !random_.chance(0.35)))
            return; // a passage through this room may use the other side
        if (other == kNothing) {
            if (left < 2)
                return;
            const auto size = static_cast<std::uint8_t>(random_.below(kRoomSizes.size()));
            other = count;
            addRoom(node, size);
            lastWay_ = way;
        }
        join(way % 2 == 0 ? other : room, way % 2 == 0 ? room : other, way | 1u, pickDoor(room, way));
    }

    Door pickDoor(std::uint32_t room, std::size_t way) {
        if (way >= 4)
            return random_.chance(0.5) ? Door::Narrow : Door::Wide;
        if (way < 2 && rowHash(out_.rooms[room].node) % 2 == 0)
            return Door::Wide;
        return static_cast<Door>(random_.below(4));
    }

    [[nodiscard]] double gapBetween(const LatticeRoom& a, const LatticeRoom& b, std::size_t way) const {
        const RoomSize& sa = kRoomSizes[a.size];
        const RoomSize& sb = kRoomSizes[b.size];
        switch (way / 2) {
        case 0:
            return b.floor.x - a.floor.x - sa.halfX - sb.halfX;
        case 1:
            return b.floor.y - a.floor.y - sa.halfY - sb.halfY;
        default:
            return b.floor.z - a.floor.z - sa.height;
        }
    }

    /// `way` is east, north or up. Rooms that touch are joined only if they are level. A new room is always
    /// joined: it is tried in smaller sizes.
    void join(std::uint32_t from, std::uint32_t to, std::size_t way, Door door) {
        LatticeRoom& a = out_.rooms[from];
        LatticeRoom& b = out_.rooms[to];
        double gap = gapBetween(a, b, way);
        const bool unevenTouch = gap <= 0.0 && a.floor.z != b.floor.z;
        if (unevenTouch) {
            const std::uint32_t newest = static_cast<std::uint32_t>(out_.rooms.size()) - 1;
            if (isJoined(newest) || (from != newest && to != newest))
                return;
            out_.rooms[newest].size = 1;
            gap = gapBetween(a, b, way);
        }
        addPassage(from, to, way, door, gap);
    }

    [[nodiscard]] bool isJoined(std::uint32_t room) const {
        const auto& passages = out_.rooms[room].passages;
        return std::any_of(passages.begin(), passages.end(), [](std::uint32_t p) { return p != kNothing; });
    }

    void addPassage(std::uint32_t from, std::uint32_t to, std::size_t way, Door door, double length) {
        Passage passage;
        passage.from = from;
        passage.to = to;
        passage.way = static_cast<Way>(way);
        passage.door = door;
        passage.length = length;
        if (length > 0.0) {
            if (out_.cells >= wanted_)
                return;
            passage.cell = out_.cells++;
        }
        const auto index = static_cast<std::uint32_t>(out_.passages.size());
        out_.passages.push_back(passage);
        out_.rooms[from].doors[way] = door;
        out_.rooms[from].passages[way] = index;
        if (to != kNothing) {
            out_.rooms[to].doors[opposite(way)] = door;
            out_.rooms[to].passages[opposite(way)] = index;
        }
    }

    void addDeadEnd(std::uint32_t room, std::size_t way) {
        const LatticeRoom& from = out_.rooms[room];
        const double half = way == 1 ? kRoomSizes[from.size].halfX : kRoomSizes[from.size].halfY;
        if (from.doors[way] == Door::None && half + kDeadEnd <= kPitch / 2)
            addPassage(room, kNothing, way, static_cast<Door>(random_.below(4)), kDeadEnd);
    }

    /// Adds a passage from a room straight through its neighbour's space to the room behind.
    bool addCrossing(std::uint32_t room) {
        const std::size_t way = random_.chance(0.5) ? 1 : 3;
        const std::uint32_t middle = roomAt(step(out_.rooms[room].node, way, 1));
        const std::uint32_t far = roomAt(step(out_.rooms[room].node, way, 2));
        if (middle == kNothing || far == kNothing || out_.rooms[room].doors[way] != Door::None ||
            out_.rooms[far].doors[opposite(way)] != Door::None)
            return false;
        addPassage(room, far, way, static_cast<Door>(random_.below(4)),
                   gapBetween(out_.rooms[room], out_.rooms[far], way));
        ++out_.crossings;
        return true;
    }

    Form formOf(const LatticeRoom& room) {
        const auto free = [&](Way way) { return room.doors[static_cast<std::size_t>(way)] == Door::None; };
        if (!free(Way::Up) || !free(Way::Down) || !random_.chance(0.4))
            return Form::Box;
        std::vector<Form> forms;
        const auto offer = [&](Form form, bool possible) {
            if (possible)
                forms.push_back(form);
        };
        const bool w = free(Way::West), e = free(Way::East), s = free(Way::South), n = free(Way::North);
        offer(Form::NoSouthWest, s && w);
        offer(Form::NoSouthEast, s && e);
        offer(Form::NoNorthWest, n && w);
        offer(Form::NoNorthEast, n && e);
        offer(Form::NoWest, w);
        offer(Form::NoEast, e);
        offer(Form::NoSouth, s);
        offer(Form::NoNorth, n);
        return forms.empty() ? Form::Box : forms[random_.below(static_cast<std::uint32_t>(forms.size()))];
    }

    std::uint32_t wanted_;
    double overlapShare_;
    Random random_;
    std::uint32_t seed_;
    std::uint32_t side_ = 2;
    std::size_t lastWay_ = 1;
    std::map<std::array<int, 3>, std::uint32_t> at_;
    DungeonLayout out_;
};

} // namespace

DungeonLayout layOutDungeon(std::uint32_t cells, double overlapShare, Random random) {
    return Grower(cells, overlapShare, random).run();
}

} // namespace limen::worlds
