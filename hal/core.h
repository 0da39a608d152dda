/* SPDX-License-Identifier: MIT */
/*
 * A second CPU that shares the first one's memory. It runs one function for as long as the program lasts; what the two
 * say to each other stands in memory, and locks keep them apart.
 */
#ifndef HAL_CORE_H
#define HAL_CORE_H

enum hal_lock { HAL_LOCK_TAKE, HAL_LOCK_SEND, HAL_LOCKS };

struct hal_core {
    /* Has the second CPU call job(argument), which does not return. Called once. */
    void (*start)(void (*job)(void *), void *argument);
    /* 1 and the lock is the caller's; 0 if another has it. What its last holder wrote is seen. Never waits. */
    int (*claim)(enum hal_lock);
    void (*release)(enum hal_lock);
    /* Sleeps until notify() was called since the last pause(), or something else happened. */
    void (*pause)(void);
    /* What was written before is seen by the other CPU, which is woken. */
    void (*notify)(void);
};

#endif
