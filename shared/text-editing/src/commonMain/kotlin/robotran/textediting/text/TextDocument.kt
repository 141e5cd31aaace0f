package robotran.textediting.text

import robotran.languagesupport.TextLines

/**
 * The text that the pupil edits, with the caret and the selection.
 *
 * @property text the text, with lines that end in `\n`.
 */
data class TextDocument(val text: String, val selection: TextSelection = TextSelection(0)) {
    val lines: TextLines by lazy(LazyThreadSafetyMode.PUBLICATION) { TextLines(text) }

    val selectedText: String get() = text.substring(selection.start, selection.end)

    /** This text with nothing selected and the caret at [offset], which is limited to the text. */
    fun withCaret(offset: Int): TextDocument = copy(selection = TextSelection(offset).within(text.length))

    /** This text with the selection replaced by [inserted] and the caret behind it. */
    fun replaced(inserted: String): TextDocument = replaced(selection.start, selection.end, inserted)

    /** This text with the part from [start] to before [end] replaced by [inserted] and the caret behind it. */
    fun replaced(start: Int, end: Int, inserted: String): TextDocument =
        TextDocument(text.replaceRange(start, end, inserted), TextSelection(start + inserted.length))
}

/**
 * The selection in a text, as offsets between characters. The two offsets are equal if nothing is selected.
 *
 * @property anchor where the selection began.
 * @property caret the end of the selection that moves, where typed text goes.
 */
data class TextSelection(val anchor: Int, val caret: Int = anchor) {
    val start: Int get() = minOf(anchor, caret)
    val end: Int get() = maxOf(anchor, caret)
    val isEmpty: Boolean get() = anchor == caret

    /** This selection, limited to a text of [length] characters. */
    fun within(length: Int): TextSelection = TextSelection(anchor.coerceIn(0, length), caret.coerceIn(0, length))
}
