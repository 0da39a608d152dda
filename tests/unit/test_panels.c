/* SPDX-License-Identifier: MIT */
#include "panel_case.h"
#include "panels/changes.h"

#include <pthread.h>
#include <sched.h>
#include <stdatomic.h>

static const unsigned rotations[] = {0, 90, 180, 270};

/* An SSD0323 at quarter turns takes bands of even rows. */
static unsigned even_bands(unsigned rows)
{
    return case_grey() && set.panel.rotation % 180 && rows & 1 ? rows + 1 : rows;
}

static void picture_is_seen_as_drawn_in_every_rotation(void **state)
{
    (void)state;
    random_seed(1);
    for (unsigned g = 0; g < GLASSES; g++)
        for (unsigned r = 0; r < 4; r++)
            for (unsigned bands = 0; bands < 3; bands++) {
                case_prepare(&glasses[g], rotations[r]);
                case_random_picture();
                assert_int_equal(case_open(), 0);
                unsigned rows = even_bands(bands == 0 ? 1 : bands == 1 ? 13 : set.height);
                assert_int_equal(case_show(rows, bands == 1 ? 4 : 0), 0);
                case_no_faults();
                if (case_wrong(0, 0))
                    fail_msg("%s, rotation %u, bands of %u: %u pixels wrong", glasses[g].name, rotations[r], rows,
                             case_wrong(0, 0));
            }
}

static void full_picture_costs_one_window(void **state)
{
    (void)state;
    for (unsigned r = 0; r < 4; r++) {
        case_prepare(&glasses[0], rotations[r]);
        assert_int_equal(case_open(), 0);
        assert_int_equal(case_show(7, 0), 0);
        case_show(7, 0);
        assert_int_equal(set.panel.sent, 240 * 240 * 2 + 11);
        assert_int_equal(set.wires.model.windows, 2);
    }
}

static void options_suit_modules_that_differ(void **state)
{
    (void)state;
    random_seed(2);
    for (unsigned g = 0; g < GLASSES; g++)
        for (int way = 1; way < 4; way++) {
            struct panel *panel = case_prepare(&glasses[g], rotations[way]);
            panel->bgr = way & 1 && !case_grey();
            panel->invert = way >> 1;
            case_random_picture();
            assert_int_equal(case_open(), 0);
            assert_int_equal(case_show(even_bands(5), 0), 0);
            case_no_faults();
            assert_int_equal(case_wrong(panel->bgr, panel->invert), 0);
            assert_true(case_wrong(panel->bgr, !panel->invert) > 0);
        }
}

/* Runs of changed rows, as the bytes on the wire must be: a run goes on from band to band without a window. An SSD0323
 * turned by software takes a window a row, at quarter turns one for two rows of which either changed. */
static uint32_t bytes_of_changes(const uint8_t *changed)
{
    uint32_t bytes = 0, window = set.glass->kind <= MODEL_ILI9341 ? 11 : case_grey() ? 6 : 7;
    int turned = case_grey() && set.panel.rotation, two = turned && set.panel.rotation % 180;
    for (unsigned y = 0; y < set.height; y += two ? 2 : 1) {
        int now = changed[y] || (two && changed[y + 1]);
        if (now)
            bytes += case_row_bytes() * (two ? 2 : 1) + (turned || y == 0 || !changed[y - 1] ? window : 0);
    }
    return bytes;
}

