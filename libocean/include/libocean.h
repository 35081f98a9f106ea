// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The C API of libocean: a sea file in, float maps out, for a host in any language. libocean.so
// exports these functions and nothing else.
//
// These rules hold for every function:
// - No exception crosses the border. A function that fails returns a code, leaves its outputs
//   alone and keeps a sentence for ocean_last_error(), and the parts of that sentence for
//   ocean_last_error_field(). Any function may return OCEAN_INVALID_ARGUMENT, OCEAN_OUT_OF_MEMORY
//   and OCEAN_INTERNAL; the comment of a function names its other codes, without OCEAN_.
// - One thread at a time may use an ocean_sea; several seas run in parallel. While a thread is in a
//   sea, a call of another thread returns OCEAN_BUSY, and ocean_free waits. Any thread may call the
//   functions without a sea.
// - A child process may, after fork(), use and free the seas that no thread was in.
// - The rounding and flush-to-zero modes of the calling thread change no bit, and no call changes
//   these modes.
// - Times range from -1e9 to 1e9 s; others are OCEAN_INVALID_ARGUMENT or OCEAN_INVALID_VALUE. Maps
//   are within 2e-6 of their rms until 1e8 s; at 1e9 s heights within 3e-6, slopes within 1.2e-5.
// - Texts are UTF-8. Buffers and texts belong to the caller; the library does not keep them.
// - A text result goes to `out`, with a final 0. Pass *size = capacity of out [bytes]; *size
//   becomes the size needed, the final 0 included. If that exceeds the capacity, the function
//   writes nothing to out and returns OCEAN_BUFFER_TOO_SMALL. With out = NULL it returns the size
//   alone, and OCEAN_OK.
// - A struct opens with struct_size, its size where the caller was compiled. In a shorter one (of
//   an older header) the missing members have their defaults, where they have any; a longer one (of
//   a newer header) is accepted if the part unknown to this library is all 0, else the call returns
//   OCEAN_UNSUPPORTED.
// - Functions, codes, members and enumerators of this header keep their names, numbers and meaning
//   while OCEAN_ABI_VERSION stays. From one version of the library to the next these may change:
//   the bits of a map or an answer (their errors stay within the limits given here), the sentences
//   of ocean_last_error, the order and the set of keys in JSON, how often progress is called, the
//   memory and time that a call takes, the defaults of parameters that a text does not name, and
//   everything in the C++ headers.
// - ocean_text names every parameter that is set, except those that a later version adds: each of
//   these has a neutral value, at which it changes no sea. That value stays its default for ever,
//   and ocean_text leaves it out. So the text of a sea stays the same to the byte until the sea
//   uses such a parameter, and so does every file that is identified by that text.
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

/* Increases when a change of a struct or of a meaning breaks compiled callers. */
#define OCEAN_ABI_VERSION 1

typedef struct ocean_sea ocean_sea;
typedef struct ocean_terrain ocean_terrain;
typedef int32_t ocean_result;

enum {
    OCEAN_OK = 0,
    OCEAN_INVALID_ARGUMENT = 1, /* a NULL, a size or a count of this call */
    OCEAN_INVALID_VALUE = 2,    /* a parameter: unknown, of a wrong type or out of range */
    OCEAN_BAD_FILE = 3,         /* a file that is missing, unreadable or of another format */
    OCEAN_NOT_FOUND = 4,        /* a record or preset that does not exist */
    OCEAN_UNSUPPORTED = 5,      /* a feature of a later version */
    OCEAN_OUTPUT = 6,           /* writing failed */
    OCEAN_OUT_OF_MEMORY = 7,
    OCEAN_BUFFER_TOO_SMALL = 8,
    OCEAN_INTERNAL = 9,   /* a fault of the library: please report it */
    OCEAN_CANCELLED = 10, /* the host's own progress function ended the call */
    OCEAN_BUSY = 11       /* another thread is in this sea */
};

/* Channels. dx, dy: offsets of the displaced point [m]. Slopes are derivatives by label, the
 * undisplaced coordinate. Velocities are in [m/s]. */
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
    OCEAN_DX_X, /* derivatives of the offset by label: d dx/dx; then d dy/dy, d dx/dy = d dy/dx */
    OCEAN_DY_Y,
    OCEAN_DX_Y,
    OCEAN_COVER, /* the share of the water that foam hides; its mean is the foam seen from afar */
    /* Masks of terrains whose files have the section that makes them, and of seas over a bed; no
     * other sea has them. */
    OCEAN_WEAR = 40, /* floors of gullies -1 .. crests 1: [terrain.gullies] */
    OCEAN_GULLY,     /* 0 .. 1 */
    OCEAN_RIDGE,     /* 0 .. 1 */
    OCEAN_FLOW,      /* area that drains through the place [m2]: [terrain.stream] */
    OCEAN_DEPOSIT,   /* 0 .. 1 */
    OCEAN_STREAMBED, /* 0 .. 1 */
    OCEAN_WETNESS,   /* 0 .. 1 */
    OCEAN_BEACH,     /* 0 .. 1: [terrain.coast] */
    OCEAN_CLIFF,     /* 0 .. 1 */
    OCEAN_SHELTER,   /* 0 .. 1 */
    OCEAN_DEPTH,     /* of a sea over a bed: height of the water over it, below 0 where dry [m] */
    OCEAN_BREAKING,  /* of a sea over a bed: fronts of waves that break by the depth, 0 .. 1 */
    OCEAN_TRAIL,     /* of a sea with hulls: white water behind them, 0 .. 1 */
    OCEAN_DRY        /* of a sea with hulls: 1 inside their water lines, 0.5 on them, 0 outside */
};

/* Axes in which a vector (x, y, z) is stored: (x, y, z), (x, z, -y) or (x, z, y). */
enum { OCEAN_ZUP, OCEAN_YUP, OCEAN_TNB };

/* Backends. */
enum { OCEAN_CPU, OCEAN_GL, OCEAN_RADIX2, OCEAN_DFT };

/* Where the library begins to follow foam. SETTLED: as far back as foam lives, so that a map does
 * not depend on the maps requested before. EMPTY: without foam at the first time requested, for
 * live tools, which do not wait. */
