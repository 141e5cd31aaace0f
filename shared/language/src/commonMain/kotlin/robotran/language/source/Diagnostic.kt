package robotran.language.source

/**
 * An error or a warning about a program, in words that a beginner understands.
 *
 * @property file the file that it is in; empty if the program has none.
 * @property range its position, zero-width if something is missing there; null if it has none in the source.
 * @property message one or two sentences: what is wrong and what to do instead.
 * @property fix a change of [file] that very likely fixes it; null if there are several ways to, or none is certain.
 * @property text the source text at [range], where a compiler quotes it.
 * @property code the kind of problem, where a language has a list of them.
 */
data class Diagnostic(
    val severity: Severity,
    val file: String,
    val range: SourceRange?,
    val message: String,
    val fix: SourceFix? = null,
    val text: String = "",
    val code: ProblemCode? = null,
)

enum class Severity {
    /** The program cannot run until this is fixed. */
    ERROR,

    /** The program can run, but probably not as intended, or not on a real brick. */
    WARNING,
}

/** A kind of problem of a language. */
interface ProblemCode {
    /** The stable name used by tools, reports and tests, such as `missing-bracket`. */
    val id: String
}

/**
 * A change of the source that an editor can offer.
 *
 * @property range the text to remove; zero-width to only insert.
 * @property replacement the text to insert; line ends are `\n`.
 */
data class SourceFix(val range: SourceRange, val replacement: String)
