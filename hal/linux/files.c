/* SPDX-License-Identifier: MIT */
#include "linux/files.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdint.h>
#include <string.h>
#include <sys/eventfd.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <unistd.h>

static long files_result(long result)
{
    return result < 0 ? -errno : result;
}

int files_open(const char *path, int waits)
{
    return (int)files_result(open(path, O_RDWR | O_CLOEXEC | (waits ? 0 : O_NONBLOCK)));
}

void files_close(int descriptor)
{
    close(descriptor);
}

long files_read(int descriptor, void *bytes, size_t size)
{
    return files_result(read(descriptor, bytes, size));
}

long files_write(int descriptor, const void *bytes, size_t size)
{
    return files_result(write(descriptor, bytes, size));
}

int files_put(const char *path, const char *text)
{
    int descriptor = open(path, O_WRONLY | O_CLOEXEC);
    if (descriptor < 0)
        return -errno;
    long count = files_write(descriptor, text, strlen(text));
    close(descriptor);
    return count < 0 ? (int)count : 0;
}

int files_get(const char *path, char *text, size_t size)
{
    int descriptor = open(path, O_RDONLY | O_CLOEXEC);
    if (descriptor < 0)
        return -errno;
    long count = files_read(descriptor, text, size - 1);
    close(descriptor);
    text[count > 0 ? count : 0] = 0;
    text[strcspn(text, "\n")] = 0;
    return count < 0 ? (int)count : 0;
}

int files_make_folder(const char *path)
{
    return (int)files_result(mkdir(path, 0755));
}

int files_remove_folder(const char *path)
{
    return (int)files_result(rmdir(path));
}

int files_link(const char *target, const char *path)
{
    return (int)files_result(symlink(target, path));
}

int files_unlink(const char *path)
{
    return (int)files_result(unlink(path));
}

int files_mount(const char *source, const char *path, const char *type)
{
    return (int)files_result(mount(source, path, type, 0, NULL));
}

int files_unmount(const char *path)
{
    return (int)files_result(umount(path));
}

int files_first(const char *folder, char *name, size_t size)
{
    DIR *entries = opendir(folder);
    if (!entries)
        return -errno;
    name[0] = 0;
    for (struct dirent *entry; (entry = readdir(entries)) != NULL;)
        if (entry->d_name[0] != '.' && strlen(entry->d_name) < size && (!name[0] || strcmp(entry->d_name, name) < 0))
            strcpy(name, entry->d_name);
    closedir(entries);
    return name[0] ? 0 : -ENOENT;
}

int files_event(void)
{
    return (int)files_result(eventfd(0, EFD_CLOEXEC));
}

int files_raise(int event)
{
    const uint64_t one = 1;
    return (int)files_result(write(event, &one, sizeof one));
}

int files_wait(int descriptor, int event)
{
    struct pollfd there[] = {{.fd = descriptor, .events = POLLIN}, {.fd = event, .events = POLLIN}};
    int result;
    do
        result = poll(there, 2, -1);
    while (result < 0 && errno == EINTR);
    return result < 0 ? -errno : !there[1].revents;
}
