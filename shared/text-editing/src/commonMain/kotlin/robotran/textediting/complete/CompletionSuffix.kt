package robotran.textediting.complete

/**
 * What comes into the text with a word that says nothing alone, so that one can write on at once.
 *
 * @property text what stands behind the word.
 * @property caret where in [text] the caret is afterwards.
 * @property selected how many characters before the caret are selected, for a value to be written over.
 */
internal class CompletionSuffix private constructor(val text: String, val caret: Int, val selected: Int) {
    companion object {
        /**
         * Reads [marked]: what is between two strokes is selected, a single one is where the caret is; otherwise it is
         * at the end.
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

/** [word] with its [ending], if it has one and nothing stands behind the caret yet. */
internal fun completionOf(word: String, ending: CompletionSuffix?, help: WordHelp): Completion {
    if (ending == null) return Completion(word, CompletionKind.WORD, help = help.of(word))
    return Completion(
        word,
        CompletionKind.WORD,
        word + ending.text,
        word.length + ending.caret,
        help.of(word),
        ending.selected,
    )
}
