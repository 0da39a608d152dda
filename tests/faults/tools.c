/* SPDX-License-Identifier: MIT */
/*
 * glint and glint-view, whole, each in a process of its own, with every call of wraps.h failing in turn, then pairs of
 * them. What a run comes to is one of two: as if nothing had been, or exit code 3, one message, and no file that was
 * not there before, those that were being as they were. Under clang's sanitizers nothing is leaked or freed twice.
 *
 *   tools PART PARTS [pairs]    runs every PARTS-th case from PART on
 *   tools NAME [CALL CALL]      runs one, or only those calls of it
 */
#define _GNU_SOURCE
#include "faults/pairs.h"
#include "faults/place.h"
#include "faults/wraps.h"

#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>

int glint_main(int argc, char **argv);
int view_main(int argc, char **argv);

enum { MOST_WORDS = 24, MOST_TOLD = 4096, HANG_SECONDS = 600, DIED = 126, MOST_FAILURES = 20 };

struct tool {
    const char *name, *line; /* words parted by spaces; the first: which program */
    unsigned from, step;     /* from this call on, which other cases have not tried, each so-many-th is made to fail */
    const char *old;         /* a file that is there before and is to be written anew, or null */
    const char *may_say;     /* with exit code 1, or null */
    bool keeps;              /* files that were complete before the fault stay, or what it was asked to keep */
    bool times;              /* it prints how long it took */
};

#define SMALL       " ../tiny.json --size 24x16 "
#define READ        335u /* calls, to read that scene */
#define NOT_A_MODEL "../model.obj: too large: the importer has not enough memory for it\n"

/* What the runs read is beside their folder. */
static const struct tool tools[] = {
    {"a picture", "glint render" SMALL "-o a.png", 1, 1, "a.png", NULL, 0, 0},
    {"an animation", "glint render" SMALL "--frames 2 -o a.apng", READ, 1, NULL, NULL, 0, 0},
    {"numbered pictures", "glint render" SMALL "--frames 2 -o out/", READ, 1, NULL, NULL, 0, 0},
    {"numbered pictures over others", "glint render" SMALL "--frames 2 -o out/", READ, 1, "out/frame-0000.png", NULL, 0,
     0},
    {"a film", "glint render" SMALL "--frames 2 -o a.y4m", READ, 1, NULL, NULL, 0, 0},
    {"rows as PPM", "glint render" SMALL "-o a.ppm", READ, 1, NULL, NULL, 0, 0},
    {"bytes to standard output", "glint render" SMALL "-o - --output-format raw", READ, 1, NULL, NULL, 0, 0},
    {"a stream", "glint render" SMALL "--format rgb565 --frames 3 --stream a.stream", READ, 1, NULL, NULL, 0, 0},
    {"hashes", "glint render" SMALL "--frames 2 --hash", READ, 1, NULL, NULL, 0, 0},
    {"expected hashes", "glint render" SMALL "--frames 2 --expect ../hashes", READ, 1, NULL, NULL, 0, 0},
    {"a textured scene", "glint render ../picture.json --size 24x16 -o a.png", 1, 1, NULL, NULL, 0, 0},
    {"a model", "glint render ../model.obj --size 24x16 -o a.png", 1, 1, NULL, NOT_A_MODEL, 0, 0},
    {"a scene for flash", "glint pack ../tiny.json -o a.c", READ, 1, "a.c", NULL, 0, 0},
    {"a packed scene", "glint pack ../tiny.json -o a.glt", READ, 1, NULL, NULL, 0, 0},
    {"a packed scene again", "glint render ../tiny.glt --size 24x16 -o a.png", 1, 1, NULL, NULL, 0, 0},
    {"the truth", "glint reference" SMALL "-o a.png", READ, 1, "a.png", NULL, 0, 0},
    {"a difference", "glint compare ../a.png ../b.png --diff d.png", 1, 1, "d.png", NULL, 0, 0},
    {"what is in a model", "glint info ../model.obj", 1, 3, NULL, NOT_A_MODEL, 0, 0},
    {"the methods", "glint methods", 1, 1, NULL, NULL, 0, 0},
    {"a demo", "glint demo ../tiny.json out --frames 1", READ, 1, NULL, NULL, 1, 1},
    {"a report", "glint report ../tiny.json --costs ../costs --flash ../flash --methods gouraud,x -o out", 1, 97, NULL,
     NULL, 1, 0},
    {"a stream shown", "glint-view file:../a.stream --headless --trace --names", 1, 1, NULL, NULL, 0, 0},
    {"a stream kept", "glint-view file:../a.stream --save b.stream --frames 2", 1, 1, "b.stream", NULL, 1, 0},
    {"a stream's pictures", "glint-view file:../a.stream --dump out", 1, 1, NULL, NULL, 1, 0},
    {"a stream recorded", "glint-view file:../a.stream --headless --record a.png", 1, 1, "a.png", NULL, 1, 0},
    {"a stream as a film", "glint-view file:../a.stream --headless --record a.y4m", 1, 1, NULL, NULL, 1, 0},
};
enum { TOOLS = sizeof tools / sizeof *tools };

