package robotran.robolang.template

/**
 * Replaces each placeholder of the text, such as `@CLASS@`, with its value.
 *
 * @throws NoSuchElementException if a placeholder has none.
 */
internal fun String.fillIn(values: Map<String, String>): String =
    PLACEHOLDER.replace(this) { values.getValue(it.groupValues[1]) }

/** The parts of a text, each below a line such as `//// SHOW` with its name; empty lines around them are left out. */
internal fun sectionsOf(text: String): Map<String, String> = text.split(SECTION).drop(1)
    .associate { it.substringBefore('\n') to it.substringAfter('\n').trim('\n') }

private val PLACEHOLDER = Regex("@([A-Z_]+)@")
private const val SECTION = "//// "
