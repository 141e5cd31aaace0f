package robotran.languagesupport

/**
 * The text that follows a completed word that cannot stand alone.
 *
 * @property text the text behind the word.
 * @property caret the offset of the caret in [text] afterwards.
 * @property selected how many characters before the caret are selected, so that typing replaces them.
 */
class CompletionSuffix private constructor(val text: String, val caret: Int, val selected: Int) {
    companion object {
        /**
         * Parses [marked]: `|` marks the caret, and two of them enclose the selection. Without a mark, the caret is at
         * the end.
         */
        fun of(marked: String): CompletionSuffix {
            val parts = marked.split('|')
            val text = parts.joinToString("")
            return when (parts.size) {
                1 -> CompletionSuffix(text, text.length, 0)
                2 -> CompletionSuffix(text, parts[0].length, 0)
                else -> CompletionSuffix(text, parts[0].length + parts[1].length, parts[1].length)
            }
        }
    }
}

/** The completion of [word], with its [suffix] if it has one and nothing follows the caret yet. */
fun completionOf(word: String, suffix: CompletionSuffix?, help: CompletionHelp): Completion {
    if (suffix == null) return Completion(word, CompletionKind.WORD, help = help.of(word))
    return Completion(
        word,
        CompletionKind.WORD,
        word + suffix.text,
        word.length + suffix.caret,
        help.of(word),
        suffix.selected,
    )
}