struct outcome {
    int status;
    char out[PLACE_TEXT], told[MOST_TOLD];
    struct place_text before, left;
};

static struct seam *seam; /* shared with the processes under test */
static char root[] = "/tmp/glint-faults-XXXXXX";
static FILE *streams[2];

static void read_back(FILE *file, char *text, size_t size)
{
    rewind(file);
    text[fread(text, 1, size - 1, file)] = 0;
}

/* The program itself: does not return. */
static void become(const struct tool *tool, bool halves)
{
    char line[512], *words[MOST_WORDS + 1];
    int count = 0;
    snprintf(line, sizeof line, "%s", tool->line);
    for (char *word = strtok(line, " "); word && count < MOST_WORDS; word = strtok(NULL, " "))
        words[count++] = word;
    words[count] = NULL;
    if (dup2(fileno(streams[0]), STDOUT_FILENO) < 0 || dup2(fileno(streams[1]), STDERR_FILENO) < 0)
        place_fail("dup2");
    alarm(HANG_SECONDS);
    wraps_begin(seam, halves);
    exit(strcmp(words[0], "glint") == 0 ? glint_main(count, words) : view_main(count, words));
}

static void run(const struct tool *tool, bool halves, struct outcome *o)
{
    place_clear(".");
    if (tool->old)
        place_write(tool->old, "old\n");
    place_look(".", &o->before);
    for (int i = 0; i < 2; i++) {
        rewind(streams[i]);
        if (ftruncate(fileno(streams[i]), 0) != 0)
            place_fail("ftruncate");
    }
    seam->calls = 0;
    fflush(NULL);
    pid_t child = fork();
    if (child == 0)
        become(tool, halves);
    if (child < 0 || waitpid(child, &o->status, 0) != child)
        place_fail("fork");
    while (wait(NULL) > 0) { /* an importer that outlives its reader would write and count in the next run */
    }
    read_back(streams[0], o->out, sizeof o->out);
    read_back(streams[1], o->told, sizeof o->told);
    place_look(".", &o->left);
}

static unsigned lines(const char *text)
{
    unsigned count = 0;
    for (; *text; text++)
        count += *text == '\n';
    return count;
}

/* What a run that said what failed may leave. */
static bool may_leave(const struct tool *tool, const struct outcome *good, const struct outcome *o)
{
    const bool all = strcmp(o->left.text, good->left.text) == 0;
    if (strcmp(o->left.text, o->before.text) == 0 || (all && strncmp(o->told, "standard output: ", 17) == 0))
        return true;
    return tool->keeps && place_is_part(&o->left, &good->left);
}