static void show_changes(uint32_t memory_size)
{
    static uint8_t changed[320];
    for (unsigned g = 0; g < GLASSES; g++)
        for (unsigned r = 0; r < 4; r++) {
            struct panel *panel = case_prepare(&glasses[g], rotations[r]);
            panel->memory = set.memory;
            panel->memory_size = memory_size ? memory_size : set.height * 4u;
            case_random_picture();
            assert_int_equal(case_open(), 0);
            assert_int_equal(case_show(even_bands(8), 0), 0);
            for (int frame = 0; frame < 6; frame++) {
                memset(changed, 0, sizeof changed);
                for (unsigned y = 0; y < set.height; y++)
                    /* none, few, whole stretches, one pixel of a row */
                    if (frame && random_between(0, 9) < (frame == 3 ? 9 : 1) * (y > 20 || frame & 1)) {
                        changed[y] = 1;
                        if (frame == 2)
                            set.picture[y * set.width + (unsigned)random_between(0, set.width - 1)] ^= 1;
                        else
                            case_random_row(y);
                    }
                assert_int_equal(case_show(even_bands(frame & 1 ? 8 : 11), 0), 0);
                case_no_faults();
                assert_int_equal(case_wrong(0, 0), 0);
                assert_int_equal(panel->sent, bytes_of_changes(changed));
            }
        }
}

static void changed_rows_alone_are_sent_by_comparing(void **state)
{
    (void)state;
    random_seed(3);
    show_changes(sizeof set.memory);
}

static void changed_rows_alone_are_sent_by_checksums(void **state)
{
    (void)state;
    random_seed(4);
    show_changes(0);
}

static void near_changes_are_sent_together(void **state)
{
    (void)state;
    random_seed(5);
    /* Rows of 62 bytes; 130 pay for two unchanged ones, not for three. */
    struct panel *panel = case_prepare(&glasses[7], 0);
    panel->memory = set.memory;
    panel->memory_size = sizeof set.memory;
    panel->window_cost = 130;
    case_random_picture();
    assert_int_equal(case_open(), 0);
    assert_int_equal(case_show(50, 0), 0);
    case_random_row(10), case_random_row(13), case_random_row(17);
    assert_int_equal(case_show(50, 0), 0);
    assert_int_equal(panel->sent, 2 * 7 + 5 * 62);
    assert_int_equal(case_wrong(0, 0), 0);
    /* Over the edge of a band, whose own rows alone can be sent again. */
    case_random_row(9), case_random_row(12);
    assert_int_equal(case_show(10, 0), 0);
    assert_int_equal(panel->sent, 7 + 4 * 62);
    assert_int_equal(case_wrong(0, 0), 0);
}

static void repaint_sends_everything_once(void **state)
{
    (void)state;
    random_seed(6);
    struct panel *panel = case_prepare(&glasses[5], 90);
    panel->memory = set.memory;
    panel->memory_size = 128 * 4;
    case_random_picture();
    assert_int_equal(case_open(), 0);
    assert_int_equal(case_show(16, 0), 0);
    assert_int_equal(case_show(16, 0), 0);
    assert_int_equal(panel->sent, 0);
    panel_repaint(panel);
    memset(set.wires.model.memory, 0, sizeof set.wires.model.memory);
    assert_int_equal(case_show(16, 0), 0);
    assert_int_equal(panel->sent, 128 * 256 + 7);
    assert_int_equal(case_wrong(0, 0), 0);
    assert_int_equal(case_show(16, 0), 0);
    assert_int_equal(panel->sent, 0);
}

static atomic_uint begun, whole, ending;

/* What a second CPU does with a display. */
static void *begin_pictures(void *argument)
{
    struct panel *panel = argument;
    while (!ending) {
        assert_int_equal(panel_display.frame_begin(&panel->display, 0, 0), 0);
        whole += panel->all;
        begun++;
    }
    return NULL;
}

/* Asked for anywhere in a picture's beginning, it is that picture or the next one, and one alone. */
static void repaint_is_not_lost_to_a_second_cpu(void **state)
{
    (void)state;
    pthread_t second;
    struct panel *panel = case_prepare(&glasses[5], 0);
    panel->bus->ops = &wires_bare;
    assert_int_equal(case_open(), 0);
    assert_int_equal(panel_display.frame_begin(&panel->display, 0, 0), 0);
    begun = whole = ending = 0;
    assert_int_equal(pthread_create(&second, NULL, begin_pictures, panel), 0);
    for (unsigned i = 0; i < 4000; i++) {
        panel_repaint(panel);
        atomic_thread_fence(memory_order_seq_cst);
        unsigned before = begun;
        while (begun - before < 2) /* the first may have been under way */
            sched_yield();
        if (whole != i + 1) {
            print_message("after %u repaints %u pictures were whole\n", i + 1, (unsigned)whole);
            break;
        }
    }
    ending = 1;
    pthread_join(second, NULL);
    assert_int_equal(whole, 4000);
}

