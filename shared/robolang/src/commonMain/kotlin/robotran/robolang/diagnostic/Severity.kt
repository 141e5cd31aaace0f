package robotran.robolang.diagnostic

/** How bad it is. */
enum class Severity {
    /** The program cannot run until it is mended. */
    ERROR,

    /** The program can run, but hardly as it is meant, or not on a real brick. */
    WARNING,
}
