#include "compiler/codegen/library_names.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string_view>

namespace rtac::codegen {
namespace {

// C99, C11 and C17, clause 7. The headers of C++ have no ending, so that no file hides them.
constexpr std::string_view c_headers[] = {
    "assert",  "complex", "ctype",  "errno",  "fenv",   "float",       "inttypes", "iso646",
    "limits",  "locale",  "math",   "setjmp", "signal", "stdalign",    "stdarg",   "stdatomic",
    "stdbool", "stddef",  "stdint", "stdio",  "stdlib", "stdnoreturn", "string",   "tgmath",
    "threads", "time",    "uchar",  "wchar",  "wctype"};

// POSIX.1-2017 and what else lies beside those of C: the headers of C and C++ include some of them.
constexpr std::string_view system_headers[] = {
    "aio",     "alloca",    "argp",     "argz",     "byteswap",  "cpio",     "cpuid",    "crypt",
    "dirent",  "dlfcn",     "elf",      "endian",   "envz",      "err",      "error",    "execinfo",
    "fcntl",   "features",  "fmtmsg",   "fnmatch",  "fstab",     "ftw",      "getopt",   "glob",
    "grp",     "iconv",     "ifaddrs",  "langinfo", "libgen",    "libintl",  "link",     "malloc",
    "memory",  "mm_malloc", "monetary", "mqueue",   "ndbm",      "netdb",    "nl_types", "obstack",
    "omp",     "paths",     "poll",     "printf",   "pthread",   "pty",      "pwd",      "quadmath",
    "regex",   "resolv",    "sched",    "search",   "semaphore", "spawn",    "strings",  "stropts",
    "syscall", "sysexits",  "syslog",   "tar",      "termios",   "ucontext", "ulimit",   "unistd",
    "unwind",  "utime",     "utmp",     "utmpx",    "values",    "varargs",  "wait",     "wordexp"};

// Those of the runtime, `rtac/NAME.h`.
constexpr std::string_view runtime_headers[] = {
    "controller", "csv_log", "decision", "decision_text", "kernel_bridge",
    "machine",    "queue",   "sample",   "status",        "types",
    "units",      "watch",   "watchdog", "zone",          "zone_table"};

// What the headers of C and POSIX declare in the global namespace, which those of C++ include:
// functions, variables and structs. Of those that exist for float and long double (sinf, sinl) the
// one for double stands for all. A blank around each.
constexpr std::string_view global_names =
    " a64l abort abs access acct acos acosh alarm aligned_alloc alloca asctime asin asinh "
    "asprintf at_quick_exit atan atan2 atanh atexit atof atoi atol basename bcmp bcopy brk "
    "bsearch btowc bzero c16rtomb c32rtomb c8rtomb cabs cacos cacosh calloc canonicalize carg "
    "casin casinh catan catanh cbrt ccos ccosh ceil cexp chdir chown chroot cimag clearenv "
    "clearerr clock clock_adjtime clock_getcpuclockid clock_getres clock_gettime clock_nanosleep "
    "clock_settime clog clog10 clone close close_range closefrom confstr conj copy_file_range "
    "copysign cos cosh cpow cproj creal crypt csin csinh csqrt ctan ctanh ctermid ctime cuserid "
    "daemon daylight difftime div dprintf drand48 drem dup dup2 dup3 duplocale dysize eaccess "
    "ecvt endusershell environ erand48 erf erfc euidaccess execl execle execlp execv execve "
    "execveat execvp execvpe exit exp exp10 exp2 explicit_bzero expm1 fabs faccessat fadd fchdir "
    "fchown fchownat fclose fcloseall fcvt fdatasync fdim fdiv fdopen fegetenv fegetmode "
    "fegetround feof ferror fesetenv fesetmode fesetround feupdateenv fexecve fflush ffma ffs "
    "fgetc fgetpos fgets fgetwc fgetws fileno finite flockfile floor fma fmax fmaxmag fmemopen "
    "fmin fminmag fmod fmul fopen fopencookie fork fpathconf fprintf fputc fputs fputwc fputws "
    "fread free freelocale freopen frexp fscanf fseek fseeko fsetpos fsqrt fsub fsync ftell "
    "ftello ftruncate ftrylockfile funlockfile fwide fwprintf fwrite fwscanf gamma gcvt "
    "get_current_dir_name getc getchar getcpu getcwd getdate getdelim getdomainname "
    "getdtablesize getegid getentropy getenv geteuid getgid getgroups gethostid gethostname "
    "getline getloadavg getlogin getopt getpagesize getpass getpgid getpgrp getpid getppid getpt "
    "getresgid getresuid getsid getsubopt gettid getuid getusershell getw getwc getwchar getwd "
    "gmtime grantpt group_member gsignal hypot ilogb imaxabs imaxdiv index initstate iovec "
    "isalnum isalpha isascii isatty isblank iscntrl isctype isdigit isgraph isinf islower isnan "
    "isprint ispunct isspace isupper iswalnum iswalpha iswblank iswcntrl iswctype iswdigit "
    "iswgraph iswlower iswprint iswpunct iswspace iswupper iswxdigit isxdigit itimerspec "
    "itimerval j0 j1 jn jrand48 kill killpg l64a labs lchown lcong48 lconv ldexp ldiv lgamma "
    "link linkat llabs lldiv llogb llrint llround localeconv localtime lockf log log10 log1p "
    "log2 logb longjmp lrand48 lrint lround lseek malloc mblen mbrlen mbrtoc16 mbrtoc32 mbrtoc8 "
    "mbrtowc mbsinit mbsnrtowcs mbsrtowcs mbstowcs mbtowc memccpy memchr memcmp memcpy memfrob "
    "memmem memmove mempcpy memrchr memset mkdtemp mkstemp mkstemps mktemp mktime modf mrand48 "
    "nan nanosleep nearbyint newlocale nextafter nextdown nexttoward nextup nice nrand48 on_exit "
    "open_memstream open_wmemstream optarg opterr optind option optopt pathconf pause pclose "
    "perror pipe pipe2 popen posix_memalign posix_openpt pow pread printf profil pselect "
    "psiginfo psignal pthread_create ptsname putc putchar putenv puts putw putwc putwchar pwrite "
    "qecvt qfcvt qgcvt qsort quick_exit raise rand random rawmemchr read readlink readlinkat "
    "realloc reallocarray realpath remainder remove remquo rename renameat renameat2 revoke "
    "rewind rindex rint rmdir round roundeven rpmatch sbrk scalb scalbln scalbn scanf "
    "sched_param sched_yield secure_getenv seed48 select sem_clockwait sem_close sem_destroy "
    "sem_getvalue sem_init sem_open sem_post sem_timedwait sem_trywait sem_unlink sem_wait "
    "setbuf setbuffer setdomainname setegid setenv seteuid setgid sethostid sethostname setjmp "
    "setlinebuf setlocale setlogin setns setpgid setpgrp setregid setresgid setresuid setreuid "
    "setsid setstate setuid setusershell setvbuf sigaction sigaddset sigaltstack sigandset "
    "sigblock sigcontext sigdelset sigemptyset sigevent sigfillset siggetmask sighold sigignore "
    "siginterrupt sigisemptyset sigismember siglongjmp signal signgam significand sigorset "
    "sigpause sigpending sigprocmask sigqueue sigrelse sigreturn sigset sigsetmask sigstack "
    "sigsuspend sigtimedwait sigval sigwait sigwaitinfo sin sincos sinh sleep snprintf sprintf "
    "sqrt srand srand48 srandom sscanf ssignal stat stpcpy stpncpy strcasecmp strcasestr strcat "
    "strchr strchrnul strcmp strcoll strcpy strcspn strdup strerror strfromd strfromf strfroml "
    "strfry strftime strlen strncasecmp strncat strncmp strncpy strndup strnlen strpbrk strptime "
    "strrchr strsep strsignal strspn strstr strtod strtof strtoimax strtok strtol strtold strtoq "
    "strtoul strtoumax strtouq strverscmp strxfrm swab swprintf swscanf symlink symlinkat sync "
    "syncfs syscall sysconf system sysv_signal tan tanh tcgetpgrp tcsetpgrp tempnam tgamma "
    "tgkill time timegm timelocal timer_create timer_delete timer_getoverrun timer_gettime "
    "timer_settime timespec timespec_get timespec_getres timeval timezone tm tmpfile tmpnam "
    "toascii tolower toupper towctrans towlower towupper trunc truncate ttyname ttyslot tzname "
    "tzset ualarm ungetc ungetwc unlink unlinkat unlockpt unsetenv unshare uselocale usleep "
    "valloc vasprintf vdprintf vfork vfprintf vfscanf vfwprintf vfwscanf vhangup vprintf vscanf "
    "vsnprintf vsprintf vsscanf vswprintf vswscanf vwprintf vwscanf wcpcpy wcpncpy wcrtomb "
    "wcscasecmp wcscat wcschr wcschrnul wcscmp wcscoll wcscpy wcscspn wcsdup wcsftime wcslen "
    "wcsncasecmp wcsncat wcsncmp wcsncpy wcsnlen wcsnrtombs wcspbrk wcsrchr wcsrtombs wcsspn "
    "wcsstr wcstod wcstof wcstoimax wcstok wcstol wcstold wcstombs wcstoq wcstoul wcstoumax "
    "wcstouq wcswcs wcswidth wcsxfrm wctob wctomb wctrans wctype wcwidth wmemchr wmemcmp wmemcpy "
    "wmemmove wmempcpy wmemset wprintf write wscanf y0 y1 yn ";

template <class Names>
bool is_one_of(const Names& names, std::string_view name) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

}  // namespace

bool is_library_global(const std::string& name) {
  const auto is_known = [](const std::string& word) {
    return global_names.find(" " + word + " ") != std::string_view::npos;
  };
  if (is_known(name)) return true;
  if (name.empty() || (name.back() != 'f' && name.back() != 'l')) return false;
  return is_known(name.substr(0, name.size() - 1));
}

std::string hidden_header(const std::string& stem, const std::string& folder) {
  std::string small = stem;  // some file systems do not tell capitals
  std::transform(small.begin(), small.end(), small.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (is_one_of(c_headers, small) || is_one_of(system_headers, small)) return "<" + small + ".h>";
  const bool is_ours = folder == "rtac" && is_one_of(runtime_headers, small);
  return is_ours ? "\"rtac/" + small + ".h\"" : "";
}

}  // namespace rtac::codegen
