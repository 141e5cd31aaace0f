package robotran.uikit

import androidx.compose.ui.unit.sp

/**
 * The sizes of text, each with its [LineHeights]. All text is in the system's sans serif but programs, which have a
 * font of their own ([codeStyle]); weights tell titles from text. docs/design.md says why.
 */
object TextSizes {
    /** Numbers and single words in or beside a drawing. Nothing that has to be read to go on. */
    val SIGN = 12.sp

    /** Remarks: how long, how many, when. */
    val SMALL = 14.sp

    /** Rows of dense lists and panels, and program text. */
    val COMPACT = 15.sp

    /** Sentences and buttons. */
    val BODY = 16.sp

    /** Titles of cards and sections. */
    val LEAD = 18.sp

    /** Titles of dialogs, and the words of the main choice. */
    val HEADING = 20.sp

    /** Titles of pages. */
    val TITLE = 22.sp

    /** Figures on keys. */
    val KEY = 24.sp

    /** The welcome. Nothing else is as large. */
    val DISPLAY = 30.sp
}

/** The line heights of [TextSizes]: 1.4 for a few words, 1.5 for sentences, less for large text. */
object LineHeights {
    val SIGN = 14.sp
    val TIGHT = 18.sp
    val SMALL = 20.sp
    val COMPACT = 21.sp
    val LABEL = 22.sp
    val BODY = 24.sp
    val LEAD = 26.sp
    val HEADING = 28.sp
    val DISPLAY = 36.sp
}
