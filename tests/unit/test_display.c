/* SPDX-License-Identifier: MIT */
#include "compare/image.h"
#include "host/displays.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

/* Every test works in a folder of its own. */
static int enter_folder(void **state)
{
    char *name = strdup("/tmp/glint-display-XXXXXX");
    *state = name;
    return mkdtemp(name) && chdir(name) == 0 ? 0 : -1;
}

static int leave_folder(void **state)
{
    char command[128];
    snprintf(command, sizeof command, "rm -rf '%s'", (const char *)*state);
    free(*state);
    return chdir("/") || system(command);
}

/* The number of files here, hidden ones too. */
static int files_here(void)
{
    DIR *folder = opendir(".");
    int count = -2; /* . and .. */
    while (readdir(folder))
        count++;
    closedir(folder);
    return count;
}

static size_t read_file(const char *path, uint8_t *bytes, size_t room)
{
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    size_t size = fread(bytes, 1, room, file);
    assert_true(size < room);
    fclose(file);
    return size;
}

static uint32_t get32(const uint8_t *bytes)
{
    return (uint32_t)bytes[0] << 24 | (uint32_t)bytes[1] << 16 | (uint32_t)bytes[2] << 8 | bytes[3];
}

/* Shows `frames` pictures, the rows in bands of `rows`; picture i starts `size` bytes after the one before. */
static void show(struct host_display *host, uint16_t width, uint16_t height, enum hal_pixel_format format,
                 const void *pixels, uint32_t stride, uint16_t rows, uint32_t frames, size_t size)
{
    const struct hal_display_ops *ops = host->display.ops;
    struct hal_display *display = &host->display;
    assert_int_equal(ops->open(display, width, height, format), 0);
    for (uint32_t i = 0; i < frames; i++) {
        const uint8_t *picture = (const uint8_t *)pixels + i * size;
        if (ops->frame_begin)
            assert_int_equal(ops->frame_begin(display, i, 40 + i), 0);
        for (uint16_t y = 0; y < height; y = (uint16_t)(y + rows))
            assert_int_equal(ops->flush(display, picture + (size_t)y * stride, y,
                                        (uint16_t)(rows < height - y ? rows : height - y), stride),
                             0);
        if (ops->frame_end)
            assert_int_equal(ops->frame_end(display), 0);
    }
    assert_int_equal(ops->close(display, 1), 0);
}

static void noise(uint8_t *bytes, size_t size, uint32_t seed)
{
    for (size_t i = 0; i < size; i++) {
        seed = seed * 1664525u + 1013904223u;
        bytes[i] = (uint8_t)(seed >> 24);
    }
}

static void png_gives_back_every_pixel(void **state)
{
    enum { W = 37, H = 23 };
    static uint8_t pixels[H * W * 3];
    (void)state;
    for (int smooth = 0; smooth < 2; smooth++) {
        struct host_display host = {.display.ops = &png_display, .path = "a.png", .frames = 1};
        struct image image;
        noise(pixels, sizeof pixels, 7);
        for (size_t i = 0; smooth && i < sizeof pixels; i++) /* each filter has its turn: ramps, and noise above */
            pixels[i] = (uint8_t)(i / (3 * W) % 3 == 0 ? i : i / (3 * W) % 3 == 1 ? 2 * i + i * i / 64 : i / 9);
        show(&host, W, H, HAL_RGB888, pixels, 3 * W, 5, 1, 0);
        assert_int_equal(image_read_png("a.png", &image), 0);
        assert_int_equal(image.width, W);
        assert_int_equal(image.height, H);
        assert_memory_equal(image.rgb, pixels, sizeof pixels);
        image_free(&image);
    }
    assert_int_equal(files_here(), 1);
}

/* More compressed bytes than one chunk holds. */
static void png_splits_large_pictures_into_chunks(void **state)
{
    enum { W = 200, H = 150 };
    static uint8_t pixels[H * W * 3];
    struct host_display host = {.display.ops = &png_display, .path = "a.png", .frames = 1};
    struct image image;
    (void)state;
    noise(pixels, sizeof pixels, 3);
    show(&host, W, H, HAL_RGB888, pixels, 3 * W, H, 1, 0);
    assert_int_equal(image_read_png("a.png", &image), 0);
    assert_memory_equal(image.rgb, pixels, sizeof pixels);
    image_free(&image);
}

