// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The C API: a sea file in, float maps out, for hosts in any language. libocean.so exports these
// functions and nothing else.
//
// Rules that hold for every function:
// - No exception crosses. A function that fails returns a code, leaves its outputs alone and keeps
//   a sentence for ocean_last_error(), and its parts for ocean_last_error_field(). Any function may
//   return OCEAN_INVALID_ARGUMENT, OCEAN_OUT_OF_MEMORY and OCEAN_INTERNAL; the other codes stand
//   beside it.
// - An ocean_sea is for one thread at a time, several run in parallel: a call while another thread
//   is in the same sea returns OCEAN_BUSY, and ocean_free waits for that thread. Functions without
//   a sea may be called from any thread.
// - A child process after fork() may use and free the seas that no thread was in.
// - The rounding and flush-to-zero modes of the calling thread change no bit, and no call changes
//   them.
// - Times reach from -1e9 to 1e9 s; others are OCEAN_INVALID_ARGUMENT or OCEAN_INVALID_VALUE. Maps
//   are within 2e-6 of their rms until 1e8 s; at 1e9 s heights within 3e-6, slopes within 1.2e-5.
// - Texts are UTF-8. Buffers and texts belong to the caller and are not kept.
// - A text result goes to `out`, with a final 0. Pass *size = capacity of out in bytes; *size
//   becomes the size needed, the final 0 included. If that is more than the capacity, nothing is
//   written and OCEAN_BUFFER_TOO_SMALL returned. out = NULL asks for the size alone: OCEAN_OK.
// - A struct opens with struct_size, its size where the caller was compiled. A shorter one (an
//   older header) leaves the rest at its default, where there is one; a longer one (a newer
//   header) is accepted if the part unknown here is all 0, else OCEAN_UNSUPPORTED.
// - Functions, codes, members and enumerators of this header keep their names, numbers and meaning
//   while OCEAN_ABI_VERSION stays. *Not* promised from one version of the library to the next:
//   the bits of a map or an answer, their errors within what is said here, sentences of
//   ocean_last_error, the order and the set of keys in JSON, how often progress is called, memory
//   and time that a call takes, defaults of parameters that a text does not name, and everything of
//   the C++ headers.
// - ocean_text names all parameters that are set, but for those that a later version adds: each of
//   these has a neutral value, at which it changes no sea. That value is its default for ever, and
//   ocean_text leaves it out. So the text of a sea stays the same to the byte until it uses such a
//   parameter, and so does every file that is known by that text.
#ifndef LIBOCEAN_H
#define LIBOCEAN_H

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32) && defined(OCEAN_BUILDING)
#define OCEAN_API __declspec(dllexport)
#elif defined(__GNUC__)
#define OCEAN_API __attribute__((visibility("default")))
#else
#define OCEAN_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* Goes up when a struct or a meaning changes so that compiled callers break. */
#define OCEAN_ABI_VERSION 1

typedef struct ocean_sea ocean_sea;
typedef int32_t ocean_result;

enum {
    OCEAN_OK = 0,
    OCEAN_INVALID_ARGUMENT = 1, /* a NULL, a size or a count of this call */
    OCEAN_INVALID_VALUE = 2,    /* a parameter: unknown, of a wrong type, out of range */
    OCEAN_BAD_FILE = 3,    /* a file that is not there, cannot be read, is not what it claims */
    OCEAN_NOT_FOUND = 4,   /* a record or preset that does not exist */
    OCEAN_UNSUPPORTED = 5, /* a feature of a later version */
    OCEAN_OUTPUT = 6,      /* writing failed */
    OCEAN_OUT_OF_MEMORY = 7,
    OCEAN_BUFFER_TOO_SMALL = 8,
    OCEAN_INTERNAL = 9,   /* a fault of the library: please report it */
    OCEAN_CANCELLED = 10, /* by the host's own progress function */
    OCEAN_BUSY = 11       /* another thread is in this sea */
};

