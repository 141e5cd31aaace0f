package robotran.learning

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
        val SENTENCE = Regex("^- (en|es|de): ")

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
