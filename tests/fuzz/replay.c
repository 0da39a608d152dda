/* SPDX-License-Identifier: MIT */
/* A fuzz target without its fuzzer: gives it no bytes, and each file of the folder that is named. */
#include "fuzz/fuzz.h"

#include <dirent.h>
#include <sys/wait.h>
#include <unistd.h>

static void replay_bytes(const char *path)
{
    FILE *file = fopen(path, "rb");
    FUZZ_CHECK(file && fseek(file, 0, SEEK_END) == 0);
    long size = ftell(file);
    FUZZ_CHECK(size >= 0);
    rewind(file);
    uint8_t *bytes = fuzz_block((size_t)size);
    FUZZ_CHECK(fread(bytes, 1, (size_t)size, file) == (size_t)size);
    fclose(file);
    LLVMFuzzerTestOneInput(bytes, (size_t)size);
    free(bytes);
}

/* In a process of its own, so that one that breaks the target is named, and the others are tried as well. */
static bool replay_file(const char *path)
{
    int status = -1;
    fflush(stdout);
    pid_t child = fork();
    FUZZ_CHECK(child >= 0);
    if (child == 0) {
        replay_bytes(path);
        exit(0);
    }
    if (waitpid(child, &status, 0) == child && status == 0)
        return true;
    printf("FAIL %s\n", path);
    return false;
}

int main(int argc, char **argv)
{
    const char *target = strrchr(argv[0], '/') ? strrchr(argv[0], '/') + 1 : argv[0];
    const uint8_t none = 0;
    char path[4096];
    unsigned good = 0, bad = 0;
    LLVMFuzzerTestOneInput(&none, 0);
    DIR *folder = argc == 2 ? opendir(argv[1]) : NULL;
    for (struct dirent *entry; folder && (entry = readdir(folder));) {
        if (entry->d_name[0] == '.')
            continue;
        FUZZ_CHECK(snprintf(path, sizeof path, "%s/%s", argv[1], entry->d_name) < (int)sizeof path);
        if (replay_file(path))
            good++;
        else
            bad++;
    }
    if (folder)
        closedir(folder);
    if (good && !bad)
        printf("ok fuzz: %s takes its %u inputs\n", target, good);
    return good && !bad ? 0 : 1;
}
