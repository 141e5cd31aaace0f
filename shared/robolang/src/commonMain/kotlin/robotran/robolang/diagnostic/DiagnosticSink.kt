package robotran.robolang.diagnostic

import robotran.robolang.messages.RobolangMessages

/**
 * Collects what the phases find wrong with one source: at most one mistake a line, for a second may well follow from
 * the first.
 */
internal class DiagnosticSink(val messages: RobolangMessages) {
    private val diagnostics = mutableListOf<Diagnostic>()
    private val mistakenLines = mutableSetOf<Int>()
    private val doubtfulLines = mutableSetOf<Int>()

    /** Words of the language, in lower case, that are declared as names, each with the lines of these declarations. */
    val takenWords = mutableMapOf<String, MutableSet<Int>>()

    val isEmpty: Boolean get() = mistakenLines.isEmpty()

    /** The lines that have a mistake so far. */
    val lines: Set<Int> get() = mistakenLines

    fun report(code: DiagnosticCode, range: SourceRange, text: String, message: String, fix: SourceFix? = null) {
        if (mistakenLines.add(range.line)) diagnostics += Diagnostic(code, Severity.ERROR, range, text, message, fix)
    }

    fun warn(code: DiagnosticCode, range: SourceRange, text: String, message: String, fix: SourceFix? = null) {
        if (doubtfulLines.add(range.line)) diagnostics += Diagnostic(code, Severity.WARNING, range, text, message, fix)
    }

    /** Leaves out the mistakes on [lines], which follow from others; nothing else is told there either. */
    fun forgive(lines: Set<Int>) {
        diagnostics.removeAll { it.range.line in lines }
    }

    /** What is wrong; what is only doubtful is left for when nothing is. */
    fun mistakesInSourceOrder(): List<Diagnostic> = inSourceOrder(Severity.ERROR)

    fun warningsInSourceOrder(): List<Diagnostic> = inSourceOrder(Severity.WARNING)

    private fun inSourceOrder(severity: Severity): List<Diagnostic> =
        diagnostics.filter { it.severity == severity }.sortedWith(compareBy({ it.range.line }, { it.range.column }))
}