/* Channels. dx, dy: offsets of the displaced point [m]; slope by label; velocity [m/s]. */
enum {
    OCEAN_DX,
    OCEAN_DY,
    OCEAN_HEIGHT,
    OCEAN_NX,
    OCEAN_NY,
    OCEAN_NZ,
    OCEAN_SLOPE_X,
    OCEAN_SLOPE_Y,
    OCEAN_JACOBIAN,
    OCEAN_WHITECAP,
    OCEAN_FOAM,
    OCEAN_VX,
    OCEAN_VY,
    OCEAN_VZ,
    OCEAN_DX_X, /* derivatives of the offset by label: d dx/dx, d dy/dy, d dx/dy = d dy/dx */
    OCEAN_DY_Y,
    OCEAN_DX_Y,
    OCEAN_COVER /* the share of the water that foam hides; what is seen from far away is its mean */
};

/* Axes of vectors: (x, y, z), (x, z, -y), (x, z, y). */
enum { OCEAN_ZUP, OCEAN_YUP, OCEAN_TNB };

/* Backends. */
enum { OCEAN_CPU, OCEAN_GL, OCEAN_RADIX2, OCEAN_DFT };

/* Where foam begins: from as far back as it lives, so that a map is the same whatever was asked
 * before; or from nothing at the first time asked for, for live tools, which do not wait. */
enum { OCEAN_FOAM_SETTLED, OCEAN_FOAM_EMPTY };

/* Called by the thread that called the library, about a hundred times a second while it works. Of
 * foam that is followed from its beginning done and total are ticks; otherwise both are 0. A result
 * other than 0 ends the call: within 50 ms it returns OCEAN_CANCELLED. What it was to write is then
 * unfinished; the sea is as usable as before. It must not call functions of this sea. */
typedef int32_t (*ocean_progress)(void* user, int64_t done, int64_t total);

/* A host's own threads in place of the library's: runs job(work, 0) .. job(work, count - 1), in any
 * order, at once or one after the other, and returns when all of them have. progress is then called
 * by one of these threads at a time. */
typedef void (*ocean_job)(void* work, int32_t index);
typedef void (*ocean_run_jobs)(void* user, ocean_job job, void* work, int32_t count);

/* struct_size = sizeof(ocean_options). threads: 0 = the cores this process may use, else 1 .. 1024,
 * the caller's own among them, or with run_jobs the most that run at once. backend: OCEAN_CPU;
 * OCEAN_RADIX2 and OCEAN_DFT are the slow references. */
typedef struct {
    size_t struct_size;
    int32_t threads;
    int32_t backend;
    int32_t foam_start;      /* OCEAN_FOAM_... */
    int32_t reserved;        /* 0 */
    ocean_progress progress; /* may be NULL */
    void* user;              /* handed to it */
    ocean_run_jobs run_jobs; /* may be NULL */
    void* jobs_user;         /* handed to it */
} ocean_options;

/* One destination of 1 to 4 interleaved channels: component c of sample (i, j), which lies i steps
 * east and j steps north, is data[j * row_pitch + i * channels + c] for a map of R x R samples.
 * row_pitch: floats from row to row, 0 = R * channels. seam: not 0 = one sample more in each row
 * and one row more, the first ones again a period on: R + 1 everywhere here. count: floats in data,
 * at least (R - 1) * row_pitch + R * channels. channel[c], c < channels, says what component c
 * holds, in z-up terms; -1: it is left as it is. axes turns whole vectors: where three neighbouring
 * components are {OCEAN_DX, OCEAN_DY, OCEAN_HEIGHT}, {OCEAN_NX, OCEAN_NY, OCEAN_NZ} or {OCEAN_VX,
 * OCEAN_VY, OCEAN_VZ}, in this order, those three receive, for a vector (x, y, z):
 *
 *     OCEAN_ZUP  (x, y, z)
 *     OCEAN_YUP  (x, z, -y)
 *     OCEAN_TNB  (x, z, y)
 *
 * Every other component is stored as it is, whatever the axes. So {OCEAN_DX, OCEAN_DY,
 * OCEAN_HEIGHT, -1} with OCEAN_YUP stores dx, height, -dy and leaves the fourth component. */
