package robotran.learning

/**
 * The text of a [TutorialStep]. Program text is between backticks.
 *
 * @property paragraphs two to four short ones.
 */
data class TutorialText(val title: String, val paragraphs: List<String>, val task: String, val hint: String) {
    internal companion object {
        /** The text in [file] for a pupil who sees programs in blocks, or as text. */
        fun of(file: String, inBlocks: Boolean): TutorialText {
            val whole = sections(file).single()
            val parts = sections(whole.body, "## ").associate { it.heading to it.body }
            val told = { body: String -> toldFor(inBlocks, paragraphs(body)) }
            return TutorialText(
                whole.heading,
                told(whole.body.substringBefore("## ")),
                told(parts.getValue("Task")).joinToString(" "),
                told(parts.getValue("Hint")).joinToString(" "),
            )
        }
    }
}

/** The [paragraphs] for a pupil who sees programs in blocks, or as text. The mark at the start of one says for whom. */
private fun toldFor(inBlocks: Boolean, paragraphs: List<String>): List<String> {
    val (own, other) = if (inBlocks) FOR_BLOCKS to FOR_TEXT else FOR_TEXT to FOR_BLOCKS
    return paragraphs.filterNot { it.startsWith(other) }.map { it.removePrefix(own).trim() }
}

/** [text] without the backticks around program text. */
internal fun withoutBackticks(text: String): String = text.replace("`", "")

private const val FOR_TEXT = "(text) "
private const val FOR_BLOCKS = "(blocks) "