static void rgb565_is_widened_by_repeating_its_upper_bits(void **state)
{
    static const uint16_t pixels[4] = {0xFFFF, 0x0000, 0x8410, 1 << 11 | 1 << 5 | 1};
    static const uint8_t shown[12] = {255, 255, 255, 0, 0, 0, 132, 130, 132, 8, 4, 8};
    struct host_display host = {.display.ops = &png_display, .path = "a.png", .frames = 1};
    struct image image;
    (void)state;
    show(&host, 4, 1, HAL_RGB565, pixels, 8, 1, 1, 0);
    assert_int_equal(image_read_png("a.png", &image), 0);
    assert_memory_equal(image.rgb, shown, sizeof shown);
    image_free(&image);
}

static void grey4_shows_the_high_nibble_first_times_17(void **state)
{
    static const uint8_t pixels[4] = {0x1F, 0xA0, 0x0C, 0x70};
    static const uint8_t shown[6] = {17, 255, 170, 0, 204, 119};
    struct host_display host = {.display.ops = &ppm_display, .path = "a.ppm"};
    uint8_t bytes[64];
    (void)state;
    show(&host, 3, 2, HAL_GREY4, pixels, 2, 1, 1, 0);
    size_t size = read_file("a.ppm", bytes, sizeof bytes);
    assert_int_equal(size, 11 + 6);
    assert_memory_equal(bytes, "P5\n3 2\n255\n", 11);
    assert_memory_equal(bytes + 11, shown, 6);
}

static void ppm_is_byte_exact(void **state)
{
    static const uint8_t pixels[16] = {1, 2, 3, 4, 5, 6, 0, 0, 7, 8, 9, 10, 11, 12, 0, 0}; /* rows padded to 8 */
    struct host_display host = {.display.ops = &ppm_display, .path = "a.ppm"};
    uint8_t bytes[64];
    (void)state;
    show(&host, 2, 2, HAL_RGB888, pixels, 8, 2, 1, 0);
    assert_int_equal(read_file("a.ppm", bytes, sizeof bytes), 23);
    assert_memory_equal(bytes, "P6\n2 2\n255\n\1\2\3\4\5\6\7\10\11\12\13\14", 23);
}

static void raw_is_the_bytes_of_the_bands(void **state)
{
    static const uint16_t pixels[6] = {0x1234, 0x5678, 0xFFFF, 0x9ABC, 0xDEF0, 0xFFFF}; /* one pixel of padding a row */
    struct host_display host = {.display.ops = &raw_display, .path = "a.raw"};
    uint8_t bytes[64];
    (void)state;
    show(&host, 2, 2, HAL_RGB565, pixels, 6, 1, 1, 0);
    assert_int_equal(read_file("a.raw", bytes, sizeof bytes), 8);
    assert_memory_equal(bytes, pixels, 4);
    assert_memory_equal(bytes + 4, pixels + 3, 4);
}

/* White, black, primaries: the numbers of BT.601 in 8 bits. */
static void y4m_holds_bt601_planes(void **state)
{
    static const uint8_t pixels[15] = {255, 255, 255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0, 255};
    static const uint8_t planes[15] = {235, 16, 81, 145, 41, 128, 128, 90, 54, 240, 128, 128, 240, 34, 110};
    static const char head[] = "YUV4MPEG2 W5 H1 F25:1 Ip A1:1 C444 XCOLORRANGE=LIMITED\nFRAME\n";
    struct host_display host = {.display.ops = &y4m_display, .path = "a.y4m", .rate = 25};
    uint8_t bytes[256];
    (void)state;
    show(&host, 5, 1, HAL_RGB888, pixels, 15, 1, 2, 0);
    assert_int_equal(read_file("a.y4m", bytes, sizeof bytes), sizeof head - 1 + 15 + 6 + 15);
    assert_memory_equal(bytes, head, sizeof head - 1);
    assert_memory_equal(bytes + sizeof head - 1, planes, 15);
    assert_memory_equal(bytes + sizeof head - 1 + 15, "FRAME\n", 6);
}

