package robotran.legofirmware.assembly

/** Collects diagnostics: at most one error and one warning per line, and [AssemblyLimits.DIAGNOSTICS] in all. */
internal class AssemblySink {
    private val diagnostics = mutableListOf<AssemblyDiagnostic>()
    private val lines = mutableSetOf<Pair<Int, Boolean>>()

    val hasErrors: Boolean get() = diagnostics.any { it.isError }

    fun error(code: AssemblyProblem, place: Token, message: String, replacement: String? = null) =
        add(code, true, place, message, replacement)

    fun warn(code: AssemblyProblem, place: Token, message: String) = add(code, false, place, message, null)

    private fun add(code: AssemblyProblem, isError: Boolean, place: Token, message: String, replacement: String?) {
        if (diagnostics.size >= AssemblyLimits.DIAGNOSTICS || !lines.add(place.line to isError)) return
        val end = place.column + place.text.length
        diagnostics +=
            AssemblyDiagnostic(code, isError, place.line, place.column, end, place.text, message, replacement)
    }

    fun inSourceOrder(isError: Boolean): List<AssemblyDiagnostic> =
        diagnostics.filter { it.isError == isError }.sortedWith(compareBy({ it.line }, { it.column }))
}
