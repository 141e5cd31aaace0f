package robotran.textediting.text

/**
 * A text that somebody writes, and the place in it where they are.
 *
 * @property text its lines end in `\n`.
 */
data class Draft(val text: String, val selection: TextSelection = TextSelection(0)) {
    /** Where the lines of [text] are. */
    val lines: TextLines by lazy(LazyThreadSafetyMode.PUBLICATION) { TextLines(text) }

    /** What is selected. */
    val selectedText: String get() = text.substring(selection.start, selection.end)

    /** This text with the caret at [offset], or as near to it as there is a place, and nothing selected. */
    fun withCaret(offset: Int): Draft = copy(selection = TextSelection(offset).within(text.length))

    /** What is selected, replaced by [inserted], with the caret behind it. */
    fun replaced(inserted: String): Draft = replaced(selection.start, selection.end, inserted)

    /** What is from [start] up to [end], replaced by [inserted], with the caret behind it. */
    fun replaced(start: Int, end: Int, inserted: String): Draft =
        Draft(text.replaceRange(start, end, inserted), TextSelection(start + inserted.length))
}

/**
 * What is selected of a text, as places between its characters; the two are the same where nothing is.
 *
 * @property anchor where the selecting began.
 * @property caret where it has come to, and where one writes.
 */
data class TextSelection(val anchor: Int, val caret: Int = anchor) {
    val start: Int get() = minOf(anchor, caret)
    val end: Int get() = maxOf(anchor, caret)
    val isEmpty: Boolean get() = anchor == caret

    /** The same in a text of [length] characters. */
    fun within(length: Int): TextSelection = TextSelection(anchor.coerceIn(0, length), caret.coerceIn(0, length))
}

/** A piece of a text, from [start] up to but without [end]. */
data class TextSpan(val start: Int, val end: Int) {
    val length: Int get() = end - start
}