static void y4m_of_grey_is_mono(void **state)
{
    static const uint8_t pixels[3] = {0, 255, 128};
    static const char head[] = "YUV4MPEG2 W3 H1 F30:1 Ip A1:1 Cmono XCOLORRANGE=LIMITED\nFRAME\n\20\353\176";
    struct host_display host = {.display.ops = &y4m_display, .path = "a.y4m", .rate = 30};
    uint8_t bytes[256];
    (void)state;
    show(&host, 3, 1, HAL_GREY8, pixels, 3, 1, 1, 0);
    assert_int_equal(read_file("a.y4m", bytes, sizeof bytes), sizeof head - 1);
    assert_memory_equal(bytes, head, sizeof head - 1);
}

/* Finds the next chunk, checks its CRC, and moves *at behind it. */
static const uint8_t *next_chunk(const uint8_t *bytes, size_t size, size_t *at, const char *type, uint32_t *length)
{
    assert_true(*at + 12 <= size);
    const uint8_t *data = bytes + *at + 8;
    *length = get32(bytes + *at);
    assert_true(*length <= size - *at - 12);
    assert_memory_equal(data - 4, type, 4);
    assert_int_equal(get32(data + *length), crc32(0, data - 4, *length + 4));
    *at += 12 + *length;
    return data;
}

/* The compressed picture in one IDAT or fdAT, whose filters must all be "none" or undone by hand: one pixel a row, so
 * "sub" predicts 0 and "up" the row before. */
static void check_picture(const uint8_t *data, uint32_t length, const uint8_t *grey, size_t rows)
{
    uint8_t filtered[64];
    uLongf size = sizeof filtered;
    assert_int_equal(uncompress(filtered, &size, data, length), Z_OK);
    assert_int_equal(size, 2 * rows);
    for (size_t row = 0; row < rows; row++) {
        unsigned filter = filtered[2 * row], above = row ? grey[row - 1] : 0;
        unsigned guess = filter == 2 || filter == 4 ? above : filter == 3 ? above / 2 : 0;
        assert_int_equal((uint8_t)(filtered[2 * row + 1] + guess), grey[row]);
    }
}

static void animated_png_has_every_picture_in_order(void **state)
{
    enum { H = 9 };
    uint8_t pixels[3 * H], bytes[2048];
    struct host_display host = {.display.ops = &png_display, .path = "a.png", .frames = 3};
    size_t at = 8, size;
    uint32_t length, sequence = 0;
    (void)state;
    noise(pixels, sizeof pixels, 1);
    show(&host, 1, H, HAL_GREY8, pixels, 1, 4, 3, H);
    size = read_file("a.png", bytes, sizeof bytes);
    const uint8_t *header = next_chunk(bytes, size, &at, "IHDR", &length);
    assert_memory_equal(header, "\0\0\0\1\0\0\0\11\10\0\0\0\0", 13);
    assert_memory_equal(next_chunk(bytes, size, &at, "acTL", &length), "\0\0\0\3\0\0\0\0", 8);
    for (uint32_t i = 0; i < 3; i++) {
        const uint8_t *control = next_chunk(bytes, size, &at, "fcTL", &length);
        assert_int_equal(length, 26);
        assert_int_equal(get32(control), sequence++);
        assert_int_equal(get32(control + 4), 1);
        assert_int_equal(get32(control + 8), H);
        assert_int_equal(get32(control + 20), (40 + i) << 16 | 1000);
        const uint8_t *data = next_chunk(bytes, size, &at, i ? "fdAT" : "IDAT", &length);
        if (i)
            assert_int_equal(get32(data), sequence++);
        check_picture(data + (i ? 4 : 0), length - (i ? 4 : 0), pixels + i * H, H);
    }
    next_chunk(bytes, size, &at, "IEND", &length);
    assert_int_equal(at, size);
    struct image image; /* and one who knows nothing of animation sees the first */
    assert_int_equal(image_read_png("a.png", &image), 0);
    for (size_t i = 0; i < H; i++)
        assert_int_equal(image.rgb[3 * i], pixels[i]);
    image_free(&image);
}