typedef struct {
    float* data;
    size_t count;
    int32_t channel[4];
    int32_t channels;
    int32_t axes;
    size_t row_pitch;
    int32_t seam;
    int32_t reserved; /* 0 */
} ocean_output;

/* struct_size = sizeof(ocean_request), output_size = sizeof(ocean_output); 0 = that of a header
 * with as many members as are here. time in seconds. resolution: 0 = what ocean_map_resolution
 * says, else a power of two, 32 .. 8192. cascade: 0 = the whole sea; 1 .. the small map of one of
 * its cascades, over its own period, for hosts that add them up while they draw: at any point the
 * sum over the cascades, each wrapped round its own period, is the sea's. Of channels that add up:
 * OCEAN_DX, DY, HEIGHT, SLOPE_X, SLOPE_Y, VX, VY, VZ, DX_X, DY_Y, DX_Y; jacobian = (1 + DX_X) (1 +
 * DY_Y) - DX_Y^2. Its resolution 0 is that of the cascade's lattice. */
typedef struct {
    size_t struct_size;
    double time;
    int32_t resolution;
    const ocean_output* outputs;
    size_t output_count;
    size_t output_size;
    int32_t cascade;
    int32_t reserved; /* 0 */
} ocean_request;

/* The OCEAN_ABI_VERSION that the library was built with: compare with the header's. Never fails. */
OCEAN_API uint32_t ocean_abi_version(void);
/* "0.1.0". Lives for ever. */
OCEAN_API const char* ocean_version(void);
/* What went wrong in this thread's last failed call; "" before any. Lives until the next failed
 * call of this thread. */
OCEAN_API const char* ocean_last_error(void);
/* Parts of a failure. */
enum {
    OCEAN_ERROR_WHAT,      /* "is out of range": all of the sentence where it has no other part */
    OCEAN_ERROR_PARAMETER, /* "waves.0.fetch"; also a member of a request or an argument */
    OCEAN_ERROR_VALUE,     /* "5": as the sentence shows it */
    OCEAN_ERROR_ALLOWED    /* "1000 .. 10000000 m" */
};
/* Returns one part of what ocean_last_error() says in a sentence, so that a host need not take the
 * sentence apart: to mark a field, or to say it in its own words. "" where the failure has no such
 * part, and for a part of a later version; never NULL. The parameter of a failure is promised, the
 * words of its other parts are not. Lives until the next failed call of this thread. Never fails.
 */
OCEAN_API const char* ocean_last_error_field(int32_t field);

/* Opens a sea file. options may be NULL. *out is to be freed by ocean_free; it needs neither the
 * file nor the options any more. BAD_FILE, INVALID_VALUE, NOT_FOUND, UNSUPPORTED. */
OCEAN_API ocean_result ocean_open(const char* path, const ocean_options* options, ocean_sea** out);
/* The same from text of `length` bytes (no final 0 needed); base_dir is where a relative `file`
 * starts, NULL = the current directory. */
OCEAN_API ocean_result ocean_parse(const char* toml, size_t length, const char* base_dir,
                                   const ocean_options* options, ocean_sea** out);
/* The same sea for another thread: shares what `sea` has built, until either is changed. options
 * may be NULL: those of `sea`. */
OCEAN_API ocean_result ocean_clone(const ocean_sea* sea, const ocean_options* options,
                                   ocean_sea** out);
/* Frees the sea and all it holds; waits for a thread that is in it. NULL is allowed. */
OCEAN_API void ocean_free(ocean_sea* sea);

/* Sets a parameter by name ("wind_speed", "waves.1.fetch") from text. A refused value changes
 * nothing. `file`, `record` and `place` of a measured system read the file again. INVALID_VALUE,
 * UNSUPPORTED; BAD_FILE and NOT_FOUND for those three. */
OCEAN_API ocean_result ocean_set(ocean_sea* sea, const char* name, const char* value);
/* Several in one call, names[i] from values[i], checked together: of values that go with each other
 * alone all are taken, or none. Codes as ocean_set. */
OCEAN_API ocean_result ocean_set_all(ocean_sea* sea, const char* const* names,
                                     const char* const* values, size_t count);
