package robotran.javacompiler.diagnose

/**
 * An error or a warning in a program, written for beginners.
 *
 * @property path the path of the source.
 * @property range its position; empty where something is missing.
 * @property text the source text in [range].
 * @property message one or two sentences: what is wrong.
 * @property hint what to do instead; null if the message says it.
 * @property fix a change that very likely fixes it; null if there are several ways to.
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

enum class JavaSeverity {
    /** The program cannot run until the pupil fixes it. */
    ERROR,

    /** The program can run, but probably not as intended, or not on a real brick. */
    WARNING,
}

/**
 * A part of one line.
 *
 * @property line the line, from 1.
 * @property column the column, from 1, in UTF-16 characters. A tab counts as one; a byte order mark before the first
 * line does not count.
 * @property endColumn the column after the last character.
 */
data class JavaRange(val line: Int, val column: Int, val endColumn: Int)

/** A change of the source that an editor can offer: [replacement] replaces [range], which is empty for an insertion. */
data class JavaFix(val range: JavaRange, val replacement: String)
