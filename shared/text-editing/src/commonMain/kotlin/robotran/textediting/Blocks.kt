package robotran.textediting

import robotran.language.ProgramLanguage
import robotran.nqc.edit.nqcBlockEffect
import robotran.robolang.RobolangWords
import robotran.textediting.code.CodeTokenKind
import robotran.textediting.code.tokenizeJavaLine
import robotran.textediting.text.isWordCharacter

/** The effect of a line on the indentation of blocks. */
internal data class BlockEffect(
    /** Whether it ends a block and so has the indentation of the block's first line. */
    val closes: Boolean,
    /** Whether the lines below it are indented further. */
    val opens: Boolean,
)

internal fun blockEffect(line: String, language: ProgramLanguage): BlockEffect = when (language) {
    ProgramLanguage.ROBOLANG -> {
        when (firstWord(line)) {
            "end" -> BlockEffect(closes = true, opens = false)
            "else" -> BlockEffect(closes = true, opens = true)
            in RobolangWords.openers -> BlockEffect(closes = false, opens = true)
            else -> BlockEffect(closes = false, opens = false)
        }
    }

    ProgramLanguage.JAVA -> {
        val braces = bracesOf(line)
        BlockEffect(
            closes = line.trimStart().startsWith('}'),
            opens = braces.lastIndexOf('{') > braces.lastIndexOf('}'),
        )
    }

    ProgramLanguage.NQC -> nqcBlockEffect(line).let { BlockEffect(it.closes, it.opens) }
    ProgramLanguage.LASM -> BlockEffect(closes = false, opens = false)
}

/** The braces of a line of Java outside strings and comments. */
private fun bracesOf(line: String): String = tokenizeJavaLine(line, startsInComment = false, brick = null).tokens
    .filter { it.kind == CodeTokenKind.SIGN }
    .joinToString("") { line.substring(it.start, it.end) }
    .filter { it == '{' || it == '}' }

private fun firstWord(line: String): String = line.trimStart().takeWhile(::isWordCharacter).lowercase()
