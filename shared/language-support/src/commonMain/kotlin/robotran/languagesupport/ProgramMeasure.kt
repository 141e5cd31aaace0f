package robotran.languagesupport

/** What grading asks about the texts of programs in a language. */
interface ProgramMeasure {
    /** The lines of [text], without empty ones and comments. */
    fun linesOfCode(text: String): Int

    /**
     * The words, numbers and signs of [text], without comments. All names that a pupil may choose are [NAME], so that
     * renaming changes nothing.
     */
    fun normalTokens(text: String): Sequence<String>

    /** Whether the order of a program's files means nothing. */
    val isAnyOrderOfFiles: Boolean get() = false

    companion object {
        /** Stands for a name that a pupil may choose. */
        const val NAME: String = "name"
    }
}
