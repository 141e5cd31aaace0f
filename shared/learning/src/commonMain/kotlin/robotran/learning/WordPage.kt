package robotran.learning

import robotran.brick.kind.BrickKind
import robotran.brick.kind.JavaPlatform
import robotran.language.Language

/** The help on the words of one programming language, read from a file in the folder `learning/words`. */
internal class WordPage(text: String) {
    private val entries: Map<String, WordEntry> = readEntries(text)

    val words: List<String> get() = entries.keys.toList()

    fun help(word: String, language: Language): WordHelp? = entries[word]?.let { entry ->
        val known = if (language in entry.sentences) language else Language.ENGLISH
        WordHelp(word, entry.sentences.getValue(known), known, entry.forms, entry.example)
    }
}

/** One entry of the file. Words that share a heading share the entry. */
private class WordEntry(val sentences: Map<Language, String>, val forms: List<String>, val example: String?)

private fun readEntries(text: String): Map<String, WordEntry> {
    val found = mutableMapOf<String, WordEntry>()
    for (section in sections(text)) {
        val lines = section.body.lines()
        val sentences = Language.entries.mapNotNull { language ->
            lines.firstOrNull { it.startsWith("- ${language.tag}: ") }?.let { language to it.substringAfter(": ") }
        }
        val entry = WordEntry(
            sentences.toMap(),
            lines.first { it.startsWith(FORM) }.removePrefix(FORM).split(BETWEEN_FORMS).map { it.trim('`') },
            fencedLines(lines),
        )
        section.heading.split(", ").associateWithTo(found) { entry }
    }
    return found
}

private fun fencedLines(lines: List<String>): String? {
    val fence = lines.indexOfFirst { it.startsWith(FENCE) }
    if (fence < 0) return null
    return lines.drop(fence + 1).takeWhile { it != FENCE }.joinToString("\n", postfix = "\n")
}

private const val FORM = "- form: "
private const val BETWEEN_FORMS = " · "
private const val FENCE = "```"

internal val robolangWords: WordPage by lazy { WordPage(wordTexts.getValue("robolang.md")) }

private val lejosWords: WordPage by lazy { WordPage(wordTexts.getValue("lejos.md")) }

private val nxjWords: WordPage by lazy { WordPage(wordTexts.getValue("nxj.md")) }

private val noWords: WordPage by lazy { WordPage("") }

/** The words of Java for a [brick]. */
internal fun javaWords(brick: BrickKind): WordPage = when (brick.java) {
    JavaPlatform.LEJOS -> lejosWords
    JavaPlatform.NXJ -> nxjWords
    null -> noWords
}