static void panel_that_lost_its_registers_is_mended(void **state)
{
    (void)state;
    random_seed(7);
    for (unsigned g = 0; g < GLASSES; g++) {
        struct panel *panel = case_prepare(&glasses[g], 180);
        panel->memory = set.memory;
        panel->memory_size = sizeof set.memory;
        panel->refresh = 3;
        case_random_picture();
        assert_int_equal(case_open(), 0);
        assert_int_equal(case_show(10, 0), 0);
        model_reset(&set.wires.model);
        memset(set.wires.model.memory, 0, sizeof set.wires.model.memory);
        set.wires.model.ready = 0;
        /* Seen as wrong until the third picture is done; the fourth sends all. */
        for (int frame = 0; frame < 2; frame++) {
            assert_int_equal(case_show(10, 0), 0);
            assert_true(case_wrong(0, 0) > 0);
        }
        uint64_t before = set.wires.model.now;
        assert_int_equal(case_show(10, 0), 0);
        case_no_faults();
        assert_int_equal(case_wrong(0, 0), 0);
        assert_true(set.wires.model.now - before <= 5000); /* us: not a picture is missed at 60 a second */
    }
}

static void panel_is_dark_before_the_first_picture_and_after_the_last(void **state)
{
    (void)state;
    for (unsigned g = 0; g < GLASSES; g++) {
        case_prepare(&glasses[g], 0);
        assert_int_equal(case_open(), 0);
        assert_false(set.wires.model.on);
        assert_int_equal(set.wires.model.backlight, 0);
        assert_int_equal(case_show(10, 0), 0);
        assert_true(set.wires.model.on && !set.wires.model.asleep);
        assert_int_equal(set.wires.model.backlight, 255);
        assert_int_equal(panel_display.close(&set.panel.display, 1), 0);
        assert_false(set.wires.model.on);
        assert_int_equal(set.wires.model.backlight, 0);
        case_no_faults();
    }
}

static void wires_that_a_board_lacks_are_not_needed(void **state)
{
    (void)state;
    random_seed(8);
    for (unsigned g = 0; g < GLASSES; g++) {
        case_prepare(&glasses[g], 0);
        set.wires.bus.ops = &wires_bare;
        case_random_picture();
        assert_int_equal(case_open(), 0);
        assert_int_equal(case_show(10, 0), 0);
        case_no_faults();
        assert_int_equal(case_wrong(0, 0), 0);
        assert_false(set.wires.model.tearing);
        assert_int_equal(panel_display.close(&set.panel.display, 0), 0);
    }
}

static void picture_waits_for_the_tearing_signal(void **state)
{
    (void)state;
    case_prepare(&glasses[0], 0);
    assert_int_equal(case_open(), 0);
    assert_true(set.wires.model.tearing);
    for (int frame = 1; frame <= 3; frame++) {
        case_show(16, 0);
        assert_int_equal(set.wires.tears, frame);
    }
}

static int open_as(uint16_t width, uint16_t height, enum hal_pixel_format format)
{
    return panel_display.open(&set.panel.display, width, height, format);
}

