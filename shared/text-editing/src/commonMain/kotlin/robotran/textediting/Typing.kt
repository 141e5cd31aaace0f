package robotran.textediting

import robotran.languagesupport.CodeSyntax
import robotran.textediting.text.TextDocument
import robotran.textediting.text.TextSelection
import robotran.textediting.text.widthAt
import robotran.textediting.text.widthBefore

/**
 * This text with [typed] typed or pasted. A line that now ends a block gets the indentation of the block's first line.
 */
fun TextDocument.typed(typed: String, syntax: CodeSyntax): TextDocument {
    if (typed == "\n") return withLineBreak(syntax)
    val after = replaced(typed.replace("\r\n", "\n").replace('\r', '\n').replace("\t", syntax.indent))
    return if (typed.length == 1) after.withBlockEndAligned(syntax) else after
}

/** This text with a line break at the caret, and the new line indented. */
fun TextDocument.withLineBreak(syntax: CodeSyntax): TextDocument {
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
private fun TextDocument.withBehindCaret(inserted: String, rest: String): TextDocument {
    val caret = selection.caret
    return TextDocument(text.replaceRange(caret, caret + rest.length - rest.trimStart().length, inserted), selection)
}

private fun TextDocument.withoutBlanksBehindCaret(rest: String): TextDocument =
    TextDocument(text.removeRange(selection.caret, selection.caret + rest.length - rest.trimStart().length), selection)

private fun TextDocument.withBlockEndAligned(syntax: CodeSyntax): TextDocument {
    val line = lines.lineOf(selection.caret)
    val content = lines.line(line)
    if (selection.caret != lines.end(line) || content.trim().lowercase() !in syntax.blockEnds) return this
    val indent = indentOf(content)
    val expected = indentOfOpener(line, syntax) ?: return this
    if (expected == indent) return this
    val start = lines.start(line)
    return TextDocument(
        text.replaceRange(start, start + indent.length, expected),
        TextSelection(selection.caret + expected.length - indent.length),
    )
}

/** The indentation of the block that [line] ends; null if there is no such block. */
private fun TextDocument.indentOfOpener(line: Int, syntax: CodeSyntax): String? {
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
fun TextDocument.erasedBackwards(syntax: CodeSyntax): TextDocument {
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
fun TextDocument.erasedForwards(): TextDocument {
    if (!selection.isEmpty) return replaced("")
    val caret = selection.caret
    return if (caret == text.length) this else replaced(caret, caret + widthAt(text, caret), "")
}

/** This text without its selection or, if nothing is selected, without the word before the caret. */
fun TextDocument.wordErasedBackwards(): TextDocument =
    if (selection.isEmpty) replaced(wordStartBefore(text, selection.caret), selection.caret, "") else replaced("")

/** This text without its selection or, if nothing is selected, without the word behind the caret. */
fun TextDocument.wordErasedForwards(): TextDocument =
    if (selection.isEmpty) replaced(selection.caret, wordEndAfter(text, selection.caret), "") else replaced("")

/** The search for the beginning of a block stops after this many lines. */
private const val MAX_LINES_OF_A_BLOCK = 500