/* A wave system with default values becomes "waves.1", or whatever its name says: those from there
 * on have their numbers one higher, also in the sea's take. At most 16. INVALID_VALUE. */
OCEAN_API ocean_result ocean_add_waves(ocean_sea* sea, const char* name);
/* The system of that name goes, with what the take plays of it; the last one stays.
 * INVALID_VALUE. */
OCEAN_API ocean_result ocean_remove_waves(ocean_sea* sea, const char* name);
/* A live parameter glides to the value from that time on, while the sea is shown: an event of the
 * sea's own take, which ocean_text then holds, so that every frame can be made again in every bit.
 * What was before that time stays, foam included, and costs nothing again. Values of one parameter
 * that follow each other within 1/60 s wait for the rest of it, and the last of them counts.
 * ocean_set, in contrast, makes another sea. INVALID_VALUE, with nothing changed: a parameter that
 * is not live, a sea with a loop, a time before the last that was performed, a take that is full
 * (32768 events). */
OCEAN_API ocean_result ocean_perform(ocean_sea* sea, double time, const char* name,
                                     const char* value);
/* Its value as text into out[size], with a final 0; an unset one is "". INVALID_VALUE;
 * BUFFER_TOO_SMALL, and then the sentence says the size needed. */
OCEAN_API ocean_result ocean_get(const ocean_sea* sea, const char* name, char* out, size_t size);

/* The resolved sea file, self-contained: ocean_parse of it gives the same sea in every bit.
 * BUFFER_TOO_SMALL; INVALID_VALUE while values that ocean_set has let in one by one contradict each
 * other. */
OCEAN_API ocean_result ocean_text(const ocean_sea* sea, char* out, size_t* size);
/* The parameter table, a JSON array. BUFFER_TOO_SMALL. */
OCEAN_API ocean_result ocean_parameters_json(char* out, size_t* size);
/* What `ocean info --json` prints, a JSON object: builds the spectrum when needed.
 * BUFFER_TOO_SMALL. */
OCEAN_API ocean_result ocean_state_json(const ocean_sea* sea, char* out, size_t* size);
/* The records of a spectrum file that can be read, a JSON array. BAD_FILE, BUFFER_TOO_SMALL. */
OCEAN_API ocean_result ocean_records_json(const char* file, char* out, size_t* size);
/* The sea file of a preset ("beaufort_6"); with name = NULL the names of all, a JSON array.
 * NOT_FOUND, BUFFER_TOO_SMALL. */
OCEAN_API ocean_result ocean_preset(const char* name, char* out, size_t* size);
/* Jerlov's optical types of sea water, clearest first, a JSON array: name ("jerlov_ii"), label,
 * help, ior; absorption and scattering [1/m], albedo of the water below its surface, each a list of
 * red, green, blue of linear Rec. 709; anisotropy, the mean cosine of scattering; foam_albedo.
 * BUFFER_TOO_SMALL. */
OCEAN_API ocean_result ocean_water_types_json(char* out, size_t* size);

/* Samples a side of a map where a request says 0: grid.resolution, and up to four times that for
 * several cascades. */
OCEAN_API ocean_result ocean_map_resolution(const ocean_sea* sea, int32_t* resolution);
/* The periods of the sea's cascades, m, to periods[0 ..]. Pass *count = room in periods; *count
 * becomes how many there are, and if that is more, nothing is written and OCEAN_BUFFER_TOO_SMALL
 * returned. periods = NULL asks for the count alone. */
OCEAN_API ocean_result ocean_cascade_periods(const ocean_sea* sea, double* periods, size_t* count);
/* Computes every output of the request in one go; the same bits for any number of threads and any
 * order of calls. Blocks. A request that fails a check writes nothing. OCEAN_FOAM is followed from
 * where it begins, which takes a while for the first map, or from the last time asked for. Buffers
 * need no alignment; those aligned to 64 bytes are filled fastest. UNSUPPORTED. */
