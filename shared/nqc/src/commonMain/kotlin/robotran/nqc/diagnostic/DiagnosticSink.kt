package robotran.nqc.diagnostic

import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.language.source.SourceFix
import robotran.language.source.SourceRange
import robotran.nqc.messages.NqcMessages

/**
 * Collects the diagnostics of all phases. Keeps one error and one warning per line, since a second one often follows
 * from the first.
 */
internal class DiagnosticSink(val messages: NqcMessages) {
    private val diagnostics = mutableListOf<Diagnostic>()
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
        // Nothing can be changed in the API, nor in another file than the one of the problem.
        val applicable = fix?.takeIf { it.range.line > 0 && it.range.file == range.file }
        val known = range.takeIf { it.line > 0 }
        keep(Diagnostic(code.severity, range.file, known, message, applicable, code = code))
    }

    private fun keep(diagnostic: Diagnostic) {
        if (diagnostics.size >= LIMIT) return
        val isNew = lines.add(Triple(diagnostic.severity, diagnostic.file, diagnostic.range?.line ?: 0))
        if (isNew) diagnostics += diagnostic
    }

    /** Adds what [other] has collected. */
    fun add(other: DiagnosticSink) {
        errors += other.errors
        other.diagnostics.forEach(::keep)
    }

    /** All of one [severity]: those of the main [file] by line, then those of included files. */
    fun inSourceOrder(severity: Severity, file: String): List<Diagnostic> = diagnostics
        .filter { it.severity == severity }
        .sortedWith(compareBy({ it.file != file }, { it.file }, { it.range?.line }, { it.range?.column }))

    private companion object {
        /** More are of no use to anybody. */
        const val LIMIT = 200
    }
}
