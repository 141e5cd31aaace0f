package robotran.nqc.diagnostic

import robotran.nqc.messages.NqcMessages

/**
 * Collects the diagnostics of all phases. Keeps one error and one warning per line, since a second one often follows
 * from the first.
 */
internal class DiagnosticSink(val messages: NqcMessages) {
    private val diagnostics = mutableListOf<NqcDiagnostic>()
    private val lines = mutableSetOf<Triple<Severity, String, Int>>()

    private val errors = mutableSetOf<NqcDiagnosticCode>()

    val hasErrors: Boolean get() = errors.isNotEmpty()

    fun has(code: NqcDiagnosticCode): Boolean = code in errors

    /** Whether there are no errors but those of one [code]. */
    fun hasOnly(code: NqcDiagnosticCode): Boolean = errors.all { it == code }

    /** Whether an error at [range] would be kept. */
    fun takesErrorAt(range: SourceRange): Boolean =
        diagnostics.size < LIMIT && Triple(Severity.ERROR, range.file, range.line) !in lines

    fun report(code: NqcDiagnosticCode, range: SourceRange, message: String, fix: SourceFix? = null) {
        if (code.severity == Severity.ERROR) errors += code
        if (diagnostics.size >= LIMIT || !lines.add(Triple(code.severity, range.file, range.line))) return
        diagnostics += NqcDiagnostic(code, range, message, fix)
    }

    /** Adds what [other] has collected. */
    fun add(other: DiagnosticSink) = other.diagnostics.forEach { report(it.code, it.range, it.message, it.fix) }

    /** All of one [severity]: those of the main [file] by line, then those of included files. */
    fun inSourceOrder(severity: Severity, file: String): List<NqcDiagnostic> = diagnostics
        .filter { it.severity == severity }
        .sortedWith(compareBy({ it.range.file != file }, { it.range.file }, { it.range.line }, { it.range.column }))

    private companion object {
        /** More are of no use to anybody. */
        const val LIMIT = 200
    }
}