OCEAN_API ocean_result ocean_evaluate(ocean_sea* sea, const ocean_request* request);
/* *power becomes that of a map's cover at a time: OCEAN_COVER is OCEAN_FOAM to this power, for
 * hosts that make the one of the other. resolution: of the map, 0 = ocean_map_resolution. Takes
 * some tenths of a second after a change of waves or wind. CANCELLED. */
OCEAN_API ocean_result ocean_cover_power(ocean_sea* sea, double time, int32_t resolution,
                                         double* power);
/* The surface that is shown at n world points, xy = x0, y0, x1, y1 ... in metres, any distance from
 * the origin. The displacement is inverted; where crests have folded over, the top sheet is taken.
 * Point i receives ten floats from samples + i * stride on, those of `ocean query`:
 *     x, y, height, normal x y z (unit, up), velocity x y z (of the shown point, m/s), foam (0 ..
 * 1). stride counts floats, 10 or more; or 9 to go without the foam, whose past takes far longer
 * than all the rest. n = 0 is allowed. Points that are not finite are
 * INVALID_ARGUMENT. Good to 2e-3 of the rms height or better. The same bits for any number of
 * threads. Points of one time are cheapest in a row: what the first call computes is kept for the
 * next of the same time. */
OCEAN_API ocean_result ocean_query(ocean_sea* sea, double time, const double* xy, size_t n,
                                   float* samples, size_t stride);
/* What ocean_query_points says of a point. */
enum {
    OCEAN_FOLDED = 1,   /* several sheets are shown there: this is the top one */
    OCEAN_UNDECIDED = 2 /* so folded that not all of them were found: perhaps not the top one */
};
typedef struct {
    float height;      /* m */
    float normal[3];   /* unit, up */
    float velocity[3]; /* of the shown point, m/s */
    float foam;        /* 0 .. 1, 0 where it was not asked for */
    double label[2];   /* m: which point of the undisplaced surface is shown there */
    int32_t flags;     /* OCEAN_FOLDED, OCEAN_UNDECIDED */
    int32_t reserved;
} ocean_sample;

/* struct_size = sizeof(ocean_query_request), sample_size = sizeof(ocean_sample): a smaller one has
 * fewer members filled. resolution: the waves that a map of so many samples holds, for answers that
 * cost a fraction; 0 = all that the sea's own map holds. refine: 0 or 1, or 2, 4 ... for smaller
 * errors. exact: not 0 = the sum over all waves in double precision, a hundred times as slow. foam:
 * not 0 = with foam, whose past takes far longer than all the rest. height_error: NULL, or receives
 * the rms of what the heights lack of the exact sum over all waves of the sea, m. */
typedef struct {
    size_t struct_size;
    double time;
    const double* xy; /* x0, y0, x1, y1 ... */
    size_t count;
    ocean_sample* samples;
    size_t sample_size;
    int32_t resolution;
    int32_t refine;
    int32_t exact;
    int32_t foam;
    double* height_error;
} ocean_query_request;

/* As ocean_query, with all that is known of each point. INVALID_VALUE for a refine or a resolution
 * that is not allowed. */
OCEAN_API ocean_result ocean_query_points(ocean_sea* sea, const ocean_query_request* request);
/* The velocity of the water (x, y, z in m/s) by linear theory at n fixed world points z metres
 * above still water: three floats from velocities + i * stride on, stride 3 or more. Above z = 0 it
 * is that of z = 0, below the bottom there is none. Otherwise as ocean_query. */
OCEAN_API ocean_result ocean_orbital_velocity(ocean_sea* sea, double time, double z,
                                              const double* xy, size_t n, float* velocities,
                                              size_t stride);
/* What moves in the water at a point: velocity [m/s], and pressure without the hydrostatic part,
 * [Pa] as the sea's water_density says. */
typedef struct {
    float velocity[3];
    float pressure;
} ocean_water_sample;

/* struct_size = sizeof(ocean_water_request), sample_size = sizeof(ocean_water_sample). Each point
 * has its own z; every other one among them costs two transforms. resolution, refine, exact: as in
 * ocean_query_request. */