enum { OCEAN_FOAM_SETTLED, OCEAN_FOAM_EMPTY };

/* The library calls this from the thread that called the library, about a hundred times a second
 * while it works. While it follows foam from its beginning, done and total are ticks; while it
 * builds a land with gullies, streams or a shore, or follows the waves over the bed of a sea,
 * thousandths of the present step of that and 1000; otherwise both are 0. A result other than 0
 * ends the call, which returns OCEAN_CANCELLED within 50 ms. Outputs of that call are unfinished
 * then; the sea stays usable. The function must not call functions of this sea. */
typedef int32_t (*ocean_progress)(void* user, int64_t done, int64_t total);

/* Replaces the library's threads by the host's: runs job(work, 0) .. job(work, count - 1), in any
 * order, in parallel or one after the other, and returns when all jobs have returned. progress is
 * then called by one of these threads at a time. */
typedef void (*ocean_job)(void* work, int32_t index);
typedef void (*ocean_run_jobs)(void* user, ocean_job job, void* work, int32_t count);

/* struct_size = sizeof(ocean_options). threads: 0 = one for each core that this process may use,
 * else 1 .. 1024, the caller's own included; with run_jobs the max number of jobs that run at once.
 * backend: OCEAN_CPU; OCEAN_RADIX2 and OCEAN_DFT are the slow references. */
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

/* One destination of 1 to 4 interleaved channels. Sample (i, j) lies i steps east and j steps north
 * of the first one; its component c is data[j * row_pitch + i * channels + c]. A map has R x R
 * samples. row_pitch: floats from row to row, 0 = R * channels. seam: not 0 = each row has one
 * sample more and the map one row more, which repeat the first ones a period on; R is then one more
 * everywhere in this comment. count: floats in data, min (R - 1) * row_pitch + R * channels.
 * channel[c], c < channels, is the channel of component c, in z-up terms; -1 leaves the component
 * as it is. axes turns whole vectors: where three neighbouring components are {OCEAN_DX, OCEAN_DY,
 * OCEAN_HEIGHT}, {OCEAN_NX, OCEAN_NY, OCEAN_NZ} or {OCEAN_VX, OCEAN_VY, OCEAN_VZ}, in this order,
 * they receive for a vector (x, y, z):
 *
 *     OCEAN_ZUP  (x, y, z)
 *     OCEAN_YUP  (x, z, -y)
 *     OCEAN_TNB  (x, z, y)
 *
 * Every other component is stored unchanged, whatever the axes. So {OCEAN_DX, OCEAN_DY,
 * OCEAN_HEIGHT, -1} with OCEAN_YUP stores dx, height, -dy and leaves the fourth component. */
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

/* struct_size = sizeof(ocean_request), output_size = sizeof(ocean_output); output_size 0 = the size
 * in a header whose ocean_request has as many members as the caller's. time [s]. resolution: 0 =
 * that of ocean_map_resolution, else a power of two, 32 .. 8192. cascade: 0 = the whole sea; 1 .. =
 * the small map of one cascade over its own period, for hosts that add the cascades while they
 * draw: at any point the sum over the cascades, each wrapped round its own period, is the sea's
 * value. These channels add up: OCEAN_DX, DY, HEIGHT, SLOPE_X, SLOPE_Y, VX, VY, VZ, DX_X, DY_Y,
 * DX_Y; jacobian = (1 + DX_X) (1 + DY_Y) - DX_Y^2. For a cascade, resolution 0 = that of its
 * lattice. */
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

/* ocean_abi_version returns the OCEAN_ABI_VERSION that the library was built with: compare it with
 * the header's. Never fails. */
OCEAN_API uint32_t ocean_abi_version(void);
/* ocean_version returns the library's version, "0.1.0". The text lives for ever. */
OCEAN_API const char* ocean_version(void);
/* ocean_last_error returns the sentence of this thread's last failed call; "" before any failure.
 * The text lives until the next failed call of this thread. */
OCEAN_API const char* ocean_last_error(void);
/* The parts of a failure. */
enum {
    OCEAN_ERROR_WHAT,      /* "is out of range"; the whole sentence if it has no other part */
    OCEAN_ERROR_PARAMETER, /* "waves.0.fetch"; also a member of a request or an argument */
    OCEAN_ERROR_VALUE,     /* "5", as the sentence shows it */
    OCEAN_ERROR_ALLOWED    /* "1000 .. 10000000 m" */
};
/* ocean_last_error_field returns one part of the sentence of ocean_last_error(), so that a host can
 * mark a field or use its own words without parsing the sentence. It returns "" if the failure has
 * no such part, and for a part of a later version; never NULL. The parameter of a failure is
 * promised, the words of its other parts are not. The text lives until the next failed call of this
 * thread. Never fails. */
OCEAN_API const char* ocean_last_error_field(int32_t field);

/* ocean_open opens the sea file at `path`. options may be NULL. The caller frees *out by
 * ocean_free; the sea needs neither the file nor the options after this call. BAD_FILE,
 * INVALID_VALUE, NOT_FOUND, UNSUPPORTED. */
OCEAN_API ocean_result ocean_open(const char* path, const ocean_options* options, ocean_sea** out);
/* ocean_parse opens a sea file from its text of `length` bytes, without a final 0. base_dir: the
 * folder that a relative `file` in the text starts from, NULL = the current directory. options may
 * be NULL. The caller frees *out by ocean_free. BAD_FILE, INVALID_VALUE, NOT_FOUND, UNSUPPORTED. */
OCEAN_API ocean_result ocean_parse(const char* toml, size_t length, const char* base_dir,
                                   const ocean_options* options, ocean_sea** out);
/* ocean_clone makes a second handle of the same sea, for another thread. Both share the data that
 * `sea` has built until either is changed. options: NULL = those of `sea`. The caller frees *out by
 * ocean_free. */
OCEAN_API ocean_result ocean_clone(const ocean_sea* sea, const ocean_options* options,
                                   ocean_sea** out);
