// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The C API of libocean: a sea file in, float maps out, for a host in any language. libocean.so
// exports these functions and nothing else.
//
// Rules that hold for every function:
// - No exception leaves the library. A function that fails returns a code, leaves its outputs
//   unchanged and stores a sentence for ocean_last_error() and its parts for
//   ocean_last_error_field(). Any function may return OCEAN_INVALID_ARGUMENT, OCEAN_OUT_OF_MEMORY
//   and OCEAN_INTERNAL; the comment of a function lists its other codes without the prefix OCEAN_.
// - One thread at a time may use an ocean_sea; several seas run in parallel. A call on a sea that
//   another thread is using returns OCEAN_BUSY; ocean_free() waits for that thread instead.
//   Functions without an ocean_sea may be called from any thread.
// - After fork() the child process may use and free each sea that no thread was using.
// - The rounding and flush-to-zero modes of the calling thread do not change any bit of a result,
//   and no call changes these modes.
// - Times lie within -1e9 .. 1e9 [s]; any other returns OCEAN_INVALID_ARGUMENT or
//   OCEAN_INVALID_VALUE. Up to 1e8 s, maps are accurate to 2e-6 of their rms; at 1e9 s, heights to
//   3e-6 and slopes to 1.2e-5.
// - Texts are UTF-8. Buffers and texts stay the caller's; the library keeps no pointer to them.
// - A text result goes to `out` and ends in a 0 byte. On entry *size is the capacity of `out` in
//   bytes; on return it is the size needed, the 0 byte included. If that exceeds the capacity, the
//   function writes nothing else and returns OCEAN_BUFFER_TOO_SMALL. With out = NULL it only writes
//   *size and returns OCEAN_OK.
// - Options and requests begin with struct_size, their sizeof in the caller's program; the sizes of
//   array elements are members of the request. Members that a shorter struct (of an older header)
//   lacks have their defaults. A longer struct (of a newer header) is accepted if all bytes that
//   this library does not know are 0; else the call returns OCEAN_UNSUPPORTED.
// - Functions, codes, members and enumerators of this header keep their names, numbers and meanings
//   while OCEAN_ABI_VERSION stays the same. *Not* promised from one version of the library to the
//   next: the bits of a map or an answer and its error within the stated bound, the sentences of
//   ocean_last_error(), the order and the set of keys in JSON, how often progress is called, the
//   memory and the time of a call, the defaults of parameters that a text does not name, and all
//   C++ headers.
// - ocean_text() names all parameters that are set, except those that a later version adds: each of
//   these has a neutral value, at which it changes no sea. The neutral value stays its default for
//   ever, and ocean_text() leaves it out. So the text of a sea, and every file identified by that
//   text, stays the same to the byte until the sea uses such a parameter.
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

/* Increases when a change to a struct or a meaning breaks compiled callers. */
#define OCEAN_ABI_VERSION 1

typedef struct ocean_sea ocean_sea;
typedef int32_t ocean_result;

enum {
    OCEAN_OK = 0,
    OCEAN_INVALID_ARGUMENT = 1, /* a NULL, a size or a count of this call */
    OCEAN_INVALID_VALUE = 2,    /* a parameter: unknown, of a wrong type, out of range */
    OCEAN_BAD_FILE = 3,         /* a file that is missing, unreadable or not what it claims */
    OCEAN_NOT_FOUND = 4,        /* a record or preset that does not exist */
    OCEAN_UNSUPPORTED = 5,      /* a feature of a later version */
    OCEAN_OUTPUT = 6,           /* writing failed */
    OCEAN_OUT_OF_MEMORY = 7,
    OCEAN_BUFFER_TOO_SMALL = 8,
    OCEAN_INTERNAL = 9,   /* a fault of the library: please report it */
    OCEAN_CANCELLED = 10, /* stopped by the host's own progress function */
    OCEAN_BUSY = 11       /* another thread is using this sea */
};

/* Channels of a map. A label is an undisplaced point; its displaced point is shown at
 * (x + dx, y + dy, height). Offsets and height in [m], derivatives by label, velocity in [m/s]. */
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
    OCEAN_DX_X, /* derivatives of the offset: d dx/dx, d dy/dy, d dx/dy = d dy/dx */
    OCEAN_DY_Y,
    OCEAN_DX_Y,
    OCEAN_COVER /* share of the water that foam hides, 0 .. 1; average it for distant water */
};

