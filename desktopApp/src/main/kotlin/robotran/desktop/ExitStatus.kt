package robotran.desktop

/** What the process tells the shell it was started from. */
internal object ExitStatus {
    const val DONE = 0
    const val BAD_INPUT = 2
    const val NO_DISPLAY = 3
}
