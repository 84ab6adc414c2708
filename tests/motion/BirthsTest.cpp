#include "PlainStyle.h"

#include <gtest/gtest.h>

namespace limen::motion {
namespace {

using world::kNeverEnds;
using world::ParticleSource;
using world::ParticleStyle;

/// The rule, birth by birth: births are at least the interval apart, and at most `most` particles live at
/// once. For lives of one length.
std::vector<double> birthsOneByOne(const ParticleStyle& style, std::size_t count) {
    std::vector<double> births;
    for (std::size_t k = 0; k < count; ++k) {
        double at = 0.0;
        if (k >= style.initial)
            at = (births.empty() ? 0.0 : births.back()) + style.interval;
        if (k >= style.most)
            at = std::max(at, births[k - style.most] + style.longestLife());
        births.push_back(at);
    }
    return births;
}

TEST(Births, followTheRuleOneByOne) {
    for (const double interval : {0.1, 0.5, 0.75, 1.0, 4.0}) {
        for (const std::uint32_t initial : {0u, 1u, 3u, 4u}) {
            ParticleStyle style = plain();
            style.interval = interval;
            style.initial = initial;
            const std::vector<double> wanted = birthsOneByOne(style, 40);
            const Births births(style, started(style));
            for (std::size_t k = 0; k < wanted.size(); ++k)
                EXPECT_NEAR(births.of(static_cast<std::int64_t>(k)), wanted[k], 1e-9)
                    << "interval " << interval << ", initial " << initial << ", number " << k;
        }
    }
}

TEST(Births, thoseThatLiveAreAllThoseBornALifeAgo) {
    for (const double interval : {0.11, 0.76, 2.3}) {
        for (const bool everBurning : {false, true}) {
            ParticleStyle style = plain();
            style.interval = interval;
            style.initial = 2;
            ParticleSource source = started(style);
            source.isEverBurning = everBurning;
            const Births births(style, source);
            for (double seconds = everBurning ? -20.0317 : 0.0117; seconds < 30.0; seconds += 0.37) {
                const Births::Range living = births.livingAt(seconds);
                for (std::int64_t n = living.first - 3; n <= living.last + 3; ++n) {
                    if (!everBurning && n < 0)
                        continue;
                    const double age = seconds - births.of(n);
                    EXPECT_EQ(n >= living.first && n <= living.last, age >= 0.0 && age < style.lifespan)
                        << n << " at " << seconds;
                }
                EXPECT_LE(living.last - living.first + 1, 4) << "as many as may be";
            }
        }
    }
}

TEST(Births, takeAPlaceAsSoonAsItIsFree) {
    ParticleStyle style = plain();
    style.interval = 0.1; // ten lives for four places
    style.lifeSpread = 1.0;
    for (const bool everBurning : {false, true}) {
        ParticleSource source = started(style);
        source.isEverBurning = everBurning;
        const Births births(style, source);
        double least = 10.0, most = 0.0, sum = 0.0;
        for (std::int64_t n = 4; n < 404; ++n) {
            const double life = births.lifeOf(style, {source.seed, n});
            least = std::min(least, life);
            most = std::max(most, life);
            sum += life;
            EXPECT_NEAR(births.of(n) + life, births.of(n + 4), 1e-9) << "the next one follows at once";
        }
        EXPECT_GE(least, 2.0);
        EXPECT_LT(least, 2.3);
        EXPECT_LE(most, 4.0);
        EXPECT_GT(most, 3.7);
        EXPECT_NEAR(sum / 400.0, 3.0, 0.05);
        for (double seconds = 5.0; seconds < 60.0; seconds += 0.37) {
            int living = 0;
            eachLiving(style, source, 0, seconds,
                       [&](const ParticleKey&, double born, double age, double life) {
                           ++living;
                           EXPECT_NEAR(born + age, seconds, 1e-9);
                           EXPECT_LT(age, life);
                       });
            EXPECT_EQ(living, 4) << "at " << seconds;
        }
    }
}

TEST(Births, endWithTheTotalAndWithTime) {
    ParticleStyle style = plain();
    style.most = 100;
    style.total = 5;
    style.initial = 2;
    EXPECT_EQ(Births(style, started(style)).livingAt(2.9).last, 4);
    EXPECT_GT(Births(style, started(style)).livingAt(100.0).first, 4);
    style.total = 0;
    style.birthSeconds = 1.0;
    EXPECT_EQ(Births(style, started(style)).livingAt(2.9).last, 3) << "two at first, at 0.5 and at 1";
    style.birthSeconds = kNeverEnds;
    ParticleSource stopped = started(style);
    stopped.stop = 0.7;
    EXPECT_EQ(Births(style, stopped).livingAt(2.9).last, 2);
    EXPECT_EQ(Births(style, started(style)).livingAt(-0.1).last, -1) << "not before it starts";
}

TEST(Births, withoutAnIntervalAreTheFirstOnes) {
    ParticleStyle style = plain();
    style.interval = kNeverEnds;
    style.initial = 3;
    const Births births(style, started(style));
    EXPECT_EQ(births.livingAt(2.0).first, 0);
    EXPECT_EQ(births.livingAt(2.0).last, 2);
    EXPECT_GT(births.livingAt(5.0).first, births.livingAt(5.0).last);
}

TEST(Births, areFewEvenAtTheEndsOfWhatNumbersCanSay) {
    for (const double interval : {1e-12, 1e9}) {
        for (const double life : {1e-12, 2e9}) {
            for (const bool everBurning : {false, true}) {
                ParticleStyle style = plain();
                style.interval = interval;
                style.lifespan = life;
                style.initial = 2;
                ParticleSource source = started(style);
                source.isEverBurning = everBurning;
                for (const double seconds : {-1e12, -1.0, 0.0, 1e-300, 1e12}) {
                    const Births::Range living = Births(style, source).livingAt(seconds);
                    EXPECT_LE(living.last - living.first + 1, 5)
                        << interval << ", " << life << ", " << seconds;
                }
            }
        }
    }
}

TEST(SourceStarts, areThoseThatStillShowSomething) {
    ParticleStyle style = plain();
    style.total = 2; // at 0.5 and 1, dead at 4
    ParticleSource source = started(style);
    source.start = 10.0;
    source.period = 1.5;
    SourceStarts starts = startsAt(style, source, 20.0);
    EXPECT_EQ(starts.last, 6) << "the one that starts at 19";
    EXPECT_EQ(starts.first, 4) << "the one that started at 16 has its last until 20";
    EXPECT_EQ(startsAt(style, source, 9.0).last, -1) << "and it has been going round before, too";
    source.gone = 1.0;
    EXPECT_EQ(startsAt(style, source, 20.0).first, 6);
    source.period = 0.0;
    starts = startsAt(style, source, 9.0);
    EXPECT_GT(starts.first, starts.last);
    EXPECT_EQ(startsAt(style, source, 10.0).last, 0);
    source.period = 1e-30;
    source.gone = kNeverEnds;
    starts = startsAt(style, source, 20.0);
    EXPECT_LE(starts.last - starts.first, 64) << "no more than are worth showing";
}

TEST(SourceStarts, ofACallWithAPauseAreRandomPartsOfItApart) {
    ParticleStyle style = plain();
    style.total = 1;
    style.initial = 1;
    ParticleSource source = started(style);
    source.period = 2.5; // a script of 2 s that calls itself with a pause of 1 s
    source.jitter = 0.5;
    double least = 10.0, most = 0.0;
    for (std::int64_t start = 0; start < 300; ++start) {
        const double gap = startOf(source, start + 1) - startOf(source, start);
        least = std::min(least, gap);
        most = std::max(most, gap);
        const SourceStarts shown = startsAt(style, source, startOf(source, start) + 1e-9);
        EXPECT_LE(shown.first, start);
        EXPECT_GE(shown.last, start);
    }
    EXPECT_GE(least, 2.0);
    EXPECT_LT(least, 2.15);
    EXPECT_LE(most, 3.0);
    EXPECT_GT(most, 2.85);
    source.replacesItself = true;
    for (double seconds = 20.0; seconds < 60.0; seconds += 0.13) {
        int living = 0;
        const SourceStarts starts = startsAt(style, source, seconds);
        for (std::int64_t start = starts.first; start <= starts.last; ++start)
            eachLiving(style, source, start, seconds, [&](const auto&, double, double, double) { ++living; });
        EXPECT_EQ(living, 1) << "each start ends the one before, at " << seconds;
    }
}

} // namespace
} // namespace limen::motion
