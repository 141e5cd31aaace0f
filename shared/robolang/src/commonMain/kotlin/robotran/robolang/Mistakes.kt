package robotran.robolang

/** Collects what the phases find wrong with one source. */
internal class Mistakes(val messages: RobolangMessages) {
    private val diagnostics = mutableListOf<Diagnostic>()

    fun report(code: DiagnosticCode, range: SourceRange, text: String, message: String, fix: SourceFix? = null) {
        diagnostics += Diagnostic(code, range, text, message, fix)
    }

    fun inSourceOrder(): List<Diagnostic> =
        diagnostics.sortedWith(compareBy({ it.range.line }, { it.range.column }))
}
