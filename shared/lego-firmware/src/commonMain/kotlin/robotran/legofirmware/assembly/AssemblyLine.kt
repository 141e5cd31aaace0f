package robotran.legofirmware.assembly

import robotran.legofirmware.messages.AssemblyMessages

/**
 * A line of an assembly text that is not empty.
 *
 * @property label that it defines; null if none.
 * @property word the command or frame; null if none.
 * @property operands what stands between the commas; an empty [Token] where nothing does.
 */
internal class AssemblyLine(val label: Token?, val word: Token?, val operands: List<Token>)

/** Reads lines; reports what is no line. */
internal class AssemblyLineReader(private val sink: AssemblySink, private val messages: AssemblyMessages) {
    /** The line with this [number]; null if it is empty or has a mistake. */
    fun read(text: String, number: Int): AssemblyLine? {
        val tokens = tokensOf(text, number)
        if (tokens.isEmpty()) return null
        val unknown = tokens.find { !it.isWord && !it.isNumber && !it.isSign }
        if (unknown != null) {
            sink.error(AssemblyError.UNKNOWN_CHARACTER, unknown, messages.unknownCharacter(unknown.text))
            return null
        }
        val label = tokens[0].takeIf { it.isWord && tokens.getOrNull(1)?.text == ":" }
        val rest = if (label == null) tokens else tokens.drop(2)
        val word = rest.firstOrNull() ?: return AssemblyLine(label, null, emptyList())
        if (!word.isWord) {
            sink.error(AssemblyError.MISSING_COMMAND, word, messages.missingCommand(word.text))
            return null
        }
        return operandsOf(rest)?.let { AssemblyLine(label, word, it) }
    }

    /** What follows the command in [tokens]; null if a comma is missing. */
    private fun operandsOf(tokens: List<Token>): List<Token>? {
        if (tokens.size == 1) return emptyList()
        val operands = mutableListOf<Token>()
        var isExpected = true
        for (token in tokens.drop(1)) {
            if (token.text == ",") {
                if (isExpected) operands += Token("", token.line, token.column)
                isExpected = true
            } else {
                if (!isExpected || token.text == ":") {
                    sink.error(AssemblyError.MISSING_COMMA, token, messages.missingComma(token.text))
                    return null
                }
                operands += token
                isExpected = false
            }
        }
        if (isExpected) operands += tokens.last().after
        return operands
    }
}