/* ocean_free frees the sea and all its memory; waits for a thread that is in it. NULL is allowed.
 */
OCEAN_API void ocean_free(ocean_sea* sea);

/* ocean_set sets the parameter `name` ("wind_speed", "waves.1.fetch") from text. A refused value
 * changes nothing. `file`, `record` and `place` of a measured system, and `seabed` and
 * `seabed_unit` read the file again. INVALID_VALUE, UNSUPPORTED; BAD_FILE and NOT_FOUND for
 * these. */
OCEAN_API ocean_result ocean_set(ocean_sea* sea, const char* name, const char* value);
/* ocean_set_all sets several parameters, names[i] from values[i], and checks them together: either
 * all of them change or none, so that values can change that are only valid together. Codes as
 * ocean_set. */
OCEAN_API ocean_result ocean_set_all(ocean_sea* sea, const char* const* names,
                                     const char* const* values, size_t count);
/* ocean_add_waves inserts a wave system with default values as `name`, "waves.1". The systems from
 * that number on are renumbered one higher, also in the sea's take. Max 16 systems. INVALID_VALUE.
 */
OCEAN_API ocean_result ocean_add_waves(ocean_sea* sea, const char* name);
/* ocean_remove_waves removes the wave system `name` and the take's events of it. The last system
 * cannot be removed. INVALID_VALUE. */
OCEAN_API ocean_result ocean_remove_waves(ocean_sea* sea, const char* name);
/* ocean_set_bed gives the sea a bed, on which its waves change near a coast: heights over still
 * water [m], positive up, row-major from the south, nx of a row from the west, 2 .. 8192 a side,
 * `cell` [m] apart both ways; (x0, y0) [m] is the place of the first one in the sea. The heights
 * are copied. It takes the place of `seabed` and sets its unit, sign and level to those of such
 * heights; `seabed_origin` and `level` move it from then on. ocean_text holds a bed of up to 1 MB,
 * and of a larger one its hash alone, with which no text opens. NULL heights with nx = ny = 0
 * remove the bed, also that of a file. INVALID_VALUE, with nothing changed: a side longer than 100
 * km, heights that are no number or beyond 100 km; UNSUPPORTED for a sea that plays a take. Its
 * surface does not repeat: ocean_region has its maps, queries and gauges find it as any other. */
OCEAN_API ocean_result ocean_set_bed(ocean_sea* sea, const float* heights, int32_t nx, int32_t ny,
                                     double x0, double y0, double cell);
/* ocean_perform lets the live parameter `name` glide to `value` from `time` [s] on, while the sea
 * is shown. It adds an event to the sea's own take, which ocean_text then holds, so that every
 * frame can be made again in every bit. Everything before that time stays, foam included, and is
 * not computed again. Of values of one parameter that follow each other within 1/60 s the last one
 * counts, at the end of that interval. ocean_set, in contrast, makes another sea. INVALID_VALUE,
 * with nothing changed: a parameter that is not live, a sea with a loop, a time before the last
 * event, a take that is full (32768 events). UNSUPPORTED for a sea with a bed. */
OCEAN_API ocean_result ocean_perform(ocean_sea* sea, double time, const char* name,
                                     const char* value);
/* ocean_get writes the value of the parameter `name` as text to out[size], with a final 0; "" for
 * an optional parameter that is not set. INVALID_VALUE; BUFFER_TOO_SMALL, whose sentence says the
 * size needed. */
OCEAN_API ocean_result ocean_get(const ocean_sea* sea, const char* name, char* out, size_t size);

/* ocean_text writes the resolved sea file, which needs no other file: ocean_parse of it gives the
 * same sea in every bit. BUFFER_TOO_SMALL; INVALID_VALUE while values that ocean_set accepted one
 * by one contradict each other. */
OCEAN_API ocean_result ocean_text(const ocean_sea* sea, char* out, size_t* size);
/* ocean_values_json writes every parameter of the sea, a JSON object of texts: "grid.resolution":
 * "512", "waves.0.fetch": "1e+05"; "" for a parameter that is not set. Further members hold
 * the lines of tables that the resolved file carries beside its parameters: "[take]",
 * "[waves.0.measured_record]", "[water.bed_heights]" and "[water.bed_terrain]". For hosts that keep
 * a sea in properties of their own; ocean_text_of_values is the inverse. BUFFER_TOO_SMALL;
 * INVALID_VALUE as ocean_text. */
OCEAN_API ocean_result ocean_values_json(const ocean_sea* sea, char* out, size_t* size);
/* ocean_text_of_values writes a sea file that sets names[i] to values[i]. Names are those of
 * ocean_values_json or ocean_set. The file has the order of the parameter table and spells each
 * value as given, so that equal values give equal bytes. Empty values are left out, and the neutral
 * values of later parameters. No value is checked: ocean_parse of the text does that.
 * BUFFER_TOO_SMALL; INVALID_VALUE for an unknown name, a number with a line break, a text that is
 * not UTF-8. */
OCEAN_API ocean_result ocean_text_of_values(const char* const* names, const char* const* values,
                                            size_t count, char* out, size_t* size);
/* ocean_parameters_json writes the parameter table, a JSON array. BUFFER_TOO_SMALL. */
OCEAN_API ocean_result ocean_parameters_json(char* out, size_t* size);
/* ocean_state_json writes the output of `ocean info --json`, a JSON object. Builds the spectrum if
 * it is not built yet. BUFFER_TOO_SMALL. */
OCEAN_API ocean_result ocean_state_json(const ocean_sea* sea, char* out, size_t* size);
/* ocean_records_json writes the readable records of a spectrum file, a JSON array. BAD_FILE,
 * BUFFER_TOO_SMALL. */
OCEAN_API ocean_result ocean_records_json(const char* file, char* out, size_t* size);
/* ocean_preset writes the sea file of a preset ("beaufort_6"); with name = NULL the names of all
 * presets, a JSON array. NOT_FOUND, BUFFER_TOO_SMALL. */
