package robotran.legofirmware.edit

import robotran.languagesupport.CodeToken
import robotran.languagesupport.CodeTokenKind
import robotran.legofirmware.instructions.Opcode

/** The words around the commands of a task or subroutine. */
private val LASM_KEYWORDS = setOf("task", "endt", "sub", "ends", "byte")

/** The tokens of one [line] of LEGO's assembly text. Never throws for any input. */
internal fun tokenizeLasmLine(line: String): List<CodeToken> = LASM_TOKEN.findAll(line).map { match ->
    CodeToken(lasmKind(match.value), match.range.first, match.range.last + 1)
}.toList()

private fun lasmKind(text: String): CodeTokenKind = when {
    text.startsWith(';') -> CodeTokenKind.COMMENT
    text.first().isDigit() || (text.first() == '-' && text.length > 1) -> CodeTokenKind.NUMBER
    text.lowercase() in LASM_KEYWORDS -> CodeTokenKind.KEYWORD
    Opcode.named(text).isNotEmpty() -> CodeTokenKind.BUILT_IN
    text.first().isLetter() || text.first() == '_' -> CodeTokenKind.NAME
    else -> CodeTokenKind.SIGN
}

private val LASM_TOKEN = Regex(";.*|[A-Za-z_]\\w*|-?\\d\\w*|[^\\s\\w]")
