package robotran.legofirmware.assembly

import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.language.source.SourceFix
import robotran.language.source.SourceRange

/** Collects diagnostics: at most one error and one warning per line, and [AssemblyLimits.DIAGNOSTICS] in all. */
internal class AssemblySink {
    private val diagnostics = mutableListOf<Diagnostic>()
    private val lines = mutableSetOf<Pair<Int, Severity>>()

    val hasErrors: Boolean get() = diagnostics.any { it.severity == Severity.ERROR }

    fun error(code: AssemblyError, token: Token, message: String, replacement: String? = null) =
        add(code, Severity.ERROR, token, message, replacement)

    fun warn(code: AssemblyError, token: Token, message: String) = add(code, Severity.WARNING, token, message, null)

    private fun add(code: AssemblyError, severity: Severity, token: Token, message: String, replacement: String?) {
        if (diagnostics.size >= AssemblyLimits.DIAGNOSTICS || !lines.add(token.line to severity)) return
        val range = SourceRange(token.line, token.column, token.column + token.text.length)
        val fix = replacement?.let { SourceFix(range, it) }
        diagnostics += Diagnostic(severity, "", range, message, fix, token.text, code)
    }

    fun inSourceOrder(severity: Severity): List<Diagnostic> = diagnostics.filter { it.severity == severity }
        .sortedWith(compareBy({ it.range?.line }, { it.range?.column }))
}