OCEAN_API ocean_result ocean_preset(const char* name, char* out, size_t* size);
/* ocean_water_types_json writes Jerlov's optical types of sea water, clearest first, a JSON array:
 * name ("jerlov_ii"), label, help, ior; absorption and scattering [1/m], albedo of the water below
 * its surface, each a list of red, green, blue of linear Rec. 709; anisotropy, the mean cosine of
 * scattering; foam_albedo. BUFFER_TOO_SMALL. */
OCEAN_API ocean_result ocean_water_types_json(char* out, size_t* size);

/* ocean_time_of_frame stores the sea's time at a frame in *time [s]: start + (frame - first_frame)
 * / fps, of the sea's parameters. The frame may lie between two whole ones. */
OCEAN_API ocean_result ocean_time_of_frame(const ocean_sea* sea, double frame, double* time);

/* ocean_map_resolution stores the samples per side of a map whose request has resolution 0:
 * grid.resolution, and up to four times that for several cascades. */
OCEAN_API ocean_result ocean_map_resolution(const ocean_sea* sea, int32_t* resolution);
/* ocean_cascade_periods stores the periods of the sea's cascades [m] in periods[0 ..]. Pass *count
 * = room in periods; *count becomes the number of cascades. If that exceeds the room, the function
 * stores no period and returns OCEAN_BUFFER_TOO_SMALL. periods = NULL requests the count alone. */
OCEAN_API ocean_result ocean_cascade_periods(const ocean_sea* sea, double* periods, size_t* count);
/* ocean_evaluate computes all outputs of the request together, with the same bits for any number of
 * threads and any order of calls. Blocks. A request that fails a check writes nothing. For
 * OCEAN_FOAM the library follows foam from its beginning, which takes a while for the first map, or
 * from the time of the last request. Buffers need no alignment; the library fills those aligned to
 * 64 bytes fastest. UNSUPPORTED. */
OCEAN_API ocean_result ocean_evaluate(ocean_sea* sea, const ocean_request* request);
/* ocean_cover_power stores in *power the exponent that turns foam into cover in a map of `time`
 * [s]: OCEAN_COVER = OCEAN_FOAM ^ power, for hosts that derive one from the other. resolution: of
 * the map, 0 = that of ocean_map_resolution. Takes some tenths of a second after a change of waves
 * or wind. CANCELLED. */
OCEAN_API ocean_result ocean_cover_power(ocean_sea* sea, double time, int32_t resolution,
                                         double* power);
/* ocean_query finds the shown surface at n world points, xy = x0, y0, x1, y1 ... [m], at any
 * distance from the origin. It inverts the displacement; where crests have folded over it takes the
 * top sheet. Point i receives ten floats from samples + i * stride on, those of `ocean query`:
 *     x, y, height [m], normal x y z (unit, up), velocity x y z of the shown point [m/s], foam
 *     (0 .. 1)
 * stride counts floats, min 10; or 9 to leave out the foam, whose past takes far longer than all
 * the rest. n = 0 is allowed. Points that are not finite are INVALID_ARGUMENT. Heights are good to
 * 2e-3 of the rms height or better, with the same bits for any number of threads. Ask for the
 * points of one time in successive calls: the library keeps what the first of them computes. */
OCEAN_API ocean_result ocean_query(ocean_sea* sea, double time, const double* xy, size_t n,
                                   float* samples, size_t stride);
/* Flags of a point of ocean_query_points. */
enum {
    OCEAN_FOLDED = 1,   /* several sheets lie above the point: this is the top one */
    OCEAN_UNDECIDED = 2 /* so folded that not all sheets were found: perhaps not the top one */
};
typedef struct {
    float height;      /* [m] */
    float normal[3];   /* unit, up */
    float velocity[3]; /* of the shown point [m/s] */
    float foam;        /* 0 .. 1, 0 if it was not requested */
    double label[2];   /* undisplaced coordinate of the shown point [m] */
    int32_t flags;     /* OCEAN_FOLDED, OCEAN_UNDECIDED */
    int32_t reserved;
} ocean_sample;

/* struct_size = sizeof(ocean_query_request), sample_size = sizeof(ocean_sample): a smaller one has
 * fewer members filled. resolution: counts the waves that a map of that resolution holds and no
 * others, for answers that cost a fraction; 0 = all waves of the sea's own map. refine: 0 or 1, or
 * 2, 4 ... for smaller errors. exact: not 0 = the sum over all waves in double precision, a hundred
 * times as slow. foam: not 0 = with foam, whose past takes far longer than all the rest.
 * height_error: NULL, or receives the rms difference of the heights from the exact sum over all
 * waves of the sea [m]. */
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

/* ocean_query_points finds the shown surface at world points, as ocean_query does, and fills every
 * member of ocean_sample. INVALID_VALUE for a refine or a resolution that is not allowed. */
OCEAN_API ocean_result ocean_query_points(ocean_sea* sea, const ocean_query_request* request);
/* ocean_orbital_velocity computes the velocity of the water by linear theory at n fixed world
 * points z metres above still water: three floats x, y, z [m/s] from velocities + i * stride on,
 * stride min
 * 3. Above z = 0 the velocity is that of z = 0, below the bottom it is 0. Points, errors and
 * threads as in ocean_query. */
OCEAN_API ocean_result ocean_orbital_velocity(ocean_sea* sea, double time, double z,
                                              const double* xy, size_t n, float* velocities,
                                              size_t stride);
/* The motion of the water at a point: velocity [m/s], and pressure without the hydrostatic part
 * [Pa], by the sea's water_density. */
typedef struct {
    float velocity[3];
    float pressure;
} ocean_water_sample;

/* struct_size = sizeof(ocean_water_request), sample_size = sizeof(ocean_water_sample). Each point
 * has its own z; each distinct z costs two transforms. resolution, refine, exact: as in
 * ocean_query_request. */
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

/* ocean_water_points computes velocity and pressure of the water at points of any depths, by linear
 * theory as ocean_orbital_velocity does. INVALID_VALUE for a refine or a resolution that is not
 * allowed. */
