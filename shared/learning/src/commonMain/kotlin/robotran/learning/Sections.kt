package robotran.learning

/** A heading and the text below it, up to the next heading of the same level. */
internal class Section(val heading: String, val body: String)

/** Splits [text] at its headings, the lines that begin with [mark]. The text before the first heading is dropped. */
internal fun sections(text: String, mark: String = "# "): List<Section> {
    val found = mutableListOf<Section>()
    var heading: String? = null
    val body = StringBuilder()
    for (line in text.lines() + mark) {
        if (line.startsWith(mark)) {
            heading?.let { found += Section(it, body.toString().trim()) }
            heading = line.removePrefix(mark).trim()
            body.clear()
        } else {
            body.append(line).append('\n')
        }
    }
    return found
}

/** The paragraphs of [text], with their line breaks replaced by spaces. */
internal fun paragraphs(text: String): List<String> =
    text.split("\n\n").map { part -> part.lines().joinToString(" ") { it.trim() }.trim() }.filter { it.isNotEmpty() }
