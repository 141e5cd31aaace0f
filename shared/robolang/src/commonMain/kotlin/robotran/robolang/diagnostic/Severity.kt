package robotran.robolang.diagnostic

enum class Severity {
    /** The program cannot run until this is fixed. */
    ERROR,

    /** The program can run, but probably not as intended, or not on a real brick. */
    WARNING,
}
