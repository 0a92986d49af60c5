/* Bad luck on order: preloaded into the program, it makes calls of the system and of OpenCL fail.
 *
 *   BAD_LUCK         what fails: "disk" (everything that changes files below BAD_LUCK_FOLDER), "opencl", or the name of
 *                    one function
 *   BAD_LUCK_AFTER   so many calls that succeed before; from then on all fail
 *   BAD_LUCK_ERROR   errno of files (default ENOSPC, the disk is full), or the code of OpenCL (CL_OUT_OF_RESOURCES)
 *   BAD_LUCK_COUNT   a file that is told, at the end, how many calls there were that can fail
 *   BAD_LUCK_HIDES   files below this folder cannot be found
 *
 * Only in the program itself, not in what it starts.
 */
#define _GNU_SOURCE
#define CL_TARGET_OPENCL_VERSION 120
#define CL_USE_DEPRECATED_OPENCL_1_2_APIS
#include <CL/cl.h>
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

static atomic_long calls;

static int is_the_program(void) { return strcmp(program_invocation_short_name, "poissonlab") == 0; }

static long number(const char* name, long otherwise)
{
    const char* value = getenv(name);
    return value ? atol(value) : otherwise;
}

/* Whether this call of `function`, one of `group`, is one that fails. */
static int fails(const char* group, const char* function)
{
    const char* wanted = getenv("BAD_LUCK");
    if (!wanted || !is_the_program() || (strcmp(wanted, group) != 0 && strcmp(wanted, function) != 0)) return 0;
    return atomic_fetch_add(&calls, 1) >= number("BAD_LUCK_AFTER", 0);
}

