package robotran.javacompiler.diagnose

/**
 * A mistake in a program, or something doubtful, told so that a beginner can mend it.
 *
 * @property path the source it is in.
 * @property severity whether it keeps the program from running.
 * @property range where it is; of no width where something is missing.
 * @property text the piece of source it concerns, up to the end of its first line.
 * @property message what is wrong, one or two sentences.
 * @property hint what to do instead, null if the message says it all.
 * @property fix a change that very likely mends it, null where there are several ways.
 */
data class JavaDiagnostic(
    val path: String,
    val severity: JavaSeverity,
    val range: JavaRange,
    val text: String,
    val message: String,
    val hint: String? = null,
    val fix: JavaFix? = null,
)

/** How bad it is. */
enum class JavaSeverity {
    /** The program cannot run until it is mended. */
    ERROR,

    /** The program can run, but hardly as it is meant, or not on a real brick. */
    WARNING,
}

/**
 * A piece of one line.
 *
 * @property line from 1.
 * @property column from 1, counted in UTF-16 characters, a tab being one; a byte order mark before the first line does
 * not count.
 * @property endColumn the column after the last character.
 */
data class JavaRange(val line: Int, val column: Int, val endColumn: Int)

/**
 * A change of the source that an editor can offer: [replacement] in place of [range], which is of no width where
 * something is only put in.
 */
data class JavaFix(val range: JavaRange, val replacement: String)
