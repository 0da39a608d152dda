/* SPDX-License-Identifier: MIT */
#include "compare/image.h"

#include <errno.h>
#include <png.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

struct image_reader {
    const char *path;
    FILE *file;
    png_structp png;
    png_infop info;
    png_bytep *rows;
    struct image *image;
    bool no_memory, unread; /* the picture is not to blame */
};

static png_voidp image_allocate(png_structp png, png_alloc_size_t size)
{
    struct image_reader *reader = png_get_mem_ptr(png);
    void *memory = malloc(size);
    reader->no_memory |= !memory;
    return memory;
}

static void image_release(png_structp png, png_voidp memory)
{
    (void)png;
    free(memory);
}

/* libpng's way out of any depth: it expects not to return. */
static void image_error(png_structp png, png_const_charp reason)
{
    const struct image_reader *reader = png_get_error_ptr(png);
    fprintf(stderr, "%s: %s\n", reader->path, reader->no_memory ? "out of memory" : reason);
    png_longjmp(png, 1);
}

static void image_warning(png_structp png, png_const_charp reason)
{
    (void)png, (void)reason; /* about data that does not change the picture */
}

static void image_read_bytes(png_structp png, png_bytep bytes, size_t size)
{
    struct image_reader *reader = png_get_io_ptr(png);
    if (fread(bytes, 1, size, reader->file) == size)
        return;
    reader->unread = ferror(reader->file);
    png_error(png, reader->unread ? strerror(errno) : "the file ends too early");
}

/* Everything that may end in image_error(). */
static void image_decode(struct image_reader *reader)
{
    png_structp png = reader->png;
    struct image *image = reader->image;
    png_set_read_fn(png, reader, image_read_bytes);
    png_set_user_limits(png, IMAGE_MAX_SIZE, IMAGE_MAX_SIZE);
    png_read_info(png, reader->info);
    png_set_expand(png);
    png_set_scale_16(png);
    png_set_gray_to_rgb(png);
    png_set_strip_alpha(png);
    png_set_interlace_handling(png);
    png_read_update_info(png, reader->info);
    image->width = png_get_image_width(png, reader->info);
    image->height = png_get_image_height(png, reader->info);
    size_t row = png_get_rowbytes(png, reader->info);
    if (row != 3u * image->width)
        png_error(png, "an unusual pixel format");
    image->rgb = malloc(row * image->height);
    reader->rows = malloc(image->height * sizeof *reader->rows);
    reader->no_memory = !image->rgb || !reader->rows;
    if (reader->no_memory)
        png_error(png, "out of memory");
    for (unsigned y = 0; y < image->height; y++)
        reader->rows[y] = image->rgb + y * row;
    png_read_image(png, reader->rows);
    png_read_end(png, NULL);
}

static bool image_read(struct image_reader *reader)
{
    if (setjmp(png_jmpbuf(reader->png)))
        return false;
    image_decode(reader);
    return true;
}

/* Closes the file, or null, which did not open. */
static int image_read_file(const char *path, FILE *file, struct image *image)
{
    struct image_reader reader = {.path = path, .file = file, .image = image};
    png_byte signature[8];
    *image = (struct image){0};
    size_t size = reader.file ? fread(signature, 1, sizeof signature, reader.file) : 0;
    if (!reader.file || ferror(reader.file)) { /* a directory opens, but does not read */
        fprintf(stderr, "%s: %s\n", path, strerror(errno));
        if (reader.file)
            fclose(reader.file);
        return 3;
    }
    bool done = false;
    if (size < sizeof signature || png_sig_cmp(signature, 0, sizeof signature)) {
        fprintf(stderr, "%s: not a PNG file\n", path);
    } else {
        reader.png = png_create_read_struct_2(PNG_LIBPNG_VER_STRING, &reader, image_error, image_warning, &reader,
                                              image_allocate, image_release);
        reader.info = reader.png ? png_create_info_struct(reader.png) : NULL;
        if (!reader.info) {
            reader.no_memory = true;
            fprintf(stderr, "%s: out of memory\n", path);
        } else {
            png_set_sig_bytes(reader.png, sizeof signature);
            done = image_read(&reader);
        }
        png_destroy_read_struct(&reader.png, &reader.info, NULL);
    }
    free(reader.rows);
    fclose(reader.file);
    if (!done)
        image_free(image);
    return done ? 0 : reader.no_memory || reader.unread ? 3 : 1;
}

int image_read_png(const char *path, struct image *image)
{
    errno = 0;
    return image_read_file(path, fopen(path, "rb"), image);
}

int image_read_png_bytes(const char *name, const uint8_t *bytes, size_t size, struct image *image)
{
    errno = 0;
    return image_read_file(name, fmemopen((void *)(uintptr_t)bytes, size, "rb"), image); /* "r": it writes nothing */
}

void image_free(struct image *image)
{
    free(image->rgb);
    *image = (struct image){0};
}
