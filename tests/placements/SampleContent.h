#pragma once

#include "placements/TemplateFields.h"

#include <array>
#include <random>

namespace limen::test {

/// A made-up content with every member in use: the same for the same seed. Names hold quotes, backslashes, line breaks,
/// comment marks and characters of two to four bytes.
class SampleContent {
public:
    explicit SampleContent(unsigned seed) : random_(seed) {}

    [[nodiscard]] placements::Content make(int landblocks, int templates) {
        placements::Content content;
        for (int i = 0; i < templates; ++i) {
            const auto id = static_cast<std::uint32_t>(i * 7 + 1);
            content.templates.emplace(id, makeTemplate(id));
        }
        std::uint32_t guid = 0x70000000;
        for (int i = 0; i < landblocks; ++i) {
            const std::uint32_t id = 0x0100u + static_cast<std::uint32_t>(i) * 0x0101u;
            placements::Landblock landblock;
            const int count = 1 + pick(12);
            for (int k = 0; k < count; ++k)
                landblock.placements.push_back({guid++, static_cast<std::uint32_t>(pick(templates)) * 7 + 1,
                                                makeSpot(id << 16), pick(2) == 1});
            for (int k = 1; k < count; k += 3)
                landblock.links.push_back(
                    {landblock.placements[0].guid, landblock.placements[static_cast<std::size_t>(k)].guid});
            content.landblocks.emplace(id, std::move(landblock));
        }
        return content;
    }

private:
    [[nodiscard]] int pick(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
    [[nodiscard]] std::uint32_t any() { return static_cast<std::uint32_t>(random_()); }
    [[nodiscard]] float number() {
        const float value =
            static_cast<float>(pick(2'000'001) - 1'000'000) / static_cast<float>(1 + pick(9999));
        return value == 0.0f ? 0.0f : value;
    }
    [[nodiscard]] placements::Spot makeSpot(std::uint32_t landblock) {
        return {landblock | static_cast<std::uint32_t>(pick(0x300)),
                {number(), number(), number()},
                {number(), number(), number(), number()}};
    }
    [[nodiscard]] std::string makeName() {
        constexpr std::array kPieces{"Door",   "'", "\\", "\"",     "\n",         "-- ", "/* ", "*/", ";",
                                     "\u00E9", "%", "_",  "\u20AC", "\U0001F6AA", "`",   "#",   " ",  "N''s"};
        std::string name;
        for (int i = pick(6); i > 0; --i)
            name += kPieces[static_cast<std::size_t>(pick(static_cast<int>(kPieces.size())))];
        return name;
    }
    template <class T>
    void maybe(std::optional<T>& out, T value) {
        if (pick(2) == 1)
            out = value;
    }

    [[nodiscard]] placements::Template makeTemplate(std::uint32_t id) {
        placements::Template of;
        of.id = id;
        of.className = "class-" + std::to_string(id);
        of.type = pick(40);
        of.name = makeName();
        for (const auto& field : placements::kIdFields)
            of.*(field.member) = pick(2) == 1 ? any() : 0;
        for (const auto& field : placements::kIntFields)
            maybe(of.*(field.member), static_cast<std::int32_t>(any()));
        for (const auto& field : placements::kRealFields)
            maybe(of.*(field.member), static_cast<double>(pick(1000)) / 7.0);
        for (const auto& field : placements::kBoolFields)
            maybe(of.*(field.member), pick(2) == 1);
        for (int i = pick(3); i > 0; --i)
            of.palettes.push_back({any(), static_cast<std::uint16_t>(any()), static_cast<std::uint16_t>(i)});
        for (int i = pick(3); i > 0; --i)
            of.textures.push_back({static_cast<std::uint8_t>(i), any(), any()});
        for (int i = pick(3); i > 0; --i)
            of.parts.push_back({static_cast<std::uint8_t>(i), any()});
        for (int i = pick(3); i > 0; --i)
            of.items.push_back({pick(100) - 50, any(), pick(90), number()});
        for (int i = pick(3); i > 0; --i)
            of.generator.push_back(makeGenerator());
        if (pick(3) == 0)
            of.destination = makeSpot(any() & 0xFFFF0000u);
        return of;
    }
    [[nodiscard]] placements::GeneratorEntry makeGenerator() {
        placements::GeneratorEntry entry;
        entry.probability = number();
        entry.templateId = any();
        entry.initCreate = pick(9) - 1;
        entry.maxCreate = pick(9) - 1;
        entry.whenCreate = any();
        entry.whereCreate = any();
        maybe(entry.palette, any());
        maybe(entry.shade, number());
        maybe(entry.spot, makeSpot(any() & 0xFFFF0000u));
        return entry;
    }

    std::mt19937 random_;
};

} // namespace limen::test