OCEAN_API ocean_result ocean_water_points(ocean_sea* sea, const ocean_water_request* request);
/* ocean_float_pose lays n floating bodies on the sea: each on the plane that best fits the surface
 * below it. bodies: five doubles each, x, y [m], heading [degrees counter-clockwise from +x],
 * length along the heading and width [m], 0 .. 100000. Body i receives eleven floats from poses + i
 * * stride on, stride min 11: position x y z [m], up x y z, forward x y z (units), pitch (bow up),
 * roll (port side up) [degrees] Errors, threads and times as in ocean_query. */
OCEAN_API ocean_result ocean_float_pose(ocean_sea* sea, double time, const double* bodies, size_t n,
                                        float* poses, size_t stride);

/* One band of the waves too short for a map: a slope map of its own over `tile` [m], which holds
 * the waves of shortest_wave .. longest_wave [m]. The first band begins at the edge of the map's
 * square of wavenumbers: no wave is in both, none in neither. variance_x, variance_y, covariance:
 * E[hx^2], E[hy^2], E[hx hy] of its slopes hx = dh/dx, hy = dh/dy by label, the integral of the
 * spectrum. mean_square: the mean of hx^2 + hy^2 over this frame's map as a bilinear reader finds
 * it, within some percent of variance_x + variance_y; 0 without an output that holds both slopes.
 */
typedef struct {
    double shortest_wave; /* [m] */
    double longest_wave;  /* [m] */
    double tile;          /* [m] */
    double variance_x;
    double variance_y;
    double covariance;
    double mean_square;
} ocean_detail_band;

/* struct_size = sizeof(ocean_detail_request), band_size = sizeof(ocean_detail_band): a smaller one
 * has fewer members filled; output_size = sizeof(ocean_output). resolution: of the map that the
 * host shows, as in ocean_request. samples: per side of each tile, 0 = 512, else 256, 512 or 1024.
 * outputs[i]: the map of band i, samples x samples, of OCEAN_SLOPE_X and OCEAN_SLOPE_Y; an output
 * without a channel leaves its band out. */
typedef struct {
    size_t struct_size;
    double time;              /* [s] */
    int32_t resolution;       /* of the displayed map, as in ocean_request */
    int32_t samples;          /* along a side of each tile: 256, 512 or 1024; 0 = 512 */
    ocean_detail_band* bands; /* may be NULL */
    size_t band_count;        /* capacity of bands */
    size_t band_size;
    const ocean_output* outputs; /* may be NULL */
    size_t output_count;         /* max: the number of bands */
    size_t output_size;
} ocean_detail_request;

/* ocean_detail computes the waves too short for a map, about half of the sea's slopes, as small
 * periodic slope maps of the same sea at the same time, for materials;
 * shaders/wave/slope_tiles.glsl reads them without visible repetition. *count receives the number
 * of bands, 0 to 3, which follows from the grid and the limits of wavelengths alone. If it exceeds
 * the room in bands, the function writes nothing else and returns OCEAN_BUFFER_TOO_SMALL; bands =
 * NULL requests the count alone. *residual, if not NULL, receives the mean square slope of the
 * waves shorter than all bands, which are roughness at any distance: map, bands and residual
 * together have the sea's. The maps are a pure function of sea and time, with the same bits for any
 * number of threads. INVALID_VALUE for settings out of range. */
OCEAN_API ocean_result ocean_detail(ocean_sea* sea, const ocean_detail_request* request,
                                    size_t* count, double* residual);

/* struct_size = sizeof(ocean_provenance_request), band_size = sizeof(ocean_detail_band). frame: the
 * number in the file's name. time: of the frame [s], that of ocean_time_of_frame or the host's own.
 * field: the product in the file, "displacement", "cover", "detail1" ...; NULL = leave out the
 * strings about a product. axes: OCEAN_ZUP, OCEAN_YUP or OCEAN_TNB, the order of the file's
 * vectors. The other members describe slope tiles ("detail1" ..): resolution: of the map beside
 * them, 0 = that of ocean_map_resolution; band: NULL, or the tile's band of ocean_detail; residual:
 * that of ocean_detail. */
typedef struct {
    size_t struct_size;
    double time;
    int32_t frame;
    int32_t axes;
    const char* field;
    const ocean_detail_band* band;
    size_t band_size;
    double residual;
    int32_t resolution;
    int32_t reserved; /* 0 */
} ocean_provenance_request;

/* ocean_provenance_json writes the strings by which `ocean bake` labels a file of one frame, a JSON
 * object of texts: ocean:sea (the resolved sea file), frame, time [s], period [m], backend,
 * version; of a product ocean:axes, field, unit; of a slope tile ocean:map_resolution, and with its
 * band tile, longest_wave, shortest_wave [m], slope_variance, slope_residual. A host that puts them
 * into the headers of its own files makes files that all libocean tools read back.
 * BUFFER_TOO_SMALL; INVALID_VALUE as ocean_text. */
OCEAN_API ocean_result ocean_provenance_json(const ocean_sea* sea,
                                             const ocean_provenance_request* request, char* out,
                                             size_t* size);

/* A particle of spray: a parcel of drops of one size that the wind has torn off where the sea
 * turned white. It is born within one period of the sea and may leave that period; copies of it a
 * period away are equally valid. */
typedef struct {
    uint64_t id;        /* constant from birth to end, and in every turn of a loop */
    double position[3]; /* [m] */
    float velocity[3];  /* d/dt of position [m/s] */
    float age;          /* since its birth [s] */
    float life;         /* the age at which it ends [s], known from its birth */
    float radius;       /* of each of its drops [m] */
} ocean_spray_particle;

/* struct_size = sizeof(ocean_spray_request), particle_size = sizeof(ocean_spray_particle): a
 * smaller one has fewer members filled. lifetime: the max age [s], 0.05 .. 10, in a loop max half
 * of the loop; 2 is a good default. density: particles per m^2 that turns white, 0 .. 1000; 0.25 is
 * a good default. Winds below 11 m/s tear off fewer, below 7 m/s none. most: about the max number
 * alive at once, 1 .. 100 million; a larger number is thinned evenly all over the sea. 1 million is
 * a good default. */
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
    double region[4]; /* x0, y0, x1, y1 [m], at least 1 m apart, of a part of a sea with hulls,
                       * whose wakes throw spray too; all 0: one period of the open sea */
} ocean_spray_request;

