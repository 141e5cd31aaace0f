package robotran.learning

/** What stands below a heading of a text, up to the next heading of the same rank. */
internal class Section(val heading: String, val body: String)

/** Takes [text] apart at its headings, the lines that begin with [mark]; what stands before the first is left out. */
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

/** The paragraphs of [text], each on one line however it was broken. */
internal fun paragraphs(text: String): List<String> =
    text.split("\n\n").map { part -> part.lines().joinToString(" ") { it.trim() }.trim() }.filter { it.isNotEmpty() }
