package robotran.blockediting.shown

import robotran.blockediting.BlockProgram
import robotran.blockediting.blocksOf
import robotran.blockediting.palette.PaletteBlock
import robotran.language.Language
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.outline.OutlineLine
import robotran.robolang.outline.PhrasePart
import robotran.robolang.outline.outlineRobolang
import robotran.robolang.words.Vocabulary
import robotran.robolang.words.inEnglish
import robotran.robolang.words.written

/** The lines of this block of the palette as it will stand in a program whose blocks show [words]. */
fun PaletteBlock.shownIn(words: Vocabulary): List<String> {
    val source = when {
        isValue -> VALUE_LINE + template
        form?.isSetting == true -> "$HEADER\n$template\n$END"
        else -> template
    }
    val messages = RobolangMessages.of(Language.ENGLISH)
    val program = blocksOf(outlineRobolang(source, messages, Vocabulary.ENGLISH), messages, previous = null, words)
    val lines = program.outline.lines.map { textOf(program, it, isValue) }
    return if (form?.isSetting == true) lines.drop(1).dropLast(1) else lines
}

/** [value], a value in the words of this program or in English, as its blocks show it. */
fun BlockProgram.shownValue(value: String): String {
    val source = inWords(VALUE_LINE) + inWords(value)
    val outline = outlineRobolang(source, messages, vocabulary, brick)
    val program = blocksOf(outline, messages, previous = null, shown)
    return textOf(program, program.outline.lines.first(), isValue = true)
}

/**
 * [code], a line or a value of a program with the words [written], as blocks show it that speak [words]. What is neither,
 * such as a single word, is shown word for word.
 */
fun shownCode(code: String, written: Vocabulary, words: Vocabulary): String {
    val messages = RobolangMessages.of(Language.ENGLISH)

    fun shown(source: String, isValue: Boolean): String? {
        val program = blocksOf(outlineRobolang(source, messages, written), messages, previous = null, words)
        val line = program.outline.lines.first()
        if (line.error != null || line.form == null) return null
        if (isValue && line.parts.lastOrNull() !is PhrasePart.Value) return null
        return textOf(program, line, isValue)
    }
    val end = written.written(END)
    return shown(code, isValue = false) ?: shown("$code\n$end", isValue = false)
        ?: shown(written.written(VALUE_LINE) + code, isValue = true) ?: words.written(written.inEnglish(code))
}

private fun textOf(program: BlockProgram, line: OutlineLine, isValue: Boolean): String = when {
    line.form == null -> program.shown.written(program.vocabulary.inEnglish(line.span.textIn(program.text).trim()))
    isValue -> ShownLine(program, line).labelOf(line.parts.last { it is PhrasePart.Value })
    else -> ShownLine(program, line).sentence
}

private const val VALUE_LINE = "var x = "
private const val HEADER = "robot"
private const val END = "end"