/* ocean_spray writes all particles alive at `time`, in an unspecified but reproducible order.
 * *count receives their number. If it exceeds the room in particles, the function writes nothing
 * else and returns OCEAN_BUFFER_TOO_SMALL; particles = NULL requests the count alone. The sea keeps
 * the particles it has counted: the next call, with room for them, copies them. The first call
 * computes a small map for every tick of the foam's clock within the lifetime; a later time
 * computes the new ticks only, and has the same bits. The spray of a region is born within it on
 * cells of its own, has no copies, and is that of `ocean bake --region` for a region of whole
 * cells; over a bed it is always that of the whole bed. INVALID_VALUE for settings out of range,
 * UNSUPPORTED for a region of a sea without a bed and hulls. */
OCEAN_API ocean_result ocean_spray(ocean_sea* sea, const ocean_spray_request* request,
                                   size_t* count);

/* struct_size = sizeof(ocean_foam_texture_request). kind: "lace" (nets, made for a tile of 12 m),
 * "bubbles" (1.3 m) or "streaks" (97 m, along x; turn x into the wind). size: texels per side, a
 * power of two, 64 .. 4096. seed: kinds of one seed are independent of each other. data receives
 * size * size values: texel (i, j), whose middle is (i + 1/2, j + 1/2) / size of the tile, goes to
 * data[j * size + i], j up. count: floats in data. */
typedef struct {
    size_t struct_size;
    const char* kind; /* "lace" (nets, for a tile of 12 m), "bubbles" (1.3 m), "streaks" (97 m,
                       * along x, to be turned into the wind) */
    int32_t size;     /* texels along a side, a power of two, 64 .. 4096 */
    uint32_t seed;    /* textures of different kinds are independent even with one seed */
    float* data;
    size_t count; /* floats in data */
} ocean_foam_texture_request;

/* ocean_foam_texture writes a texture of foam that tiles, values 0 .. 1: a place is white where its
 * value is below the cover at that place. Bilinear reads of it are uniform, so that a share c of
 * the area is below c, to 5e-4 (bubbles: to 1e-3 with 128 texels per side, to 6e-3 with 64); low
 * values are the last to vanish. *period receives the side of the tile that the texture is made for
 * [m]. period may be NULL, and so may data, which requests the period alone. options may be NULL;
 * its threads, progress and run_jobs count. INVALID_VALUE for a kind or size that is not allowed,
 * BUFFER_TOO_SMALL, CANCELLED. */
OCEAN_API ocean_result ocean_foam_texture(const ocean_foam_texture_request* request,
                                          const ocean_options* options, double* period);

/* A wave gauge and its track. fixes: four doubles each, time [s], x, y, z [m, up from still water],
 * in order of time; the gauge goes straight from one fix to the next. With a single fix it leaves
 * that place at `velocity` [m/s]. */
typedef struct {
    const double* fixes;
    size_t fix_count;
    double velocity[2];
} ocean_gauge;

/* struct_size = sizeof(ocean_gauge_request), gauge_size = sizeof(ocean_gauge). Gauges are read at
 * the times start + i / rate [s, Hz], up to `end`. */
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

/* ocean_gauges computes the readings of gauges by sums over all waves in double precision; where
 * crests fold it reads the top sheet. Gauge g at time i receives ten doubles from values + (i *
 * gauge_count + g) * 10 on:
 *     time [s], x, y [m], elevation [m], slope x y of the shown surface, velocity of the water at
 * the gauge's depth x y z [m/s], pressure there without the hydrostatic part [Pa] *times receives
 * the number of times; values = NULL requests that number alone. BUFFER_TOO_SMALL, INVALID_VALUE.
 */
OCEAN_API ocean_result ocean_gauges(ocean_sea* sea, const ocean_gauge_request* request,
                                    size_t* times);

/* Terrains. An ocean_terrain obeys the rules of an ocean_sea at the top of this header. Its surface
 * does not move and is not displaced: it has OCEAN_HEIGHT, OCEAN_NX .. NZ, OCEAN_SLOPE_X and
 * OCEAN_SLOPE_Y; other channels are UNSUPPORTED. It repeats after terrain.patch_size. */

/* ocean_terrain_open opens the terrain file at `path`. options may be NULL; foam_start has no
 * effect. The caller frees *out by ocean_terrain_free. BAD_FILE, INVALID_VALUE. */
OCEAN_API ocean_result ocean_terrain_open(const char* path, const ocean_options* options,
                                          ocean_terrain** out);
/* ocean_terrain_parse opens a terrain file from its text of `length` bytes, without a final 0.
 * base_dir: the folder that a relative `measured` in the text starts from, NULL = the current
 * directory. options may be NULL. The caller frees *out by ocean_terrain_free. BAD_FILE,
 * INVALID_VALUE. */
OCEAN_API ocean_result ocean_terrain_parse(const char* toml, size_t length, const char* base_dir,
                                           const ocean_options* options, ocean_terrain** out);
/* ocean_terrain_clone makes a second handle of the same terrain, for another thread. Both share the
 * data that `terrain` has built until either is changed. options: NULL = those of `terrain`. The
 * caller frees *out by ocean_terrain_free. */
OCEAN_API ocean_result ocean_terrain_clone(const ocean_terrain* terrain,
                                           const ocean_options* options, ocean_terrain** out);
/* ocean_terrain_free frees the terrain and all its memory; waits for a thread that is in it. NULL
 * is allowed. */
OCEAN_API void ocean_terrain_free(ocean_terrain* terrain);
/* ocean_terrain_set sets the parameter `name` ("beta", "terrain.layer.0.gain") from text. A refused
 * value changes nothing. The next call redoes only what the parameter changes: `mean` nothing,
 * `beta` and most others the filter, `seed` and `resolution` the noise too. INVALID_VALUE; BAD_FILE
 * for `measured`. */
OCEAN_API ocean_result ocean_terrain_set(ocean_terrain* terrain, const char* name,
                                         const char* value);
