package robotran.javacompiler.diagnose

/** A word, a number or a sign of a source, at [start]. */
internal class CodeToken(val text: String, val start: Int) {
    val end get() = start + text.length

    val isWord get() = text.first().isJavaLetter()
}

/** The words, numbers and signs of [code], which has no comments and no contents of texts. */
internal fun tokensOf(code: String): List<CodeToken> {
    val tokens = mutableListOf<CodeToken>()
    var place = 0
    while (place < code.length) {
        if (code[place].isWhitespace()) {
            place++
            continue
        }
        var end = place + 1
        if (code[place].isJavaLetter() || code[place].isDigit()) {
            while (end < code.length && (code[end].isJavaLetter() || code[end].isDigit())) end++
        }
        tokens += CodeToken(code.substring(place, end), place)
        place = end
    }
    return tokens
}

private fun Char.isJavaLetter() = isLetter() || this == '_' || this == '$'