static void an_animated_png_that_lacks_pictures_is_not_kept(void **state)
{
    static const uint8_t pixel = 9;
    struct host_display host = {.display.ops = &png_display, .path = "a.png", .frames = 2};
    struct hal_display *display = &host.display;
    (void)state;
    assert_int_equal(png_display.open(display, 1, 1, HAL_GREY8), 0);
    assert_int_equal(png_display.frame_begin(display, 0, 40), 0);
    assert_int_equal(png_display.flush(display, &pixel, 0, 1, 1), 0);
    assert_int_equal(png_display.frame_end(display), 0);
    assert_int_equal(png_display.close(display, 1), HAL_E_ARGUMENT);
    assert_int_equal(files_here(), 0);
}

static void a_folder_receives_numbered_pictures(void **state)
{
    static const uint8_t pixels[2] = {10, 20};
    struct host_display host = {.display.ops = &folder_display, .path = "out/"};
    struct image image;
    (void)state;
    show(&host, 1, 1, HAL_GREY8, pixels, 1, 1, 2, 1);
    assert_int_equal(image_read_png("out/frame-0001.png", &image), 0);
    assert_int_equal(image.rgb[0], 20);
    image_free(&image);
    assert_int_equal(chdir("out"), 0);
    assert_int_equal(files_here(), 2);
}

static void what_is_discarded_leaves_nothing(void **state)
{
    static const struct hal_display_ops *const all[] = {&raw_display, &ppm_display, &png_display, &y4m_display,
                                                        &folder_display};
    static const uint8_t pixels[2] = {1, 2};
    (void)state;
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        struct host_display host = {.display.ops = all[i], .path = "out", .frames = 2, .rate = 1};
        assert_int_equal(all[i]->open(&host.display, 1, 2, HAL_GREY8), 0);
        for (uint32_t frame = 0; frame < 2; frame++) { /* the second stays unfinished */
            if (all[i]->frame_begin)
                assert_int_equal(all[i]->frame_begin(&host.display, frame, 1), 0);
            assert_int_equal(all[i]->flush(&host.display, pixels, 0, (uint16_t)(2 - frame), 1), 0);
            if (frame == 0 && all[i]->frame_end)
                assert_int_equal(all[i]->frame_end(&host.display), 0);
        }
        all[i]->close(&host.display, 0);
        assert_int_equal(files_here(), 0);
    }
}

/* Pictures of an older run, or a folder in the place of one, are none of a failed run's business. */
static void a_failed_run_leaves_older_pictures_in_their_folder(void **state)
{
    static const uint8_t older[2] = {10, 20}, newer[2] = {30, 40};
    struct host_display host = {.display.ops = &folder_display, .path = "out"};
    struct hal_display *display = &host.display;
    struct image image;
    (void)state;
    show(&host, 1, 1, HAL_GREY8, older, 1, 1, 2, 1);
    for (int keep = 0; keep < 2; keep++) { /* discarded; then kept, but there is no room for the second */
        if (keep)
            assert_true(unlink("out/frame-0001.png") == 0 && mkdir("out/frame-0001.png", 0777) == 0);
        assert_int_equal(folder_display.open(display, 1, 1, HAL_GREY8), 0);
        for (uint32_t i = 0; i < 2; i++) {
            assert_int_equal(folder_display.frame_begin(display, i, 1), 0);
            assert_int_equal(folder_display.flush(display, newer + i, 0, 1, 1), 0);
            assert_int_equal(folder_display.frame_end(display), 0);
        }
        assert_int_equal(image_read_png("out/frame-0000.png", &image), 0);
        assert_int_equal(image.rgb[0], 10);
        image_free(&image);
        assert_int_equal(folder_display.close(display, keep), keep ? HAL_E_IO : 0);
        assert_true(!keep || errno == EISDIR);
        assert_int_equal(image_read_png("out/frame-0000.png", &image), 0);
        assert_int_equal(image.rgb[0], 10);
        image_free(&image);
        assert_int_equal(chdir("out"), 0);
        assert_int_equal(files_here(), 2);
        assert_int_equal(chdir(".."), 0);
    }
}

