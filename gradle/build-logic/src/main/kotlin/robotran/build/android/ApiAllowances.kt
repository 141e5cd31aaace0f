package robotran.build.android

/**
 * What code may use although the oldest Android does not have it, because it looks at `SDK_INT` before.
 *
 * A text has a line for each place, a pattern of class and method in which `*` stands for anything, and behind a `#` why that is safe; lines that begin with `#` are remarks.
 */
internal class ApiAllowances(text: String) {
    private val patterns: List<String>
    private val unused: MutableSet<String>

    init {
        val lines = text.lines().map { it.trim() }.filter { it.isNotEmpty() && !it.startsWith('#') }
        lines.firstOrNull { it.substringAfter('#', "").isBlank() }?.let { throw IllegalArgumentException("\"$it\" does not say why") }
        patterns = lines.map { it.substringBefore('#').trim() }
        unused = patterns.toMutableSet()
    }

    private val expressions = patterns.associateWith { pattern -> Regex(pattern.split('*').joinToString(".*") { Regex.escape(it) }) }

    /** Whether [use] is allowed. */
    fun allows(use: UsedApi.Use): Boolean {
        val allowing = patterns.filter { expressions.getValue(it).matches(use.from) }
        unused -= allowing.toSet()
        return allowing.isNotEmpty()
    }

    /** The patterns that have not allowed anything yet. */
    val needless: Set<String> get() = unused
}
