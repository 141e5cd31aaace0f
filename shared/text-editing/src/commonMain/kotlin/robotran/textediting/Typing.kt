package robotran.textediting

import robotran.languagesupport.CodeSyntax
import robotran.textediting.text.Draft
import robotran.textediting.text.TextSelection
import robotran.textediting.text.widthAt
import robotran.textediting.text.widthBefore

/**
 * This text with [typed] typed or pasted. A line that now ends a block gets the indentation of the block's first line.
 */
fun Draft.typed(typed: String, syntax: CodeSyntax): Draft {
    if (typed == "\n") return withLineBreak(syntax)
    val after = replaced(typed.replace("\r\n", "\n").replace('\r', '\n').replace("\t", syntax.indent))
    return if (typed.length == 1) after.withBlockEndAligned(syntax) else after
}

/** This text with a line break at the caret, and the new line indented. */
fun Draft.withLineBreak(syntax: CodeSyntax): Draft {
    val position = selection.start
    val line = lines.lineOf(position)
    val before = text.substring(lines.start(line), position)
    val indent = indentOf(before)
    val deeper = if (syntax.blockEffect(before).opens) indent + syntax.indent else indent
    val rest = text.substring(selection.end, lines.end(lines.lineOf(selection.end)))
    val broken = replaced("\n" + deeper)
    val closesAtOnce = "}" in syntax.blockEnds && deeper != indent && rest.trimStart().startsWith('}')
    return if (closesAtOnce) broken.withBehindCaret("\n" + indent, rest) else broken.withoutBlanksBehindCaret(rest)
}

/** Moves a closing brace behind the caret to its own line. */
private fun Draft.withBehindCaret(inserted: String, rest: String): Draft {
    val caret = selection.caret
    return Draft(text.replaceRange(caret, caret + rest.length - rest.trimStart().length, inserted), selection)
}

private fun Draft.withoutBlanksBehindCaret(rest: String): Draft =
    Draft(text.removeRange(selection.caret, selection.caret + rest.length - rest.trimStart().length), selection)

private fun Draft.withBlockEndAligned(syntax: CodeSyntax): Draft {
    val line = lines.lineOf(selection.caret)
    val content = lines.line(line)
    if (selection.caret != lines.end(line) || content.trim().lowercase() !in syntax.blockEnds) return this
    val indent = indentOf(content)
    val expected = indentOfOpener(line, syntax) ?: return this
    if (expected == indent) return this
    val start = lines.start(line)
    return Draft(
        text.replaceRange(start, start + indent.length, expected),
        TextSelection(selection.caret + expected.length - indent.length),
    )
}

/** The indentation of the block that [line] ends; null if there is no such block. */
private fun Draft.indentOfOpener(line: Int, syntax: CodeSyntax): String? {
    var open = 0
    for (above in line - 1 downTo maxOf(0, line - MAX_LINES_OF_A_BLOCK)) {
        val content = lines.line(above)
        val effect = syntax.blockEffect(content)
        if (effect.opens) {
            if (open == 0) return indentOf(content)
            open--
        }
        if (effect.closes) open++
    }
    return null
}

/**
 * This text without its selection or, if nothing is selected, without the character before the caret. Leading spaces
 * are deleted one indentation level at a time.
 */
fun Draft.erasedBackwards(syntax: CodeSyntax): Draft {
    if (!selection.isEmpty) return replaced("")
    val caret = selection.caret
    if (caret == 0) return this
    val before = text.substring(lines.start(lines.lineOf(caret)), caret)
    val step = syntax.indent.length
    val blanks = if (before.isNotEmpty() && before.all { it == ' ' }) {
        (before.length - 1) % step + 1
    } else {
        widthBefore(text, caret)
    }
    return replaced(caret - blanks, caret, "")
}

/** This text without its selection or, if nothing is selected, without the character behind the caret. */
fun Draft.erasedForwards(): Draft {
    if (!selection.isEmpty) return replaced("")
    val caret = selection.caret
    return if (caret == text.length) this else replaced(caret, caret + widthAt(text, caret), "")
}

/** This text without its selection or, if nothing is selected, without the word before the caret. */
fun Draft.wordErasedBackwards(): Draft =
    if (selection.isEmpty) replaced(wordStartBefore(text, selection.caret), selection.caret, "") else replaced("")

/** This text without its selection or, if nothing is selected, without the word behind the caret. */
fun Draft.wordErasedForwards(): Draft =
    if (selection.isEmpty) replaced(selection.caret, wordEndAfter(text, selection.caret), "") else replaced("")

/** The search for the beginning of a block stops after this many lines. */
private const val MAX_LINES_OF_A_BLOCK = 500
