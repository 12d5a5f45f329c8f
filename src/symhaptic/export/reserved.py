"""Names of what languages bring along: an export of the same name would take its place, or clash.

All are in small letters, as the names of exports are.
"""

from __future__ import annotations

import sys


def vocabulary(text: str) -> frozenset[str]:
    """The words of a text."""
    return frozenset(text.split())


_C_FUNCTIONS = vocabulary(
    "abort abs acos acosh asin asinh atan atanh atof atoi atol bsearch calloc cbrt ceil clock "
    "copysign cosh ctime difftime div erf erfc exit exp2 fabs fclose fdim feof ferror fflush "
    "fgetc fgets fma fmax fmin fmod fopen fprintf fputc fputs fread free frexp fscanf fseek "
    "ftell fwrite gamma getc getchar getenv gets gmtime hypot ilogb index j0 j1 jn labs ldexp "
    "lgamma llabs llrint llround localtime log log10 log1p log2 logb lrint lround malloc memchr "
    "memcmp memcpy memmove memset mktime modf nan nearbyint nextafter perror pow printf putc "
    "putchar puts qsort raise rand random realloc remainder remove remquo rename rewind rindex "
    "rint round scanf setbuf signal sinh sprintf srand sscanf strcat strchr strcmp strcpy "
    "strlen strtod strtok strtol system tanh tgamma time tmpfile trunc ungetc vprintf y0 y1 yn"
)

_CMAKE = vocabulary("all clean edit_cache help install package rebuild_cache test")
"""Targets that CMake makes itself."""

C = (
    _C_FUNCTIONS
    | _CMAKE
    | vocabulary(
        "assert atan2 complex cos ctype errno exp expm1 fenv float floor inttypes iso646 limits "
        "locale math setjmp sin sqrt stdalign stdarg stdatomic stdbit stdbool stdckdint stddef "
        "stdint stdio stdlib stdnoreturn string tan tgmath threads uchar unistd wchar wctype"
    )
)
CPP = C | vocabulary(
    "algorithm any array atomic barrier bit bitset cassert cctype cerrno cfenv cfloat charconv "
    "chrono cinttypes climits clocale cmath codecvt compare concepts condition_variable "
    "coroutine csetjmp csignal cstdarg cstddef cstdint cstdio cstdlib cstring ctgmath ctime "
    "cuchar cwchar cwctype deque exception execution expected filesystem format forward_list "
    "fstream functional future generator initializer_list iomanip ios iosfwd iostream istream "
    "iterator latch list map mdspan memory memory_resource mutex numbers numeric optional "
    "ostream posix print queue random ranges ratio regex scoped_allocator semaphore set "
    "shared_mutex source_location span sstream stack stacktrace stdexcept stop_token streambuf "
    "string_view strstream syncstream system_error thread tuple type_traits typeindex typeinfo "
    "unordered_map unordered_set utility valarray variant vector version"
)

FORTRAN = vocabulary(
    "acos aimag aint anint asin atan atan2 bessel_j0 bit_size ceiling char cmplx conjg cosh "
    "dble dim dot_product epsilon erf gamma huge iand ichar ieee_arithmetic ieee_exceptions "
    "ieee_features ieee_is_nan ieee_value ieor index int int64 ior iso_c_binding "
    "iso_fortran_env kind len log log10 matmul maxval minval mod modulo mpi mvbits nint norm2 "
    "not omp_lib openacc pack product radix random_number range reshape scan shape sign sinh "
    "size sum tanh tiny transfer transpose trim ubound unpack verify"
)

RUST = vocabulary(
    "alloc bool char f128 f16 f32 f64 i128 i16 i32 i64 i8 isize libm option panic proc_macro "
    "result str string test u128 u16 u32 u64 u8 usize vec without_std"
)

PYTHON = frozenset(name.lower() for name in sys.stdlib_module_names) | vocabulary(
    "array_api_compat array_api_strict cupy dask jax pip scipy symhaptic sympy torch"
)

JAVASCRIPT = vocabulary(
    "alert array assert async_hooks blur boolean buffer caches child_process close cluster "
    "confirm console constants crypto customelements date dgram diagnostics_channel dns "
    "document domain error escape event events external fetch find focus frames fs global "
    "globalthis history http http2 https inspector isfinite isnan json length library location "
    "locationbar map math menubar module moveby name navigation navigator net node number "
    "object open opener origin os parent path perf_hooks performance personalbar postmessage "
    "print process promise prompt proxy punycode querystring readline reflect regexp repl "
    "reporterror require screen scroll scrollbars sea self set sqlite status statusbar stop "
    "stream string string_decoder symbol sys test timers tls toolbar top trace_events tty "
    "unescape url util v8 vm wasi window worker_threads zlib"
)

OCTAVE = vocabulary(
    "abs all angle any arrayfun atan2 audio beta cell cellfun class containers cos cosh cross "
    "datetime diag diff disp double error eval exit exp expm1 eye false fclose feval fft fgetl "
    "filter find floor fopen fprintf gamma grid handle hex2dec hold imag inf input int32 inv "
    "isempty isequal islogical isnan isnumeric isreal java lastwarn length line linspace load "
    "log logical mat2str matlab matlabshared max mean median min mod nan net norm num2str numel "
    "octave ones path plot poly print printf prod python rand real regexp repmat roots round "
    "save sign sim simulink sin single size sort sqrt squeeze std str2double strcmp string "
    "strsplit strtrim struct sum surf system table tan test text tic time title toc true var "
    "warning zeros"
)
