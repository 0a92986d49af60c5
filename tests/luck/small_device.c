/* A device that is smaller than it is: preloaded, it tells of fewer resources, and refuses what goes beyond them, as a
 * driver of such a device does.
 *
 *   SMALL_DEVICE_LOCAL        bytes of local memory
 *   SMALL_DEVICE_ALLOCATION   bytes of the largest buffer
 *   SMALL_DEVICE_GROUP        work-items of a work-group
 *   SMALL_DEVICE_UNITS        compute units
 *   SMALL_DEVICE_DOUBLES      0: no double precision
 *   SMALL_DEVICE_DIVIDES      0: it cannot be divided, and a call that does so ends the program
 */
#define _GNU_SOURCE
#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>
#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

#define REAL(RESULT, NAME, ...)                                                                                      \
    static RESULT(CL_API_CALL* real)(__VA_ARGS__);                                                                   \
    if (!real) real = (RESULT(CL_API_CALL*)(__VA_ARGS__))dlsym(RTLD_NEXT, #NAME)

static size_t limit(const char* name)
{
    const char* value = getenv(name);
    return value ? strtoull(value, NULL, 10) : (size_t)-1;
}

/* The variable that limits what is asked; null: none does. */
static const char* variable_of(cl_device_info name)
{
    switch (name) {
    case CL_DEVICE_LOCAL_MEM_SIZE:
        return "SMALL_DEVICE_LOCAL";
    case CL_DEVICE_MAX_MEM_ALLOC_SIZE:
        return "SMALL_DEVICE_ALLOCATION";
    case CL_DEVICE_MAX_WORK_GROUP_SIZE:
        return "SMALL_DEVICE_GROUP";
    case CL_DEVICE_MAX_COMPUTE_UNITS:
        return "SMALL_DEVICE_UNITS";
    case CL_DEVICE_DOUBLE_FP_CONFIG:
        return "SMALL_DEVICE_DOUBLES";
    case CL_DEVICE_PARTITION_PROPERTIES:
        return "SMALL_DEVICE_DIVIDES";
    default:
        return NULL;
    }
}

CL_API_ENTRY cl_int CL_API_CALL clGetDeviceInfo(cl_device_id device, cl_device_info name, size_t size, void* value,
                                                size_t* actual)
{
    REAL(cl_int, clGetDeviceInfo, cl_device_id, cl_device_info, size_t, void*, size_t*);
    const cl_int result = real(device, name, size, value, actual);
    const char* variable = variable_of(name);
    if (result != CL_SUCCESS || !value || !variable) return result;
    const size_t most = limit(variable);
    if (name == CL_DEVICE_PARTITION_PROPERTIES) {
        if (most == 0) memset(value, 0, size);
    } else if (size == sizeof(cl_uint)) {
        cl_uint* number = value;
        if (*number > most) *number = (cl_uint)most;
    } else {
        cl_ulong* number = value;
        if (*number > most) *number = most;
    }
    return result;
}

CL_API_ENTRY cl_mem CL_API_CALL clCreateBuffer(cl_context context, cl_mem_flags flags, size_t size, void* host,
                                               cl_int* error)
{
    REAL(cl_mem, clCreateBuffer, cl_context, cl_mem_flags, size_t, void*, cl_int*);
    if (size <= limit("SMALL_DEVICE_ALLOCATION")) return real(context, flags, size, host, error);
    if (error) *error = CL_INVALID_BUFFER_SIZE;
    return NULL;
}

CL_API_ENTRY cl_int CL_API_CALL clCreateSubDevices(cl_device_id device, const cl_device_partition_property* properties,
                                                   cl_uint entries, cl_device_id* devices, cl_uint* count)
{
    REAL(cl_int, clCreateSubDevices, cl_device_id, const cl_device_partition_property*, cl_uint, cl_device_id*,
         cl_uint*);
    if (limit("SMALL_DEVICE_DIVIDES") == 0) abort(); /* a null pointer in the driver's table */
    return real(device, properties, entries, devices, count);
}

static cl_ulong local_memory_of(cl_command_queue queue, cl_kernel kernel)
{
    cl_device_id device = NULL;
    cl_ulong bytes = 0;
    clGetCommandQueueInfo(queue, CL_QUEUE_DEVICE, sizeof device, &device, NULL);
    clGetKernelWorkGroupInfo(kernel, device, CL_KERNEL_LOCAL_MEM_SIZE, sizeof bytes, &bytes, NULL);
    return bytes;
}

CL_API_ENTRY cl_int CL_API_CALL clEnqueueNDRangeKernel(cl_command_queue queue, cl_kernel kernel, cl_uint dimension,
                                                       const size_t* offset, const size_t* items, const size_t* group,
                                                       cl_uint waits, const cl_event* wait, cl_event* event)
{
    REAL(cl_int, clEnqueueNDRangeKernel, cl_command_queue, cl_kernel, cl_uint, const size_t*, const size_t*,
         const size_t*, cl_uint, const cl_event*, cl_event*);
    if (group && group[0] > limit("SMALL_DEVICE_GROUP")) return CL_INVALID_WORK_GROUP_SIZE;
    if (local_memory_of(queue, kernel) > limit("SMALL_DEVICE_LOCAL")) return CL_OUT_OF_RESOURCES;
    return real(queue, kernel, dimension, offset, items, group, waits, wait, event);
}