/* Axes in which a vector (x, y, z) is stored: (x, y, z), (x, z, -y) or (x, z, y). */
enum { OCEAN_ZUP, OCEAN_YUP, OCEAN_TNB };

/* Backends. */
enum { OCEAN_CPU, OCEAN_GL, OCEAN_RADIX2, OCEAN_DFT };

/* Where foam begins. OCEAN_FOAM_SETTLED follows it from as far back as it lives, so that a map does
 * not depend on earlier calls. OCEAN_FOAM_EMPTY begins without foam at the first requested time,
 * for live tools, which must not wait. */
enum { OCEAN_FOAM_SETTLED, OCEAN_FOAM_EMPTY };

/* Progress function of a host. The calling thread calls it about 100 times a second while it works.
 * `done` and `total` are ticks of the foam's clock while foam is followed from its beginning, and 0
 * otherwise. A result other than 0 stops the call, which returns OCEAN_CANCELLED within 50 ms: its
 * outputs are then incomplete, and the sea can still be used. The function must not call functions
 * of this sea. */
typedef int32_t (*ocean_progress)(void* user, int64_t done, int64_t total);

/* Runs jobs on a host's own threads in place of the library's: calls job(work, 0) .. job(work,
 * count - 1), in any order, in parallel or one after the other, and returns when all have returned.
 * The progress function is then called by one of these threads at a time. */
typedef void (*ocean_job)(void* work, int32_t index);
typedef void (*ocean_run_jobs)(void* user, ocean_job job, void* work, int32_t count);

/* Options of a sea. Pass struct_size = sizeof(ocean_options); a NULL pointer to the options means
 * all defaults. */
typedef struct {
    size_t struct_size;
    int32_t threads;         /* 0 = the cores this process may use; else 1 .. 1024, the calling
                              * thread included; with run_jobs the max of jobs at once */
    int32_t backend;         /* OCEAN_CPU; OCEAN_RADIX2 and OCEAN_DFT are slow references */
    int32_t foam_start;      /* OCEAN_FOAM_... */
    int32_t reserved;        /* 0 */
    ocean_progress progress; /* may be NULL */
    void* user;              /* passed to progress */
    ocean_run_jobs run_jobs; /* may be NULL */
    void* jobs_user;         /* passed to run_jobs */
} ocean_options;

/* One destination of 1 to 4 interleaved channels of a map of R x R samples. Component c of sample
 * (i, j), which lies i steps east and j steps north, goes to data[j * row_pitch + i * channels +
 * c].
 *
 * `axes` turns whole vectors. Where three neighbouring components are {OCEAN_DX, OCEAN_DY,
 * OCEAN_HEIGHT}, {OCEAN_NX, OCEAN_NY, OCEAN_NZ} or {OCEAN_VX, OCEAN_VY, OCEAN_VZ}, in this order,
 * these three receive, for a vector (x, y, z):
 *
 *     OCEAN_ZUP  (x, y, z)
 *     OCEAN_YUP  (x, z, -y)
 *     OCEAN_TNB  (x, z, y)
 *
 * Every other component is stored unturned. For example, {OCEAN_DX, OCEAN_DY, OCEAN_HEIGHT, -1}
 * with OCEAN_YUP stores dx, height, -dy and leaves the fourth component unchanged. */
typedef struct {
    float* data;
    size_t count;       /* floats in data, at least (R - 1) * row_pitch + R * channels */
    int32_t channel[4]; /* of component c, in z-up terms; -1 = leave the component unchanged */
    int32_t channels;   /* components of a sample, 1 .. 4 */
    int32_t axes;       /* OCEAN_ZUP, OCEAN_YUP or OCEAN_TNB */
    size_t row_pitch;   /* floats from row to row; 0 = R * channels */
    int32_t seam;       /* not 0 = append the first sample to each row and the first row to the map,
                         * one period on: R becomes R + 1 in this struct. 0 = no seam */
    int32_t reserved;   /* 0 */
} ocean_output;

/* A request for maps. Pass struct_size = sizeof(ocean_request) and output_size =
 * sizeof(ocean_output); an output_size of 0 means the members that this header has.
 *
 * cascade = 0 requests the whole sea. cascade = 1, 2 ... requests the small map of one cascade over
 * its own period, for hosts that add cascades while they draw: at any point the sum over all
 * cascades, each wrapped at its own period, is the sea's. Only these channels add up: OCEAN_DX, DY,
 * HEIGHT, SLOPE_X, SLOPE_Y, VX, VY, VZ, DX_X, DY_Y, DX_Y; then jacobian = (1 + DX_X) (1 + DY_Y) -
 * DX_Y^2. */