/* Null, or what is wrong. */
static const char *judge(const struct tool *tool, const struct outcome *good, const struct outcome *o)
{
    const char *last = o->told + strlen(o->told) - (tool->may_say ? strlen(tool->may_say) : 0);
    if (WIFSIGNALED(o->status))
        return WTERMSIG(o->status) == SIGALRM ? "it hangs" : "it crashes";
    if (WEXITSTATUS(o->status) == DIED)
        return "a sanitizer stops it";
    if (WEXITSTATUS(o->status) == 0) {
        if (strcmp(o->told, good->told) != 0)
            return "it says so, and goes on";
        if (!tool->times && strcmp(o->out, good->out) != 0)
            return "it prints something else";
        return strcmp(o->left.text, good->left.text) == 0 ? NULL : "it writes something else";
    }
    const bool refused =
        WEXITSTATUS(o->status) == 1 && tool->may_say && last >= o->told && strcmp(last, tool->may_say) == 0;
    if (WEXITSTATUS(o->status) != 3 && !refused)
        return "another exit code";
    const unsigned most = seam->then_at || seam->fails_on ? 2 : 1; /* of two files, say */
    if (!refused && (lines(o->told) < 1 || lines(o->told) > most || o->told[strlen(o->told) - 1] != '\n'))
        return "not one message";
    return may_leave(tool, good, o) ? NULL : "something is left, or gone";
}

/* Whether all was well; prints what was not. */
static bool try(const struct tool *tool, const struct outcome *good, bool halves)
{
    static struct outcome o;
    run(tool, halves, &o);
    const char *wrong = judge(tool, good, &o);
    if (wrong)
        printf("FAIL faults: %s, call %d and %d of %d fail (%s)%s: %s: status %x, told '%.*s', left '%s'\n", tool->name,
               seam->fails_at, seam->then_at, seam->calls, strerror(seam->reason), halves ? ", halves" : "", wrong,
               (unsigned)o.status, WIFEXITED(o.status) && WEXITSTATUS(o.status) == DIED ? MOST_TOLD : 200, o.told,
               o.left.text);
    return !wrong;
}

static void fail_next(int first, int second, int reason)
{
    *seam = (struct seam){.fails_at = first, .then_at = second, .reason = reason};
}

/* Each call, with a reason after another; halves of what is read, too. */
static unsigned singles(const struct tool *tool, const struct outcome *good, int calls, unsigned *failures)
{
    static const int reasons[] = {EIO, ENOSPC, EINTR, EAGAIN, ENOMEM};
    const char *sparse = getenv("FAULTS_SPARSE"); /* of the calls only each so-many-th */
    const int step = (int)tool->step * (sparse ? atoi(sparse) : 1);
    unsigned runs = 1;
    fail_next(0, 0, EIO);
    *failures += !try(tool, good, true);
    for (int k = (int)tool->from; k <= calls && *failures < MOST_FAILURES; k += step, runs++) {
        fail_next(k, 0, reasons[runs % 5]);
        *failures += !try(tool, good, runs % 7 == 0);
    }
    return runs;
}

/* Of the pairs of calls so many; and from a call on all, the least likely and the most usual. */
static unsigned pairs(const struct tool *tool, const struct outcome *good, int calls, unsigned *failures)
{
    struct pairs all = pairs_of(calls, pairs_most(600));
    unsigned runs = 0;
    for (; *failures < MOST_FAILURES && pairs_next(&all, seam); runs++)
        *failures += !try(tool, good, false);
    for (int k = 1; k <= calls && *failures < MOST_FAILURES; k += calls / 60 + 1, runs++) {
        fail_next(k, 0, EIO);
        seam->fails_on = 1;
        *failures += !try(tool, good, false);
    }
    return runs;
}

static bool test_calls(const struct tool *tool, int first, int second)
{
    static struct outcome good;
    fail_next(0, 0, 0);
    run(tool, false, &good);
    fail_next(first, second, EIO);
    return try(tool, &good, false);
}

static bool test(const struct tool *tool, bool paired)
{
    static struct outcome good;
    unsigned failures = 0, runs = 0;
    fail_next(0, 0, 0);
    run(tool, false, &good);
    int calls = seam->calls;
    if (good.status != 0 || calls == 0) {
        printf("FAIL faults: %s: status %x before any fault: %s\n", tool->name, (unsigned)good.status, good.told);
        return false;
    }
    runs = paired ? pairs(tool, &good, calls, &failures) : singles(tool, &good, calls, &failures);
    if (!failures)
        printf("ok faults: %s: %u runs with %s failing of %d calls\n", tool->name, runs,
               paired ? "two, or all from one on," : "one", calls);
    fflush(stdout);
    return !failures;
}