typedef struct {
    size_t struct_size;
    double time;
    const double* xyz; /* x0, y0, z0, x1 ... */
    size_t count;
    ocean_water_sample* samples;
    size_t sample_size;
    int32_t resolution;
    int32_t refine;
    int32_t exact;
    int32_t reserved;
} ocean_water_request;

/* As ocean_orbital_velocity, and the pressure, at points of any depths. */
OCEAN_API ocean_result ocean_water_points(ocean_sea* sea, const ocean_water_request* request);
/* How n floating bodies lie on the sea: on the plane that fits the surface below them best.
 * bodies: five doubles each, x, y [m], heading [degrees counter-clockwise from +x], length along
 * the heading and width [m], 0 .. 100000. Body i receives eleven floats from poses + i * stride on,
 * stride 11 or more:
 *     position x y z, up x y z, forward x y z (units), pitch (bow up), roll (port side up)
 * [degrees]. Otherwise as ocean_query. */
OCEAN_API ocean_result ocean_float_pose(ocean_sea* sea, double time, const double* bodies, size_t n,
                                        float* poses, size_t stride);

/* One band of the waves too short for a map: a slope map of its own, over `tile` metres. Waves of
 * shortest .. longest metres, the first band beside the square of wavenumbers that the map holds:
 * none is shown twice, none left out. variance_x, variance_y, covariance: E[hx^2], E[hy^2], E[hx
 * hy] of its slopes hx = dh/dx, hy = dh/dy by label, the integral of the spectrum. */
typedef struct {
    double shortest_wave;
    double longest_wave;
    double tile;
    double variance_x;
    double variance_y;
    double covariance;
} ocean_detail_band;

/* struct_size = sizeof(ocean_detail_request), band_size = sizeof(ocean_detail_band): a smaller one
 * has fewer members filled; output_size = sizeof(ocean_output). resolution: of the map that is
 * shown, as in ocean_request. samples: a side of each tile, 0 = 512, else 256, 512 or 1024.
 * outputs[i]: the map of band i, of samples x samples, of OCEAN_SLOPE_X and OCEAN_SLOPE_Y; one that
 * names no channel leaves its band out. */
typedef struct {
    size_t struct_size;
    double time;
    int32_t resolution;
    int32_t samples;
    ocean_detail_band* bands; /* may be NULL */
    size_t band_count;        /* room in bands */
    size_t band_size;
    const ocean_output* outputs; /* may be NULL */
    size_t output_count;         /* at most the bands that there are */
    size_t output_size;
} ocean_detail_request;

/* The waves too short for a map, about half of the sea's slopes, as small periodic slope maps of
 * the same sea at the same time, for materials; shaders/wave/slope_tiles.glsl says how to read them
 * without a repetition. *count receives the number of bands, 0 to 3, which follows from the grid
 * and the limits of wavelengths alone; if that is more than the room in bands, nothing else is
 * written and OCEAN_BUFFER_TOO_SMALL returned; bands = NULL asks for the count alone. *residual, if
 * not NULL, receives the mean square slope of the waves shorter than all bands, which are roughness
 * at any distance: map, bands and residual together have the sea's. As maps a pure function of sea
 * and time, the same bits for any number of threads. INVALID_VALUE for settings out of range. */
OCEAN_API ocean_result ocean_detail(ocean_sea* sea, const ocean_detail_request* request,
                                    size_t* count, double* residual);

/* A particle of spray: a parcel of drops of one size that the wind has torn off where the sea
 * turned white. Born within one period of the sea; then it may leave it: copies a period on are as
 * true. */
typedef struct {
    uint64_t id;        /* the same from birth to end in every frame, in a loop every time round */
    double position[3]; /* m */
    float velocity[3];  /* d/dt of it, m/s */
    float age;          /* s since its birth */
    float life;         /* s, the age at which it ends: known from its birth */
    float radius;       /* m, of each of its drops */
} ocean_spray_particle;