static void wrong_sizes_formats_and_options_are_refused(void **state)
{
    (void)state;
    struct panel *panel = case_prepare(&glasses[2], 90); /* 135x240 */
    assert_int_equal(open_as(135, 240, HAL_RGB565), HAL_E_ARGUMENT);
    assert_int_equal(open_as(240, 134, HAL_RGB565), HAL_E_ARGUMENT);
    assert_int_equal(open_as(0, 0, HAL_RGB565), HAL_E_ARGUMENT);
    assert_int_equal(open_as(240, 135, HAL_GREY4), HAL_E_ARGUMENT);
    assert_int_equal(open_as(240, 135, HAL_RGB888), HAL_E_ARGUMENT);
    panel->offset_x = 106; /* 106 + 135 is 241 */
    assert_int_equal(case_open(), HAL_E_ARGUMENT);
    panel->offset_x = 105;
    assert_int_equal(case_open(), 0);
    panel->offset_y = 81;
    assert_int_equal(case_open(), HAL_E_ARGUMENT);
    panel->offset_y = 80;
    panel->rotation = 45;
    assert_int_equal(case_open(), HAL_E_ARGUMENT);
    panel->rotation = 360;
    assert_int_equal(open_as(135, 240, HAL_RGB565), HAL_E_ARGUMENT);

    panel = case_prepare(&glasses[8], 0);
    panel->bgr = 1;
    assert_int_equal(case_open(), HAL_E_ARGUMENT);
    panel->bgr = 0, panel->width = set.width = 126, panel->offset_x = 1;
    assert_int_equal(case_open(), HAL_E_ARGUMENT);
    panel->offset_x = 2;
    assert_int_equal(case_open(), 0);
    assert_int_equal(set.wires.model.faults, 0);
}

static void rows_outside_the_picture_are_refused(void **state)
{
    (void)state;
    struct panel *panel = case_prepare(&glasses[9], 90); /* rows in twos */
    assert_int_equal(case_open(), 0);
    panel_display.frame_begin(&panel->display, 0, 0);
    assert_int_equal(panel_display.flush(&panel->display, set.band, 60, 6, 15), HAL_E_ARGUMENT);
    assert_int_equal(panel_display.flush(&panel->display, set.band, 0, 3, 15), HAL_E_ARGUMENT);
    assert_int_equal(panel_display.flush(&panel->display, set.band, 1, 2, 15), HAL_E_ARGUMENT);
    assert_int_equal(panel_display.flush(&panel->display, set.band, 60, 4, 15), 0);
    case_no_faults();
}

static void failure_of_the_bus_is_reported_wherever_it_comes(void **state)
{
    (void)state;
    for (unsigned g = 0; g < GLASSES; g += 3) {
        int error = HAL_E_IO, last = 0;
        for (; error; last++) {
            case_prepare(&glasses[g], 90);
            set.panel.refresh = 1;
            set.wires.fail_at = last;
            error = case_open();
            for (int frame = 0; frame < 2 && !error; frame++)
                error = case_show(40, 0);
            if (!error)
                error = panel_display.close(&set.panel.display, 1);
            assert_true(error == 0 || error == HAL_E_IO);
        }
        /* The first that was not reached was not made. */
        assert_int_equal(set.wires.calls, last - 1);
        assert_true(last > 20);
    }
}

static void bars_show_every_corner_and_colour(void **state)
{
    (void)state;
    static const uint16_t colours[] = {0xFFFF, 0xFFE0, 0x07FF, 0x07E0, 0xF81F, 0xF800, 0x001F, 0};
    for (unsigned g = 0; g < GLASSES; g++)
        for (unsigned r = 0; r < 4; r++) {
            case_prepare(&glasses[g], rotations[r]);
            assert_int_equal(case_open(), 0);
            assert_int_equal(panel_bars(&set.panel, set.band), 0);
            case_no_faults();
            unsigned w = set.width, h = set.height, white = case_grey() ? 15 : 0xFFFF;
            for (unsigned x = 0; x < w; x++)
                assert_true(case_seen(x, 0, 0, 0) == white && case_seen(x, h - 1, 0, 0) == white);
            for (unsigned y = 0; y < h; y++)
                assert_true(case_seen(0, y, 0, 0) == white && case_seen(w - 1, y, 0, 0) == white);
            for (unsigned bar = 0; bar < 8; bar++)
                assert_int_equal(case_seen((bar * 2 + 1) * w / 16, h / 2, 0, 0),
                                 case_grey() ? 14 - 2 * bar : colours[bar]);
            assert_true(case_seen(1, h - 4, 0, 0) < case_seen(w - 2, h - 4, 0, 0));
        }
}