typedef struct {
    size_t struct_size;
    double time;        /* [s] */
    int32_t resolution; /* samples along a side, a power of two, 32 .. 8192; 0 = the number of
                         * ocean_map_resolution(), for a cascade that of its lattice */
    const ocean_output* outputs;
    size_t output_count;
    size_t output_size;
    int32_t cascade;
    int32_t reserved; /* 0 */
} ocean_request;

/* Returns the OCEAN_ABI_VERSION that the library was built with, to be compared with the header's.
 * Never fails. */
OCEAN_API uint32_t ocean_abi_version(void);
/* Returns the release version, such as "0.1.0". The text lives for ever. */
OCEAN_API const char* ocean_version(void);
/* Returns a sentence that describes the last failed call of this thread; "" before any. The text
 * lives until the next failed call of this thread. */
OCEAN_API const char* ocean_last_error(void);
/* The parts of a failure. */
enum {
    OCEAN_ERROR_WHAT,      /* "is out of range"; the whole sentence if it has no other part */
    OCEAN_ERROR_PARAMETER, /* "waves.0.fetch"; or a member of a request, or an argument */
    OCEAN_ERROR_VALUE,     /* "5", spelled as in the sentence */
    OCEAN_ERROR_ALLOWED    /* "1000 .. 10000000 m" */
};
/* Returns one part of the sentence of ocean_last_error(), so that a host can mark a field or write
 * its own message without parsing the sentence. Returns "" if the failure has no such part and for
 * parts of a later version; never NULL. The wording of OCEAN_ERROR_PARAMETER is promised, that of
 * the other parts is not. The text lives until the next failed call of this thread. Never fails. */
OCEAN_API const char* ocean_last_error_field(int32_t field);

/* Opens a sea file and writes the new sea to *out, to be freed by ocean_free(). options may be
 * NULL. The sea needs neither the file nor the options afterwards. Codes: BAD_FILE, INVALID_VALUE,
 * NOT_FOUND, UNSUPPORTED. */
OCEAN_API ocean_result ocean_open(const char* path, const ocean_options* options, ocean_sea** out);
/* Opens a sea from the `length` bytes of a sea file's text, which need no final 0, and writes it to
 * *out. A relative `file` or `take` in the text is resolved against base_dir; NULL = the current
 * directory. options may be NULL. Codes: BAD_FILE, INVALID_VALUE, NOT_FOUND, UNSUPPORTED. */
OCEAN_API ocean_result ocean_parse(const char* toml, size_t length, const char* base_dir,
                                   const ocean_options* options, ocean_sea** out);
/* Writes to *out a copy of `sea` that another thread can use. The copy shares all that `sea` has
 * computed, until either is changed. options = NULL keeps the options of `sea`. */
OCEAN_API ocean_result ocean_clone(const ocean_sea* sea, const ocean_options* options,
                                   ocean_sea** out);
/* Frees the sea and all memory that it owns. Blocks while a thread is using it. NULL is allowed. */
OCEAN_API void ocean_free(ocean_sea* sea);

/* Sets the parameter `name` ("wind_speed", "waves.1.fetch") from text. The sea becomes another sea,
 * foam included; ocean_perform() changes it over time instead. A refused value changes nothing.
 * Setting `file`, `record` or `place` of a measured system reads the spectrum file again. Codes:
 * INVALID_VALUE, UNSUPPORTED; for those three parameters BAD_FILE and NOT_FOUND too. */
OCEAN_API ocean_result ocean_set(ocean_sea* sea, const char* name, const char* value);
/* Sets the `count` parameters names[i] from the texts values[i] and checks them together, so that
 * values that are valid only in combination can be set at once. Either all are set or none. Codes
 * as ocean_set(). */
OCEAN_API ocean_result ocean_set_all(ocean_sea* sea, const char* const* names,
                                     const char* const* values, size_t count);
/* Inserts a wave system with default values at the position that `name` states ("waves.1"). The
 * systems from there on move up by one number, in the sea's take too. A sea has at most 16 wave
 * systems. Code: INVALID_VALUE. */