static void a_full_device_is_reported(void **state)
{
    static const uint8_t pixel = 1;
    struct host_display host = {.display.ops = &ppm_display, .path = "/dev/full"};
    (void)state;
    assert_int_equal(ppm_display.open(&host.display, 1, 1, HAL_GREY8), 0);
    assert_int_equal(ppm_display.frame_begin(&host.display, 0, 0), 0);
    assert_int_equal(ppm_display.flush(&host.display, &pixel, 0, 1, 1), 0);
    errno = 0;
    assert_int_equal(ppm_display.close(&host.display, 1), HAL_E_IO);
    assert_int_equal(errno, ENOSPC);
    assert_int_equal(access("/dev/full", F_OK), 0);
}

static void a_directory_is_not_a_file(void **state)
{
    struct host_display host = {.display.ops = &png_display, .path = ".", .frames = 1};
    (void)state;
    assert_int_equal(png_display.open(&host.display, 1, 1, HAL_GREY8), HAL_E_IO);
    assert_int_equal(errno, EISDIR);
}

/* The old file stays readable until the new one is whole, and keeps its mode; a link keeps pointing. */
static void a_file_is_replaced_at_once(void **state)
{
    struct sink sink;
    struct stat now;
    uint8_t bytes[16];
    (void)state;
    assert_int_equal(sink_open(&sink, "a"), 0);
    assert_int_equal(sink_write(&sink, "old", 3), 0);
    assert_int_equal(sink_close(&sink, 1), 0);
    assert_int_equal(chmod("a", 0640), 0);
    assert_int_equal(symlink("a", "link"), 0);
    assert_int_equal(sink_open(&sink, "link"), 0);
    assert_int_equal(sink_write(&sink, "newer", 5), 0);
    assert_int_equal(read_file("a", bytes, sizeof bytes), 3);
    assert_int_equal(sink_close(&sink, 1), 0);
    assert_int_equal(read_file("a", bytes, sizeof bytes), 5);
    assert_int_equal(lstat("link", &now), 0);
    assert_true(S_ISLNK(now.st_mode));
    assert_int_equal(stat("a", &now), 0);
    assert_int_equal(now.st_mode & 0777, 0640);
    assert_int_equal(files_here(), 2);
}

static void a_picture_without_size_is_refused(void **state)
{
    struct host_display host = {.display.ops = &raw_display, .path = "a.raw"};
    struct hal_display nothing = {&null_display};
    (void)state;
    assert_int_equal(raw_display.open(&host.display, 0, 1, HAL_GREY8), HAL_E_ARGUMENT);
    assert_int_equal(nothing.ops->open(&nothing, 1, 0, HAL_GREY8), HAL_E_ARGUMENT);
    assert_int_equal(files_here(), 0);
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, enter_folder, leave_folder)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(png_gives_back_every_pixel),
        TEST(png_splits_large_pictures_into_chunks),
        TEST(rgb565_is_widened_by_repeating_its_upper_bits),
        TEST(grey4_shows_the_high_nibble_first_times_17),
        TEST(ppm_is_byte_exact),
        TEST(raw_is_the_bytes_of_the_bands),
        TEST(y4m_holds_bt601_planes),
        TEST(y4m_of_grey_is_mono),
        TEST(animated_png_has_every_picture_in_order),
        TEST(an_animated_png_that_lacks_pictures_is_not_kept),
        TEST(a_folder_receives_numbered_pictures),
        TEST(what_is_discarded_leaves_nothing),
        TEST(a_failed_run_leaves_older_pictures_in_their_folder),
        TEST(a_full_device_is_reported),
        TEST(a_directory_is_not_a_file),
        TEST(a_file_is_replaced_at_once),
        TEST(a_picture_without_size_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