/* ocean_terrain_set_all sets several parameters, names[i] from values[i], and checks them together:
 * either all of them change or none. Codes as ocean_terrain_set. */
OCEAN_API ocean_result ocean_terrain_set_all(ocean_terrain* terrain, const char* const* names,
                                             const char* const* values, size_t count);
/* ocean_terrain_get writes the value of the parameter `name` as text to out[size], with a final 0;
 * "" for an optional parameter that is not set. INVALID_VALUE, BUFFER_TOO_SMALL. */
OCEAN_API ocean_result ocean_terrain_get(const ocean_terrain* terrain, const char* name, char* out,
                                         size_t size);
/* ocean_terrain_text writes the resolved terrain file, which needs no other file. BUFFER_TOO_SMALL.
 */
OCEAN_API ocean_result ocean_terrain_text(const ocean_terrain* terrain, char* out, size_t* size);
/* ocean_terrain_state_json writes the output of `ocean info --json` for a terrain, a JSON object.
 * BUFFER_TOO_SMALL. */
OCEAN_API ocean_result ocean_terrain_state_json(const ocean_terrain* terrain, char* out,
                                                size_t* size);
/* ocean_terrain_parameters_json writes the parameter table of terrains, a JSON array.
 * BUFFER_TOO_SMALL. */
OCEAN_API ocean_result ocean_terrain_parameters_json(char* out, size_t* size);
/* ocean_terrain_preset writes the terrain file of a preset ("tujunga"); with name = NULL the names
 * of all terrain presets, a JSON array. NOT_FOUND, BUFFER_TOO_SMALL. */
OCEAN_API ocean_result ocean_terrain_preset(const char* name, char* out, size_t* size);
/* ocean_terrain_provenance_json writes the strings by which `ocean terrain` labels a file, as
 * ocean_provenance_json does for a sea. field: the product in the file, "height", "normal" or
 * "slope"; NULL = leave out the strings about a product. axes: OCEAN_ZUP, OCEAN_YUP or OCEAN_TNB.
 * INVALID_VALUE, BUFFER_TOO_SMALL. */
OCEAN_API ocean_result ocean_terrain_provenance_json(const ocean_terrain* terrain,
                                                     const char* field, int32_t axes, char* out,
                                                     size_t* size);
/* ocean_terrain_evaluate computes all outputs of the request together, as ocean_evaluate does; time
 * has no effect, cascade must be 0, resolution 0 = terrain.resolution. A land that exists once has
 * maps from edge to edge, without a seam, and must be a square; others have ocean_terrain_region.
 * UNSUPPORTED. */
OCEAN_API ocean_result ocean_terrain_evaluate(ocean_terrain* terrain, const ocean_request* request);
/* ocean_terrain_query_points finds height and normal at world points, as ocean_query_points does;
 * time and foam have no effect, velocity and foam of the samples are 0, and label is the point.
 * INVALID_VALUE for a refine or a resolution that is not allowed. */
OCEAN_API ocean_result ocean_terrain_query_points(ocean_terrain* terrain,
                                                  const ocean_query_request* request);
/* The samples of a terrain's own map, or of the wake of a hull: sample (0, 0) lies at (x, y), and
 * samples `cell` apart [m]. wraps: 1 = a tile that repeats after columns * cell; 0 = a land that
 * exists once. struct_size = sizeof(ocean_domain), set by the caller. */
typedef struct {
    size_t struct_size;
    double x;
    double y;
    double cell;
    int32_t columns;
    int32_t rows;
    int32_t wraps;
    int32_t reserved;
} ocean_domain;
OCEAN_API ocean_result ocean_terrain_domain(const ocean_terrain* terrain, ocean_domain* domain);
/* A region of a terrain or of a sea over a bed or with hulls: columns x rows samples, 2 .. 32768
 * each, `cell` apart [m], sample (0, 0) at (x, y). struct_size = sizeof(ocean_region_request),
 * output_size = sizeof(ocean_output). The outputs are as those of ocean_request, with `columns`
 * samples in a row; seam must be 0. */
typedef struct {
    size_t struct_size;
    double x;
    double y;
    double cell;
    int32_t columns;
    int32_t rows;
    const ocean_output* outputs;
    size_t output_count;
    size_t output_size;
} ocean_region_request;
/* ocean_terrain_region computes all outputs of a region together. A tile repeats, and beyond the
 * rectangle of a land that exists once the heights are those of its edge. Regions of one cell whose
 * corners are whole numbers of cells from (0, 0) join bit by bit. UNSUPPORTED for channels that
 * the terrain does not have. */
OCEAN_API ocean_result ocean_terrain_region(ocean_terrain* terrain,
                                            const ocean_region_request* request);
/* ocean_region computes all outputs of a region of a sea over a bed (water.seabed, ocean_set_bed)
 * or with hulls at a time [s] together, by label. Over a bed it has OCEAN_DEPTH, OCEAN_BREAKING and
 * OCEAN_WETNESS beside the channels of every sea, with hulls OCEAN_TRAIL and OCEAN_DRY. The first
 * call computes where the waves go over the bed, which takes seconds; later calls keep that until
 * bed or waves change. UNSUPPORTED for a sea without a bed and hulls. All other functions that
 * compute maps or slope tiles of a sea return UNSUPPORTED for a sea over a bed: their maps repeat,
 * and it does not. */
OCEAN_API ocean_result ocean_region(ocean_sea* sea, double time,
                                    const ocean_region_request* request);
/* ocean_bed_region writes the heights of the bed of a sea over still water [m], linear between its
 * samples and beyond it those of its border, at columns x rows places `cell` apart [m] from (x, y)
 * on, row by row from the south into heights[0 .. columns * rows - 1]. columns and rows: 2 ..
 * 32768. UNSUPPORTED for a sea without a bed. */
OCEAN_API ocean_result ocean_bed_region(const ocean_sea* sea, double x, double y, double cell,
                                        int32_t columns, int32_t rows, float* heights);