OCEAN_API ocean_result ocean_add_waves(ocean_sea* sea, const char* name);
/* Removes the wave system `name` and the events of the sea's take that change it. The last
 * remaining system cannot be removed. Code: INVALID_VALUE. */
OCEAN_API ocean_result ocean_remove_waves(ocean_sea* sea, const char* name);
/* Lets a live parameter glide to `value` from `time` [s] on. The change becomes an event of the
 * sea's own take, which ocean_text() contains, so every frame can be computed again bit by bit.
 * Maps and foam before `time` stay valid and are not computed again. Events of one parameter are at
 * least 1/60 s apart: a value that comes sooner is delayed until then, and the last one replaces
 * the others. INVALID_VALUE, with nothing changed: for a parameter that is not live, a sea with a
 * loop, a time before the last performed event, or a take that is full (32768 events). */
OCEAN_API ocean_result ocean_perform(ocean_sea* sea, double time, const char* name,
                                     const char* value);
/* Writes the value of a parameter as text, with a final 0, to out[size]; "" if it is unset. Codes:
 * INVALID_VALUE; BUFFER_TOO_SMALL, and the sentence of ocean_last_error() states the size needed.
 * */
OCEAN_API ocean_result ocean_get(const ocean_sea* sea, const char* name, char* out, size_t size);

/* Writes the resolved, self-contained sea file: ocean_parse() of it gives the same sea bit by bit.
 * Codes: BUFFER_TOO_SMALL; INVALID_VALUE while parameters that were set one by one contradict each
 * other. */
OCEAN_API ocean_result ocean_text(const ocean_sea* sea, char* out, size_t* size);
/* Writes the parameter table as a JSON array. Code: BUFFER_TOO_SMALL. */
OCEAN_API ocean_result ocean_parameters_json(char* out, size_t* size);
/* Writes the statistics of the sea that `ocean info --json` prints, as a JSON object. Builds the
 * spectrum if needed. Code: BUFFER_TOO_SMALL. */
OCEAN_API ocean_result ocean_state_json(const ocean_sea* sea, char* out, size_t* size);
/* Writes the readable records of a spectrum file as a JSON array. Codes: BAD_FILE,
 * BUFFER_TOO_SMALL. */
OCEAN_API ocean_result ocean_records_json(const char* file, char* out, size_t* size);
/* Writes the sea file of the preset `name` ("beaufort_6"); with name = NULL a JSON array of all
 * names. Codes: NOT_FOUND, BUFFER_TOO_SMALL. */
OCEAN_API ocean_result ocean_preset(const char* name, char* out, size_t* size);
/* Writes Jerlov's optical types of sea water, clearest first, as a JSON array. Each has name
 * ("jerlov_ii"), label, help, ior; absorption and scattering [1/m] and the albedo of the water
 * below its surface, each a list of red, green, blue of linear Rec. 709; anisotropy, the mean
 * cosine of scattering; foam_albedo. Code: BUFFER_TOO_SMALL. */
OCEAN_API ocean_result ocean_water_types_json(char* out, size_t* size);

/* Writes the samples along a side of a map whose request has resolution = 0: grid.resolution for
 * one cascade, up to four times that for several. */
OCEAN_API ocean_result ocean_map_resolution(const ocean_sea* sea, int32_t* resolution);
/* Writes the periods of the sea's cascades [m] to periods[0 ..]. On entry *count is the capacity of
 * `periods`; on return it is the number of cascades. If that exceeds the capacity, the function
 * writes nothing else and returns OCEAN_BUFFER_TOO_SMALL. With periods = NULL it only writes
 * *count. */
OCEAN_API ocean_result ocean_cascade_periods(const ocean_sea* sea, double* periods, size_t* count);
/* Computes all outputs of the request. Blocks. The bits are the same for any number of threads and
 * any order of calls. A request that fails a check writes nothing. OCEAN_FOAM is followed from
 * where it begins, which makes the first map slow, or from the last requested time. Buffers need no
 * alignment; those aligned to 64 bytes are filled fastest. Code: UNSUPPORTED. */
OCEAN_API ocean_result ocean_evaluate(ocean_sea* sea, const ocean_request* request);
/* Writes to *power the exponent p of OCEAN_COVER = OCEAN_FOAM^p on the map of `resolution` samples
 * (0 = ocean_map_resolution()) at `time` [s], for hosts that compute cover from foam themselves.
 * Takes some tenths of a second after a change of waves or wind. Code: CANCELLED. */
