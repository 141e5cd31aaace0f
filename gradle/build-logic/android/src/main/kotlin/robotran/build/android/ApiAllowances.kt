package robotran.build.android

/**
 * Uses of newer Android APIs that are safe because the code checks `SDK_INT` first.
 *
 * A text has one line per use: a pattern of the caller, `->`, a pattern of the API, and after a `#` the reason why it
 * is safe. In a pattern `*` matches anything. Lines that start with `#` are comments.
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

    /** The lines that have not matched any use yet. */
    val needless: List<String> get() = unused.map { it.line }

    private fun allowanceIn(line: String): Allowance {
        val (from, used) = line.substringBefore('#').split("->").map { it.trim() }.takeIf { it.size == 2 }
            ?: throw IllegalArgumentException("\"$line\" is no pattern, -> and another one")
        if (line.substringAfter('#', "").isBlank()) throw IllegalArgumentException("\"$line\" does not say why")
        return Allowance(line, expression(from), expression(used))
    }

    private fun expression(pattern: String) = Regex(pattern.split('*').joinToString(".*") { Regex.escape(it) })
}