#define REAL(RESULT, NAME, ...)                                                                                      \
    static RESULT (*real)(__VA_ARGS__);                                                                              \
    if (!real) real = (RESULT(*)(__VA_ARGS__))dlsym(RTLD_NEXT, #NAME)

/* Files. */

static int is_below(const char* path, const char* folder)
{
    const size_t length = strlen(folder);
    return strncmp(path, folder, length) == 0 && (path[length] == '/' || path[length] == 0);
}

static int is_hidden(const char* path)
{
    const char* folder = getenv("BAD_LUCK_HIDES");
    if (!folder || !path || !is_the_program() || !is_below(path, folder)) return 0;
    errno = ENOENT;
    return 1;
}

static int disk_fails(const char* path, const char* function)
{
    const char* folder = getenv("BAD_LUCK_FOLDER");
    if (!folder || !path || !is_below(path, folder) || !fails("disk", function)) return 0;
    errno = (int)number("BAD_LUCK_ERROR", ENOSPC);
    return 1;
}

static int file_fails(int file, const char* function)
{
    if (!getenv("BAD_LUCK_FOLDER")) return 0;
    char link[64];
    char path[4096];
    snprintf(link, sizeof link, "/proc/self/fd/%d", file);
    REAL(ssize_t, readlink, const char*, char*, size_t);
    const ssize_t length = real(link, path, sizeof path - 1);
    if (length < 0) return 0;
    path[length] = 0;
    return disk_fails(path, function);
}

ssize_t write(int file, const void* data, size_t size)
{
    REAL(ssize_t, write, int, const void*, size_t);
    return file_fails(file, "write") ? -1 : real(file, data, size);
}

ssize_t writev(int file, const struct iovec* parts, int count)
{
    REAL(ssize_t, writev, int, const struct iovec*, int);
    return file_fails(file, "writev") ? -1 : real(file, parts, count);
}

ssize_t pwrite(int file, const void* data, size_t size, off_t offset)
{
    REAL(ssize_t, pwrite, int, const void*, size_t, off_t);
    return file_fails(file, "pwrite") ? -1 : real(file, data, size, offset);
}

int fsync(int file)
{
    REAL(int, fsync, int);
    return file_fails(file, "fsync") ? -1 : real(file);
}

int ftruncate(int file, off_t size)
{
    REAL(int, ftruncate, int, off_t);
    return file_fails(file, "ftruncate") ? -1 : real(file, size);
}

size_t fwrite(const void* data, size_t size, size_t count, FILE* file)
{
    REAL(size_t, fwrite, const void*, size_t, size_t, FILE*);
    return file_fails(fileno(file), "fwrite") ? 0 : real(data, size, count, file);
}

int fflush(FILE* file)
{
    REAL(int, fflush, FILE*);
    return file && file_fails(fileno(file), "fflush") ? EOF : real(file);
}

int fclose(FILE* file)
{
    REAL(int, fclose, FILE*);
    const int writes = (fcntl(fileno(file), F_GETFL) & O_ACCMODE) != O_RDONLY;
    const int bad = writes && file_fails(fileno(file), "fclose");
    const int code = errno;
    const int result = real(file);
    if (!bad) return result;
    errno = code;
    return EOF;
}

static int creates(int flags) { return (flags & O_ACCMODE) != O_RDONLY; }

#define OPEN(NAME)                                                                                                   \
    int NAME(const char* path, int flags, ...)                                                                       \
    {                                                                                                                \
        va_list more;                                                                                                \
        va_start(more, flags);                                                                                       \
        const mode_t mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(more, mode_t) : 0;                                \
        va_end(more);                                                                                                \
        REAL(int, NAME, const char*, int, ...);                                                                      \
        if (is_hidden(path) || (creates(flags) && disk_fails(path, "open"))) return -1;                              \
        return real(path, flags, mode);                                                                              \
    }
OPEN(open)
OPEN(open64)

#define OPENAT(NAME)                                                                                                 \
    int NAME(int folder, const char* path, int flags, ...)                                                           \
    {                                                                                                                \
        va_list more;                                                                                                \
        va_start(more, flags);                                                                                       \
        const mode_t mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(more, mode_t) : 0;                                \
        va_end(more);                                                                                                \
        REAL(int, NAME, int, const char*, int, ...);                                                                 \
        if (is_hidden(path) || (creates(flags) && disk_fails(path, "open"))) return -1;                              \
        return real(folder, path, flags, mode);                                                                      \
    }
OPENAT(openat)
OPENAT(openat64)

#define FOPEN(NAME)                                                                                                  \
    FILE* NAME(const char* path, const char* mode)                                                                   \
    {                                                                                                                \
        REAL(FILE*, NAME, const char*, const char*);                                                                 \
        if (is_hidden(path) || (mode[0] != 'r' && disk_fails(path, "open"))) return NULL;                            \
        return real(path, mode);                                                                                     \
    }
FOPEN(fopen)
FOPEN(fopen64)

ssize_t readlink(const char* path, char* target, size_t size)
{
    REAL(ssize_t, readlink, const char*, char*, size_t);
    return is_hidden(path) ? -1 : real(path, target, size);
}

int access(const char* path, int mode)
{
    REAL(int, access, const char*, int);
    return is_hidden(path) ? -1 : real(path, mode);
}

int stat(const char* restrict path, struct stat* restrict info)
{
    REAL(int, stat, const char*, struct stat*);
    return is_hidden(path) ? -1 : real(path, info);
}

int mkdir(const char* path, mode_t mode)
{
    REAL(int, mkdir, const char*, mode_t);
    return disk_fails(path, "mkdir") ? -1 : real(path, mode);
}

int rename(const char* from, const char* to)
{
    REAL(int, rename, const char*, const char*);
    return disk_fails(to, "rename") ? -1 : real(from, to);
}

int link(const char* from, const char* to)
{
    REAL(int, link, const char*, const char*);
    return disk_fails(to, "link") ? -1 : real(from, to);
}

int statvfs(const char* restrict path, struct statvfs* restrict info)
{
    REAL(int, statvfs, const char*, struct statvfs*);
    const int result = real(path, info);
    const char* folder = getenv("BAD_LUCK_FOLDER");
    const int is_full = number("BAD_LUCK_AFTER", 0) == 0; /* from the begin; else it fills up */
    if (result == 0 && folder && is_full && is_below(path, folder)) info->f_bavail = 0;
    return result;
}

/* OpenCL. */

static int device_fails(const char* function) { return fails("opencl", function); }

static cl_int error_code(void) { return (cl_int)number("BAD_LUCK_ERROR", CL_OUT_OF_RESOURCES); }

#define CALL(NAME, PARAMETERS, ARGUMENTS)                                                                            \
    CL_API_ENTRY cl_int CL_API_CALL NAME PARAMETERS                                                                  \
    {                                                                                                                \
        static cl_int (*real) PARAMETERS;                                                                            \
        if (!real) real = (cl_int(*) PARAMETERS)dlsym(RTLD_NEXT, #NAME);                                             \
        return device_fails(#NAME) ? error_code() : real ARGUMENTS;                                                  \
    }

#define CREATION(RESULT, NAME, PARAMETERS, ARGUMENTS)                                                                \
    CL_API_ENTRY RESULT CL_API_CALL NAME PARAMETERS                                                                  \
    {                                                                                                                \
        static RESULT(*real) PARAMETERS;                                                                             \
        if (!real) real = (RESULT(*) PARAMETERS)dlsym(RTLD_NEXT, #NAME);                                             \
        if (!device_fails(#NAME)) return real ARGUMENTS;                                                             \
        if (error) *error = error_code();                                                                            \
        return NULL;                                                                                                 \
    }

CALL(clGetPlatformIDs, (cl_uint entries, cl_platform_id* platforms, cl_uint* count), (entries, platforms, count))
CALL(clGetDeviceIDs,
     (cl_platform_id platform, cl_device_type type, cl_uint entries, cl_device_id* devices, cl_uint* count),
     (platform, type, entries, devices, count))
CALL(clGetDeviceInfo, (cl_device_id device, cl_device_info name, size_t size, void* value, size_t* actual),
     (device, name, size, value, actual))
CALL(clCreateSubDevices,
     (cl_device_id device, const cl_device_partition_property* properties, cl_uint entries, cl_device_id* devices,
      cl_uint* count),
     (device, properties, entries, devices, count))
CREATION(cl_context, clCreateContext,
         (const cl_context_properties* properties, cl_uint count, const cl_device_id* devices,
          void(CL_CALLBACK* notify)(const char*, const void*, size_t, void*), void* data, cl_int* error),
         (properties, count, devices, notify, data, error))
CREATION(cl_command_queue, clCreateCommandQueue,
         (cl_context context, cl_device_id device, cl_command_queue_properties properties, cl_int* error),
         (context, device, properties, error))
CREATION(cl_mem, clCreateBuffer, (cl_context context, cl_mem_flags flags, size_t size, void* host, cl_int* error),
         (context, flags, size, host, error))
CREATION(cl_program, clCreateProgramWithSource,
         (cl_context context, cl_uint count, const char** texts, const size_t* lengths, cl_int* error),
         (context, count, texts, lengths, error))
CALL(clBuildProgram,
     (cl_program program, cl_uint count, const cl_device_id* devices, const char* options,
      void(CL_CALLBACK* notify)(cl_program, void*), void* data),
     (program, count, devices, options, notify, data))
CALL(clGetProgramBuildInfo,
     (cl_program program, cl_device_id device, cl_program_build_info name, size_t size, void* value, size_t* actual),
     (program, device, name, size, value, actual))
CREATION(cl_kernel, clCreateKernel, (cl_program program, const char* name, cl_int* error), (program, name, error))
CALL(clSetKernelArg, (cl_kernel kernel, cl_uint index, size_t size, const void* value), (kernel, index, size, value))
CALL(clEnqueueNDRangeKernel,
     (cl_command_queue queue, cl_kernel kernel, cl_uint dimension, const size_t* offset, const size_t* items,
      const size_t* group, cl_uint waits, const cl_event* wait, cl_event* event),
     (queue, kernel, dimension, offset, items, group, waits, wait, event))
CALL(clEnqueueReadBuffer,
     (cl_command_queue queue, cl_mem buffer, cl_bool blocks, size_t offset, size_t size, void* data, cl_uint waits,
      const cl_event* wait, cl_event* event),
     (queue, buffer, blocks, offset, size, data, waits, wait, event))
CALL(clEnqueueWriteBuffer,
     (cl_command_queue queue, cl_mem buffer, cl_bool blocks, size_t offset, size_t size, const void* data,
      cl_uint waits, const cl_event* wait, cl_event* event),
     (queue, buffer, blocks, offset, size, data, waits, wait, event))
CALL(clFinish, (cl_command_queue queue), (queue))

/* The count. */

__attribute__((destructor)) static void tell_count(void)
{
    const char* path = getenv("BAD_LUCK_COUNT");
    if (!path || !is_the_program()) return;
    FILE* file = fopen(path, "w");
    if (!file) return;
    fprintf(file, "%ld\n", atomic_load(&calls));
    fclose(file);
}
