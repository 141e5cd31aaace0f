package robotran.desktop

/** What the command line tells the shell that called it. */
enum class ExitCode(val status: Int) {
    /** All went well: the program ended, or its time was up. */
    DONE(0),

    /** The pupil's program failed while it ran, or has mistakes where these were asked for. */
    PROGRAM_FAILED(1),

    /** Something that was given is not usable: a word of the command, a file, a program with mistakes, a broken world. */
    BAD_INPUT(2),

    /** There is no display to open a window on. */
    NO_DISPLAY(3),
}
