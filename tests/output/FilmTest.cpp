#include "output/Film.h"

#include "support/TemporaryDirectory.h"

#include <cstdlib>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

namespace limen::output {
namespace {

using testing::HasSubstr;

/// A program that takes the place of ffmpeg.
std::filesystem::path script(const test::TemporaryDirectory& directory, const std::string& body) {
    const std::filesystem::path path = directory / "ffmpeg";
    test::putText(path, "#!/bin/sh\n" + body);
    ::chmod(path.c_str(), 0755);
    return path;
}

Result<void> filmOf(const std::filesystem::path& ffmpeg, const std::filesystem::path& path, int frames,
                    const Picture& picture = Picture(64, 48, {200, 100, 50})) {
    Result<Film> film = Film::start(ffmpeg, path, picture.width, picture.height, 25.0);
    if (!film)
        return Failure(film.error());
    for (int i = 0; i < frames; ++i)
        if (Result<void> added = film->add(picture); !added)
            return added;
    return film->finish();
}

TEST(Film, theEndingSelectsTheFormat) {
    EXPECT_EQ(filmFormatOf("a.MP4").value(), FilmFormat::Mp4);
    EXPECT_EQ(filmFormatOf("a.webm").value(), FilmFormat::Webm);
    EXPECT_EQ(filmFormatOf("a/b.gif").value(), FilmFormat::Gif);
    EXPECT_EQ(filmFormatOf("a.webp").value(), FilmFormat::Webp);
    for (const char* name : {"a", "a.avi", "a.png"}) {
        const auto format = filmFormatOf(name);
        ASSERT_FALSE(format);
        EXPECT_THAT(format.error().what, HasSubstr(".webm"));
    }
}

TEST(Film, aMissingFfmpegIsNamedWithItsPackage) {
    const test::TemporaryDirectory directory;
    const auto missing = findFfmpeg(directory.path().string() + "::relative");
    ASSERT_FALSE(missing);
    EXPECT_THAT(missing.error().message(), HasSubstr("package ffmpeg"));
    const std::filesystem::path program = script(directory, "exit 0\n");
    EXPECT_EQ(findFfmpeg("/nowhere:" + directory.path().string()).value(), program);
}

// The substitute copies its input to its output, so that the film's bytes are known.
TEST(Film, allFramesReachFfmpegAndTheResultGetsItsName) {
    const test::TemporaryDirectory programs, films;
    const auto ffmpeg = script(programs, "for last; do :; done\ncat >\"$last\"\n");
    const Result<void> done = filmOf(ffmpeg, films / "film.gif", 3);
    ASSERT_TRUE(done) << done.error().message();
    EXPECT_EQ(std::filesystem::file_size(films / "film.gif"), 3u * 64 * 48 * 3);
    EXPECT_EQ(films.entryCount(), 1u);
}

TEST(Film, aFailureKeepsTheOldFileAndGivesFfmpegsReason) {
    const test::TemporaryDirectory programs, films;
    test::putText(films / "film.mp4", "old");
    const auto ffmpeg = script(
        programs, "for last; do :; done\necho half >\"$last\"\necho 'the encoder is missing' >&2\nexit 1\n");
    const Result<void> done = filmOf(ffmpeg, films / "film.mp4", 200);
    ASSERT_FALSE(done);
    EXPECT_THAT(done.error().message(), HasSubstr("the encoder is missing"));
    EXPECT_EQ(test::getText(films / "film.mp4"), "old");
    EXPECT_EQ(films.entryCount(), 1u);
}

TEST(Film, anUnfinishedFilmLeavesNothing) {
    const test::TemporaryDirectory programs, films;
    const auto ffmpeg = script(programs, "for last; do :; done\ncat >\"$last\"\n");
    {
        Result<Film> film = Film::start(ffmpeg, films / "film.webp", 8, 8, 10.0);
        ASSERT_TRUE(film) << film.error().message();
        ASSERT_TRUE(film->add(Picture(8, 8)));
        EXPECT_FALSE(film->add(Picture(9, 8))) << "another size";
    }
    EXPECT_EQ(films.entryCount(), 0u);
    EXPECT_FALSE(filmOf(ffmpeg, films / "film.webp", 0)) << "no frame";
    EXPECT_FALSE(filmOf(ffmpeg, films / "missing/film.webp", 1));
    EXPECT_FALSE(filmOf(programs / "nothing", films / "film.webp", 1));
    EXPECT_EQ(films.entryCount(), 0u);
}

// With the real program, where it is installed.
TEST(Film, ffmpegWritesEachFormat) {
    const char* path = std::getenv("PATH");
    const auto ffmpeg = findFfmpeg(path == nullptr ? "" : path);
    if (!ffmpeg)
        GTEST_SKIP() << ffmpeg.error().message();
    const test::TemporaryDirectory films;
    for (const auto& [name, offset, mark] :
         {std::tuple("a.mp4", 4, "ftyp"), std::tuple("a.webm", 0, "\x1A\x45"),
          std::tuple("a.gif", 0, "GIF89a"), std::tuple("a.webp", 8, "WEBP")}) {
        const Result<void> done = filmOf(*ffmpeg, films / name, 4, Picture(65, 47, {10, 90, 200}));
        ASSERT_TRUE(done) << name << ": " << done.error().message();
        EXPECT_EQ(test::getText(films / name)
                      .substr(static_cast<std::size_t>(offset), std::string_view(mark).size()),
                  mark);
    }
}

} // namespace
} // namespace limen::output
