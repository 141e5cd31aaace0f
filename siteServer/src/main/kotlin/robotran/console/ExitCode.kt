package robotran.console

/** The exit codes of the command line. */
enum class ExitCode(val status: Int) {
    /** Success: the program ended or reached its time limit. */
    DONE(0),

    /** The pupil's program failed at run time. For `check`, `build` and `format`: it has errors or is not formatted. */
    PROGRAM_FAILED(1),

    /** Invalid input: an argument, a file, a broken world, or a program to run that has errors. */
    BAD_INPUT(2),

    /** No display is available for a window. */
    NO_DISPLAY(3),

    /** A real brick could not be reached, or did not get all that was sent. */
    NO_BRICK(4),

    /** Robotran itself has failed; the code that systems have for this. */
    BROKEN(70),
}