OCEAN_API ocean_result ocean_cover_power(ocean_sea* sea, double time, int32_t resolution,
                                         double* power);
/* Writes the displayed surface at n world points xy = x0, y0, x1, y1 ... [m], at any distance from
 * the origin. The displacement is inverted; where crests have folded over, the top sheet counts.
 * Point i receives ten floats from samples + i * stride on, the columns of `ocean query`:
 *
 *     x, y, height, normal x y z (unit, up), velocity x y z (of the displayed point [m/s]),
 *     foam (0 .. 1)
 *
 * stride counts floats: 10 or more, or 9 to leave out the foam, whose past takes far longer than
 * all the rest. n = 0 is allowed. A point that is not finite returns INVALID_ARGUMENT. Heights are
 * accurate to 2e-3 of the rms height or better. The bits are the same for any number of threads.
 * Queries of one time are cheapest one after the other: the sea keeps the maps of the last time. */
OCEAN_API ocean_result ocean_query(ocean_sea* sea, double time, const double* xy, size_t n,
                                   float* samples, size_t stride);
/* Flags of an ocean_sample. */
enum {
    OCEAN_FOLDED = 1,   /* the surface has several sheets here: this is the top one */
    OCEAN_UNDECIDED = 2 /* the search may have missed a sheet: perhaps not the top one */
};
typedef struct {
    float height;      /* [m] */
    float normal[3];   /* unit, up */
    float velocity[3]; /* of the displayed point [m/s] */
    float foam;        /* 0 .. 1; 0 if not requested */
    double label[2];   /* undisplaced point of the surface that is displayed here [m] */
    int32_t flags;     /* OCEAN_FOLDED, OCEAN_UNDECIDED */
    int32_t reserved;
} ocean_sample;

/* A query of points. Pass struct_size = sizeof(ocean_query_request) and sample_size =
 * sizeof(ocean_sample); with a smaller sample_size only the members within it are written. */
typedef struct {
    size_t struct_size;
    double time;      /* [s] */
    const double* xy; /* x0, y0, x1, y1 ... [m] */
    size_t count;
    ocean_sample* samples;
    size_t sample_size;
    int32_t resolution;   /* answer with the waves of a map of so many samples, at a fraction of
                           * the cost; 0 = the sea's own map */
    int32_t refine;       /* 0 or 1; 2, 4 ... = interpolate on finer maps, for smaller errors */
    int32_t exact;        /* not 0 = sum all waves in double precision, 100 times as slow */
    int32_t foam;         /* not 0 = with foam, whose past takes far longer than all the rest */
    double* height_error; /* receives the rms error of the heights against the exact sum over all
                           * waves of the sea [m]; may be NULL */
} ocean_query_request;

/* Writes an ocean_sample for each point of the request. Accuracy and bits as ocean_query(). Code:
 * INVALID_VALUE for a `refine` or `resolution` that is not allowed. */
OCEAN_API ocean_result ocean_query_points(ocean_sea* sea, const ocean_query_request* request);
/* Writes the velocity of the water (x, y, z [m/s]) by linear theory at n fixed world points xy, all
 * at the height z [m] above still water: three floats from velocities + i * stride on, stride 3 or
 * more. Above z = 0 the velocity is that at z = 0; below the bottom it is 0. Points, bits and codes
 * as ocean_query(). */
OCEAN_API ocean_result ocean_orbital_velocity(ocean_sea* sea, double time, double z,
                                              const double* xy, size_t n, float* velocities,
                                              size_t stride);
/* The motion of the water at a fixed point: velocity [m/s] and pressure without the hydrostatic
 * part [Pa], for the sea's water_density. */
typedef struct {
    float velocity[3];
    float pressure;
} ocean_water_sample;

/* A query of points in the water. Pass struct_size = sizeof(ocean_water_request) and sample_size =
 * sizeof(ocean_water_sample). Each point has its own z; each further value of z costs two
 * transforms. resolution, refine and exact mean the same as in ocean_query_request. */
typedef struct {
    size_t struct_size;
    double time;       /* [s] */
    const double* xyz; /* x0, y0, z0, x1 ... [m], z up from still water */
    size_t count;
    ocean_water_sample* samples;
    size_t sample_size;
    int32_t resolution;
    int32_t refine;
    int32_t exact;
    int32_t reserved; /* 0 */
} ocean_water_request;