/* What the runs read, from the project's own scenes, by the tools themselves. */
static void prepare(const char *scenes)
{
    static const char *const lines_[] = {
        "glint render" SMALL "-o ../a.png",
        "glint render" SMALL "--method flat -o ../b.png",
        "glint render" SMALL "--format rgb565 --frames 3 --stream ../a.stream",
        "glint pack ../tiny.json -o ../tiny.glt",
    };
    static struct outcome o;
    char command[1024];
    snprintf(command, sizeof command, "%s/tiny.json", scenes);
    if (symlink(command, "../tiny.json") != 0)
        place_fail(command);
    place_write("../model.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    place_write("../picture.json",
                "{\"camera\": {\"type\": \"perspective\", \"position\": [0, 0, 3], \"look_at\": [0, 0, 0], \"fov\": "
                "40, \"near\": 1,"
                "\"far\": 9, \"size\": [24, 16]},"
                "\"lights\": [{\"type\": \"directional\", \"towards\": [0, 0, 1]}],"
                "\"textures\": {\"t\": {\"file\": \"a.png\"}}, \"materials\": {\"m\": {\"texture\": \"t\"}},"
                "\"meshes\": {\"p\": {\"shape\": \"plane\", \"size\": [2, 2], \"segments\": 1, \"material\": \"m\"}},"
                "\"objects\": [{\"mesh\": \"p\"}]}\n");
    place_write("../costs", "cpu,scene,method,width,height,format,instructions,picture\n"
                            "m3,tiny,gouraud,96,72,grey8,1,0a1\nm3,tiny,x,96,72,grey8,2,0a3\n"
                            "m0plus,tiny,gouraud,96,72,grey8,1,0a1\nm0plus,tiny,x,96,72,grey8,2,0a3\n");
    place_write("../flash", "cpu,method,bytes\nm3,gouraud,1\nm3,x,2\nm0plus,gouraud,1\nm0plus,x,2\n");
    fail_next(0, 0, 0);
    for (size_t i = 0; i < sizeof lines_ / sizeof *lines_; i++) {
        const struct tool tool = {.line = lines_[i]};
        run(&tool, false, &o);
        if (o.status != 0) {
            fprintf(stderr, "%s: %s", lines_[i], o.told);
            abort();
        }
    }
    const struct tool tool = {.line = "glint render" SMALL "--frames 2 --hash"};
    run(&tool, false, &o);
    place_write("../hashes", o.out);
}

int main(int argc, char **argv)
{
    char scenes[PLACE_NAME];
    const bool named = argc > 1 && (argv[1][0] < '0' || argv[1][0] > '9');
    int part = argc > 2 && !named ? atoi(argv[1]) : 0, parts = argc > 2 && !named ? atoi(argv[2]) : 1;
    bool good = true;
    umask(022);
    if (prctl(PR_SET_CHILD_SUBREAPER, 1) != 0)
        place_fail("prctl");
    seam = mmap(NULL, sizeof *seam, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    for (int i = 0; i < 2; i++)
        if (!(streams[i] = tmpfile()))
            place_fail("tmpfile");
    if (seam == MAP_FAILED || !realpath("tests/scenes", scenes) || !mkdtemp(root) || chdir(root) != 0 ||
        mkdir("work", 0777) != 0 || chdir("work") != 0)
        place_fail(root);
    prepare(scenes);
    for (int i = part; i < TOOLS; i += parts)
        if (!named)
            good = test(&tools[i], argc > 3) && good;
        else if (strcmp(argv[1], tools[i].name) == 0)
            good = argc > 3 ? test_calls(&tools[i], atoi(argv[2]), atoi(argv[3])) : test(&tools[i], false);
    if (chdir("/") != 0)
        place_fail("/");
    place_clear(root);
    rmdir(root);
    return good ? 0 : 1;
}