/* struct_size = sizeof(ocean_spray_request), particle_size = sizeof(ocean_spray_particle): a
 * smaller one has fewer members filled. lifetime: the greatest age [s], 0.05 .. 10, in a loop at
 * most half of it; usual is 2. density: particles for each m^2 that turns white, 0 .. 1000; usual
 * is 0.25. In winds below 11 m/s fewer, below 7 m/s none. most: alive at once, about, 1 .. 100
 * million: where there would be more they are thinner, all over the sea alike; usual is 1 million.
 */
typedef struct {
    size_t struct_size;
    double time;
    double lifetime;
    double density;
    int32_t most;
    int32_t reserved; /* 0 */
    ocean_spray_particle* particles;
    size_t particle_count; /* room in particles */
    size_t particle_size;
} ocean_spray_request;

/* All spray that is alive at a time, in no place's order but always the same one. *count receives
 * how many there are; if that is more than there is room for, nothing else is written and
 * OCEAN_BUFFER_TOO_SMALL returned. particles = NULL asks for the count alone. The sea keeps what
 * was not taken: the call with room that follows copies it. The first call makes a small map for
 * every tick of the foam's clock within the lifetime; a later time pays for the ticks that are new
 * alone, and has the same bits. INVALID_VALUE for settings out of range. */
OCEAN_API ocean_result ocean_spray(ocean_sea* sea, const ocean_spray_request* request,
                                   size_t* count);

/* struct_size = sizeof(ocean_foam_texture_request). kind: "lace" (nets, made for a tile of 12 m),
 * "bubbles" (1.3 m) or "streaks" (97 m, along x, which is to be the wind). size: texels a side, a
 * power of two, 64 .. 4096. seed: kinds are independent of each other, also of one seed. data
 * receives size * size values: texel (i, j), whose middle is (i + 1/2, j + 1/2) / size of the tile,
 * goes to data[j * size + i], j up. count: floats in data. */
typedef struct {
    size_t struct_size;
    const char* kind;
    int32_t size;
    uint32_t seed;
    float* data;
    size_t count;
} ocean_foam_texture_request;

/* A texture of foam that tiles, values 0 .. 1: a place is white where it is below the cover there.
 * Its bilinear reads are uniform, so that exactly a share c of the area is below c, to 5e-4 (of
 * bubbles with 128 texels a side to 1e-3, with 64 to 6e-3); what is low is the last to vanish.
 * *period receives the side of the tile that it is made for, m; NULL is allowed, and so is data =
 * NULL, which asks for the period alone. options may be NULL; of them threads, progress and
 * run_jobs count. INVALID_VALUE for a kind or size that is not allowed, BUFFER_TOO_SMALL,
 * CANCELLED. */
OCEAN_API ocean_result ocean_foam_texture(const ocean_foam_texture_request* request,
                                          const ocean_options* options, double* period);

/* A wave gauge. fixes: four doubles each, time [s], x, y, z [m, up from still water], in order of
 * time; it goes straight from one to the next. A single one is left at `velocity` [m/s]. */
typedef struct {
    const double* fixes;
    size_t fix_count;
    double velocity[2];
} ocean_gauge;

/* struct_size = sizeof(ocean_gauge_request), gauge_size = sizeof(ocean_gauge). Readings at the
 * times start + i / rate [s, Hz] up to `end`. */
typedef struct {
    size_t struct_size;
    double start;
    double end;
    double rate;
    const ocean_gauge* gauges;
    size_t gauge_count;
    size_t gauge_size;
    double* values;
    size_t value_count; /* doubles in values */
} ocean_gauge_request;

/* What gauges read, by sums over all waves in double precision, of the top sheet where crests fold.
 * Gauge g at time i receives ten doubles from values + (i * gauge_count + g) * 10 on:
 *     time, x, y, elevation [m], slope x y of the shown surface, velocity of the water at its depth
 *     x y z [m/s], pressure there without the hydrostatic part [Pa].
 * *times receives the number of times; values = NULL asks for that alone. BUFFER_TOO_SMALL,
 * INVALID_VALUE. */
OCEAN_API ocean_result ocean_gauges(ocean_sea* sea, const ocean_gauge_request* request,
                                    size_t* times);

#ifdef __cplusplus
}
#endif

#endif
