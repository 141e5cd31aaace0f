package robotran.build.android

/**
 * What code may use although an Android does not have it, because it asks for `SDK_INT` first.
 *
 * A text has a line for each such place: a pattern of what uses it, `->`, a pattern of what is used, and behind a `#`
 * why that is safe. In a pattern `*` stands for anything. Lines that begin with `#` are remarks.
 */
internal class ApiAllowances(text: String) {
    private class Allowance(val line: String, val from: Regex, val used: Regex)

    private val allowances = text.lines().map {
        it.trim()
    }.filter { it.isNotEmpty() && !it.startsWith('#') }.map(::allowanceIn)
    private val unused = allowances.toMutableSet()

    /** Whether [use] is allowed. */
    fun allows(use: UsedApi.Use): Boolean {
        val used = listOfNotNull(use.owner, use.member).joinToString(".")
        val allowing = allowances.filter { it.from.matches(use.from) && it.used.matches(used) }
        unused -= allowing.toSet()
        return allowing.isNotEmpty()
    }

    /** The lines that have not allowed anything yet. */
    val needless: List<String> get() = unused.map { it.line }

    private fun allowanceIn(line: String): Allowance {
        val (from, used) = line.substringBefore('#').split("->").map { it.trim() }.takeIf { it.size == 2 }
            ?: throw IllegalArgumentException("\"$line\" is no pattern, -> and another one")
        if (line.substringAfter('#', "").isBlank()) throw IllegalArgumentException("\"$line\" does not say why")
        return Allowance(line, expression(from), expression(used))
    }

    private fun expression(pattern: String) = Regex(pattern.split('*').joinToString(".*") { Regex.escape(it) })
}
