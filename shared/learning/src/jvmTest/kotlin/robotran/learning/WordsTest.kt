package robotran.learning

import robotran.language.Language
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** One thing has one word in all that pupils read. */
class WordsTest {
    @Test
    fun `no sentence of the app has a word that is retired`() {
        val sentences = catalogues.flatMap { (file, text) -> sentencesIn(file, text) }
        assertTrue(sentences.size > 5_000, "only ${sentences.size} sentences")
        assertEquals(emptyList(), sentences.filter(::isRetired))
    }

    @Test
    fun `a thing that has a word has it in every translation of the screens`() {
        val screens = catalogues.filterKeys { file -> SCREENS.any { "shared/$it" in file } }
        val messages = screens.values.flatMap { it.split("\n## ").drop(1) }
        val wrong = messages.flatMap { message ->
            val heading = message.substringBefore('\n')
            val texts = TAGS.associateWith { textIn(message, it) }
            val english = texts.getValue("en")
            THINGS.filter { it.getValue("en").first().let { noun -> says(english, noun) } }.flatMap { thing ->
                (TAGS - "en").filter { tag -> thing.getValue(tag).none { stem(it) in texts.getValue(tag).lowercase() } }
                    .map { tag -> "$heading in $tag has no ${thing.getValue(tag).first()}: ${texts.getValue(tag)}" }
            }
        }
        assertEquals(emptyList(), wrong)
    }

    /** Whether [text] has [noun], or several of it, outside of program text and names of parameters. */
    private fun says(text: String, noun: String): Boolean =
        Regex("(?<![\\w.])$noun(s|\\b)(?![\\w.:]| main| 0)").containsMatchIn(text.replace(PLACEHOLDER, " ").lowercase())

    private fun stem(word: String): String = word.lowercase().take(STEM)

    private fun textIn(message: String, tag: String): String {
        val lines = message.lines()
        val first = lines.indexOfFirst { it.startsWith("- $tag:") }
        if (first < 0) return ""
        val more = lines.drop(first + 1).takeWhile { it.startsWith("  ") }
        return (listOf(lines[first].substringAfter(":")) + more).joinToString(" ") { it.trim() }
    }

    @Test
    fun `no lesson, task, hint or help has a word that is retired`() {
        val texts = lessonTexts + commonLessonTexts + worldTaskTexts + wordTexts
        val lines = texts.filterKeys { it.endsWith(".md") }.flatMap { (file, text) ->
            text.lines().filterNot { it.startsWith("#") }.map { "$file: $it" }
        }
        assertTrue(lines.size > 5_000, "only ${lines.size} lines")
        assertEquals(emptyList(), lines.filter(::isRetired))
    }

    /** Each sentence of a catalogue with its file and message; what is written for translators is none. */
    private fun sentencesIn(file: String, text: String): List<String> {
        var message = ""
        var isSentence = false
        return text.lines().mapNotNull { line ->
            if (line.startsWith("#")) message = line.removePrefix("## ")
            isSentence = SENTENCE.containsMatchIn(line) || (isSentence && line.startsWith("  "))
            "$file, $message: $line".takeIf { isSentence }
        }
    }

    private fun isRetired(line: String): Boolean = RETIRED.any { it.containsMatchIn(line.substringAfter(": ")) }

    private companion object {
        val TAGS = Language.entries.map { it.tag }
        val SENTENCE = Regex("^- (${TAGS.joinToString("|")}): ")
        val PLACEHOLDER = Regex("\\{[^{}]*\\}")

        /** The modules with the sentences of the screens; those about code have words of their own. */
        val SCREENS = listOf("ui-school", "ui-run", "ui-world", "ui-program", "ui/", "editing")

        /** How much of a word is the same in all its forms, at least. */
        const val STEM = 4

        /** The rows of the page's table about things: the words of each language. */
        val THINGS: List<Map<String, List<String>>> = rowsOfWords.drop(1)
            .map { row -> TAGS.zip(row.drop(1)).toMap().mapValues { (_, cell) -> cell.split(", ") } }
            .filter { it.getValue("en").first() in NOUNS }
        val NOUNS: Set<String>
            get() = setOf(
                "lesson",
                "task",
                "goal",
                "hint",
                "duplicate",
                "undo",
                "brick",
                "world",
                "bumper",
                "hand-in",
            ) +
                setOf("drawing to trace", "marked area")
        private val rowsOfWords: List<List<String>>
            get() = pageOnWords.getValue("messages.md")
                .substringAfter("## Words").substringBefore("\n## ").lines()
                .filter { it.startsWith("| ") }
                .map { row -> row.trim().trim('|').split('|').map { it.trim() } }

        /** The words of the last column of the page's table; with `is so` it is meant at the end of a clause. */
        val RETIRED: List<Regex> = pageOnWords.getValue("messages.md")
            .substringAfter("## Words").substringBefore("\n## ").lines()
            .filter { it.startsWith("| ") }.drop(1)
            .flatMap { row -> row.trim().removeSuffix("|").substringAfterLast('|').split(",") }
            .map { it.trim() }.filter { it.isNotEmpty() }
            .map { word ->
                val end = if (word == "is so") "(?=[.,;:]| when)" else "\\b"
                Regex("\\b${Regex.escape(word)}$end", RegexOption.IGNORE_CASE)
            }
    }
}
