package robotran.cli.console

/** What the command line tells the shell that called it. */
enum class ExitCode(val status: Int) {
    /** All went well: the program ended, or its time was up. */
    DONE(0),

    /**
     * The pupil's program failed while it ran or, where its text was the question, has mistakes or is not formatted.
     */
    PROGRAM_FAILED(1),

    /**
     * Something that was given is not usable: a word of the command, a file, a broken world, a program to run with
     * mistakes.
     */
    BAD_INPUT(2),

    /** There is no display to open a window on. */
    NO_DISPLAY(3),
}