static void checksum_tells_rows_that_differ_in_one_word(void **state)
{
    (void)state;
    uint8_t row[484];
    random_seed(9);
    for (unsigned i = 0; i < sizeof row; i++)
        row[i] = (uint8_t)random_bits();
    for (unsigned bytes = 1; bytes < 481; bytes++)
        for (int i = 0; i < 30; i++) {
            uint32_t sum = changes_sum(row, bytes), at = (uint32_t)random_between(0, (int)bytes - 1);
            row[at] ^= (uint8_t)(1 << random_between(0, 7));
            assert_true(changes_sum(row, bytes) != sum);
        }
}

static void checksum_is_the_same_at_any_alignment(void **state)
{
    (void)state;
    _Alignas(4) uint8_t rows[4][488];
    random_seed(10);
    for (unsigned i = 0; i < 480; i++)
        for (unsigned j = 0, byte = random_bits() & 255; j < 4; j++)
            rows[j][i + j] = (uint8_t)byte;
    for (unsigned bytes = 0; bytes < 480; bytes++)
        for (unsigned j = 1; j < 4; j++)
            assert_int_equal(changes_sum(rows[j] + j, bytes), changes_sum(rows[0], bytes));
}

/* What a plain sum, a sum of sums, or a product without rotation misses: the same bit of two pixels, spans that move
 * apart and two that trade places. */
static void checksum_tells_regular_changes(void **state)
{
    (void)state;
    static uint16_t row[240], other[240];
    for (unsigned bit = 0; bit < 16; bit++)
        for (unsigned i = 0; i < 240; i++)
            for (unsigned j = 0; j < i; j++) {
                memcpy(other, row, sizeof row);
                other[i] ^= (uint16_t)(1u << bit), other[j] ^= (uint16_t)(1u << bit);
                assert_true(changes_sum(other, 480) != changes_sum(row, 480));
            }
    for (unsigned i = 0; i < 110; i++) {
        memset(row, 0, sizeof row), memset(other, 0, sizeof other);
        for (unsigned j = 0; j < 9; j++) {
            row[i + 1 + j] = row[239 - i - 1 - j] = 0xF800;
            other[i + j] = other[239 - i - j] = 0xF800;
        }
        assert_true(changes_sum(other, 480) != changes_sum(row, 480));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(picture_is_seen_as_drawn_in_every_rotation),
        cmocka_unit_test(full_picture_costs_one_window),
        cmocka_unit_test(options_suit_modules_that_differ),
        cmocka_unit_test(changed_rows_alone_are_sent_by_comparing),
        cmocka_unit_test(changed_rows_alone_are_sent_by_checksums),
        cmocka_unit_test(near_changes_are_sent_together),
        cmocka_unit_test(repaint_sends_everything_once),
        cmocka_unit_test(repaint_is_not_lost_to_a_second_cpu),
        cmocka_unit_test(panel_that_lost_its_registers_is_mended),
        cmocka_unit_test(panel_is_dark_before_the_first_picture_and_after_the_last),
        cmocka_unit_test(wires_that_a_board_lacks_are_not_needed),
        cmocka_unit_test(picture_waits_for_the_tearing_signal),
        cmocka_unit_test(wrong_sizes_formats_and_options_are_refused),
        cmocka_unit_test(rows_outside_the_picture_are_refused),
        cmocka_unit_test(failure_of_the_bus_is_reported_wherever_it_comes),
        cmocka_unit_test(bars_show_every_corner_and_colour),
        cmocka_unit_test(checksum_tells_rows_that_differ_in_one_word),
        cmocka_unit_test(checksum_is_the_same_at_any_alignment),
        cmocka_unit_test(checksum_tells_regular_changes),
    };
    return cmocka_run_group_tests(tests, 0, 0);
}