/* Writes velocity and pressure of the water, by linear theory, at points of any depths. Above z = 0
 * both are those at z = 0; below the bottom they are 0. Codes as ocean_query_points(). */
OCEAN_API ocean_result ocean_water_points(ocean_sea* sea, const ocean_water_request* request);
/* Writes the pose of n floating bodies: each lies on the plane that fits the surface below it best.
 * A pose follows the waves; it is not a computation of forces. bodies: five doubles each, x, y [m],
 * heading [degrees counter-clockwise from +x], length along the heading and width [m], 0 .. 100000.
 * Body i receives eleven floats from poses + i * stride on, stride 11 or more:
 *
 *     position x y z [m], up x y z, forward x y z (unit vectors),
 *     pitch (bow up), roll (port side up) [degrees]
 *
 * Bits and codes as ocean_query(). */
OCEAN_API ocean_result ocean_float_pose(ocean_sea* sea, double time, const double* bodies, size_t n,
                                        float* poses, size_t stride);

/* One band of the waves too short for a map, as a slope map of its own that repeats after `tile`
 * metres. The first band begins at the edge of the square of wavenumbers that the map holds, each
 * other band where the one before it ends, so that no wave appears twice or is missing. The
 * variances are integrals of the spectrum: E[hx^2], E[hy^2], E[hx hy] of the slopes hx = dh/dx, hy
 * = dh/dy by label. */
typedef struct {
    double shortest_wave; /* [m] */
    double longest_wave;  /* [m] */
    double tile;          /* [m] */
    double variance_x;
    double variance_y;
    double covariance;
} ocean_detail_band;

/* A request for slope maps of short waves. Pass struct_size = sizeof(ocean_detail_request),
 * band_size = sizeof(ocean_detail_band) and output_size = sizeof(ocean_output); with a smaller
 * band_size only the members within it are written. outputs[i] receives OCEAN_SLOPE_X and
 * OCEAN_SLOPE_Y of band i, samples x samples; an output without a channel skips its band. */
typedef struct {
    size_t struct_size;
    double time;              /* [s] */
    int32_t resolution;       /* of the displayed map, as in ocean_request */
    int32_t samples;          /* along a side of each tile: 256, 512 or 1024; 0 = 512 */
    ocean_detail_band* bands; /* may be NULL */
    size_t band_count;        /* capacity of bands */
    size_t band_size;
    const ocean_output* outputs; /* may be NULL */
    size_t output_count;         /* at most the number of bands */
    size_t output_size;
} ocean_detail_request;

/* Computes the waves too short for a map, which carry about half of the sea's slopes, as small
 * periodic slope maps of the same sea at the same time, for materials.
 * shaders/wave/slope_tiles.glsl reads them without visible repetition. *count receives the number
 * of bands, 0 to 3, which depends only on the grid and the wavelength limits. If that exceeds
 * band_count, the function writes nothing else and returns OCEAN_BUFFER_TOO_SMALL; with bands =
 * NULL it only writes *count. *residual, if not NULL, receives the mean square slope of the waves
 * shorter than all bands, which are roughness at any distance: map, bands and residual add up to
 * the sea's mean square slope. Like maps, a pure function of sea and time; the bits are the same
 * for any number of threads. Code: INVALID_VALUE for settings out of range. */
OCEAN_API ocean_result ocean_detail(ocean_sea* sea, const ocean_detail_request* request,
                                    size_t* count, double* residual);

/* A particle of spray: a parcel of drops of one size that the wind has torn off a whitecap. It is
 * born within one period of the sea and may then leave it; copies shifted by whole periods are
 * equally valid. */
typedef struct {
    uint64_t id;        /* the same in every frame of its life, in a loop at every repetition */
    double position[3]; /* [m] */
    float velocity[3];  /* d/dt of the position [m/s] */
    float age;          /* since its birth [s] */
    float life;         /* age at which it ends, fixed at its birth [s] */
    float radius;       /* of each of its drops [m] */
} ocean_spray_particle;

/* A request for spray. Pass struct_size = sizeof(ocean_spray_request) and particle_size =
 * sizeof(ocean_spray_particle); with a smaller particle_size only the members within it are
 * written. */
