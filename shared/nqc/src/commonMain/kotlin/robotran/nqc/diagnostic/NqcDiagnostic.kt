package robotran.nqc.diagnostic

/**
 * An error or a warning about an NQC program, in words that a beginner understands.
 *
 * @property code the kind of problem; stable, for tests and tools.
 * @property range its position; empty if something is missing.
 * @property message one or two sentences: what is wrong and what to do instead.
 * @property fix a change that very likely fixes it; null if there are several ways, or none that is certain.
 */
data class NqcDiagnostic(
    val code: NqcDiagnosticCode,
    val range: SourceRange,
    val message: String,
    val fix: SourceFix? = null,
) {
    val severity: Severity get() = code.severity
}

enum class Severity {
    /** The program cannot run until this is fixed. */
    ERROR,

    /** The program can run, but probably not as intended. */
    WARNING,
}
