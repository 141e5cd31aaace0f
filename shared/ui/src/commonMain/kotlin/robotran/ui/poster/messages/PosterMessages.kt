package robotran.ui.poster.messages

import robotran.language.Language
import robotran.language.choose

/** The words that a poster adds to what the pupil wrote. */
internal interface PosterMessages {
    /** The last line of a program that is too long, in place of [count] lines. */
    fun moreLines(count: Int): String

    companion object {
        fun of(language: Language): PosterMessages = language.choose(English, Spanish, German)
    }
}

internal object English : PosterMessages {
    override fun moreLines(count: Int): String = "… and $count more lines"
}

internal object Spanish : PosterMessages {
    override fun moreLines(count: Int): String = "… y $count líneas más"
}

internal object German : PosterMessages {
    override fun moreLines(count: Int): String = "… und $count weitere Zeilen"
}