/* A mesh of land around a camera at (x, y, z) [m]: fine near it, coarser by a factor of 2 with each
 * doubling of the distance, and without cracks. ground: the height of the land under the camera
 * [m]; distances are taken to the plane of that height, so that a coarse height keeps the mesh calm
 * while the camera moves. farthest: distance up to which there is a mesh [m], 1 .. 150000 or more,
 * at the default spacing; a land that exists once ends at its edge. spacing: of the vertices at the
 * camera [m], 0 = 0.5. range: distance at which the spacing has doubled once, in spacings, 0 = 140,
 * min 134; more is finer. positions: 3 doubles for each of vertex_capacity vertices, x, y, z of the
 * world; corners: 3 numbers of vertices for each of triangle_capacity triangles, counter-clockwise
 * from above. struct_size = sizeof(ocean_mesh_request). */
typedef struct {
    size_t struct_size;
    double x;
    double y;
    double z;
    double ground;
    double farthest;
    double spacing;
    double range;
    double* positions;
    size_t vertex_capacity;
    uint32_t* corners;
    size_t triangle_capacity;
} ocean_mesh_request;
/* ocean_terrain_mesh makes such a mesh and writes its counts to *vertices and *triangles. First
 * call it with positions = corners = NULL for the counts; the terrain keeps the mesh until a call
 * with the same numbers and enough capacity has copied it, or the terrain changes. Heights are
 * those of maps whose cell is the spacing of the vertices there, and blend into those of the next
 * spacing. INVALID_VALUE for numbers that are not allowed, BUFFER_TOO_SMALL. */
OCEAN_API ocean_result ocean_terrain_mesh(ocean_terrain* terrain, const ocean_mesh_request* request,
                                          size_t* vertices, size_t* triangles);
/* ocean_terrain_stage writes one step of the synthesis, R x R floats with R = terrain.resolution,
 * row-major from the south: "noise" (white, in space), "transform" (the magnitudes of its Fourier
 * transform), "filter" and "filtered" [m], these three with k = 0 at (R / 2, R / 2), or "height"
 * [m]. count: floats in data, min R * R. */
OCEAN_API ocean_result ocean_terrain_stage(ocean_terrain* terrain, const char* step, float* data,
                                           size_t count);
/* ocean_wake_count writes the number of hulls of a sea, each of which makes a wake; 0 without
 * hulls.
 */
OCEAN_API ocean_result ocean_wake_count(const ocean_sea* sea, size_t* count);
/* ocean_wake_domain writes the samples of the wake of hull `hull`, 0 .. count - 1, at a time [s]: a
 * square of columns * cell a side that moves with the hull by whole cells and does not wrap.
 * INVALID_VALUE for a hull that the sea does not have. */
OCEAN_API ocean_result ocean_wake_domain(const ocean_sea* sea, size_t hull, double time,
                                         ocean_domain* domain);
/* ocean_wake_region computes all outputs of a region of that wake without the open sea together, by
 * label. In each channel that adds up (see ocean_request) a region of the sea is the sum of the
 * open sea and of its wakes. A wake is 0 beyond its square. Any origin and cell are allowed, not
 * only those of its domain. OCEAN_TRAIL is the trail of this hull, which fades out towards the
 * border of the square. INVALID_VALUE for a hull that the sea does not have, UNSUPPORTED for foam
 * and other masks. */
OCEAN_API ocean_result ocean_wake_region(ocean_sea* sea, size_t hull, double time,
                                         const ocean_region_request* request);
/* ocean_wake_add adds that wake to a region of the open sea, which the outputs hold. Channels that
 * add up, and OCEAN_TRAIL, are sums then; OCEAN_JACOBIAN is one to first order, and normals are
 * tilted to first order. A normal must be whole in one output. Errors as ocean_wake_region,
 * UNSUPPORTED for a part of a normal. */
OCEAN_API ocean_result ocean_wake_add(ocean_sea* sea, size_t hull, double time,
                                      const ocean_region_request* request);
/* The highest point of a crest: the displayed point at (x, y) [m] is `height` over still water [m]
 * at `time` [s]. struct_size = sizeof(ocean_crest), set by the caller. */
typedef struct {
    size_t struct_size;
    double time;
    double x;
    double y;
    double height;
} ocean_crest;
/* ocean_find_crest finds the highest crest of a sea from the time `from` up to `to` [s]. box: west,
 * south, east and north of the place to search [m]; NULL = one period. It computes 24 maps for each
 * peak period, max 20000. INVALID_VALUE for a flat sea or a longer search, UNSUPPORTED for a sea
 * over a bed. */
OCEAN_API ocean_result ocean_find_crest(ocean_sea* sea, double from, double to, const double* box,
                                        ocean_crest* crest);
/* A bake for the engine of a render farm. struct_size = sizeof(ocean_farm_request), set by the
 * caller. engine: "slurm", "openjd" or "flamenco". output: -o of `ocean bake`; it and render start
 * from the folder of the job where they are relative. options: further words of `ocean bake`. */
typedef struct {
    size_t struct_size;
    const char* engine;
    const char* output;    /* "out/sea.####.exr" */
    const int32_t* frames; /* in any order */
    size_t frame_count;
    const char* const* options; /* may be NULL */
    size_t option_count;
    const char* render;      /* a scene to render afterwards, .pov or .blend; NULL = none */
    int32_t frames_per_task; /* 0 = all */
    int32_t threads;         /* cores of a task; 0 = those that it gets */
    int32_t minutes;         /* after which the engine ends a task; 0 = its own limit */
    int32_t reserved;        /* 0 */
    uint64_t memory_bytes;   /* of a task; 0 = unknown */
} ocean_farm_request;
/* ocean_farm_job_json writes the files of a job that bakes the sea in parts, checks them and
 * renders, as `ocean farm` does: a JSON object of names and texts. The caller puts them into one
 * folder; the sea among them needs no other file. INVALID_VALUE for an unknown engine or a job that
 * the engine cannot run, BUFFER_TOO_SMALL. */
OCEAN_API ocean_result ocean_farm_job_json(const ocean_sea* sea, const ocean_farm_request* request,
                                           char* out, size_t* size);

#ifdef __cplusplus
}
#endif

#endif