typedef struct {
    size_t struct_size;
    double time;      /* [s] */
    double lifetime;  /* max age of a particle [s], 0.05 .. 10, in a loop at most half of it;
                       * 2 is common */
    double density;   /* particles for each m^2 that turns white, 0 .. 1000; 0.25 is common. Winds
                       * below 11 m/s make fewer, below 7 m/s none */
    int32_t most;     /* approximate max of particles alive at once, 1 .. 100 million; above it they
                       * are thinned evenly over the sea; 1 million is common */
    int32_t reserved; /* 0 */
    ocean_spray_particle* particles;
    size_t particle_count; /* capacity of particles */
    size_t particle_size;
} ocean_spray_request;

/* Writes all particles of spray alive at a time, in an unspecified but reproducible order. *count
 * receives their number; if that exceeds particle_count, the function writes nothing else and
 * returns OCEAN_BUFFER_TOO_SMALL. With particles = NULL it only writes *count. The sea keeps the
 * particles for the next call of the same time, which then only copies them. The first call
 * computes a small map for every tick of the foam's clock within the lifetime; a later time
 * computes only the new ticks and returns the same bits. Code: INVALID_VALUE for settings out of
 * range. */
OCEAN_API ocean_result ocean_spray(ocean_sea* sea, const ocean_spray_request* request,
                                   size_t* count);

/* A request for a foam texture. Pass struct_size = sizeof(ocean_foam_texture_request). data
 * receives size * size values: texel (i, j), whose centre is ((i + 1/2), (j + 1/2)) / size of the
 * tile, goes to data[j * size + i], j up. */
typedef struct {
    size_t struct_size;
    const char* kind; /* "lace" (nets, for a tile of 12 m), "bubbles" (1.3 m), "streaks" (97 m,
                       * along x, to be turned into the wind) */
    int32_t size;     /* texels along a side, a power of two, 64 .. 4096 */
    uint32_t seed;    /* textures of different kinds are independent even with one seed */
    float* data;
    size_t count; /* floats in data */
} ocean_foam_texture_request;

/* Computes a texture of foam that tiles, values 0 .. 1: a point is white where the texture is below
 * the cover there. Its bilinear reads are uniformly distributed, so the share c of the area is
 * below c, to 5e-4 (bubbles: 1e-3 with 128 texels along a side, 6e-3 with 64); low values vanish
 * last. *period receives the side of the tile that the texture is made for [m]; it may be NULL.
 * With data = NULL the function only writes *period. options may be NULL; only threads, progress
 * and run_jobs are used. Codes: INVALID_VALUE for a kind or size that is not allowed,
 * BUFFER_TOO_SMALL, CANCELLED. */
OCEAN_API ocean_result ocean_foam_texture(const ocean_foam_texture_request* request,
                                          const ocean_options* options, double* period);

/* A wave gauge. fixes: four doubles each, time [s], x, y, z [m, z up from still water], ordered by
 * time. The gauge moves straight from one fix to the next; with a single fix it leaves that point
 * at `velocity` [m/s]. */
typedef struct {
    const double* fixes;
    size_t fix_count;
    double velocity[2];
} ocean_gauge;

/* A request for gauge readings at the times start + i / rate up to `end`. Pass struct_size =
 * sizeof(ocean_gauge_request) and gauge_size = sizeof(ocean_gauge). */
typedef struct {
    size_t struct_size;
    double start; /* [s] */
    double end;   /* [s] */
    double rate;  /* [Hz] */
    const ocean_gauge* gauges;
    size_t gauge_count;
    size_t gauge_size;
    double* values;
    size_t value_count; /* doubles in values */
} ocean_gauge_request;

/* Writes the readings of gauges, summed over all waves in double precision; where crests fold,
 * those of the top sheet. Gauge g at time i receives ten doubles from values + (i * gauge_count +
 * g) * 10 on:
 *
 *     time, x, y, elevation [m], slope x y of the displayed surface, velocity x y z of the water at
 *     the gauge's depth [m/s], pressure there without the hydrostatic part [Pa]
 *
 * *times receives the number of times; with values = NULL the function only writes *times. Codes:
 * BUFFER_TOO_SMALL, INVALID_VALUE. */
OCEAN_API ocean_result ocean_gauges(ocean_sea* sea, const ocean_gauge_request* request,
                                    size_t* times);

#ifdef __cplusplus
}
#endif

#endif
