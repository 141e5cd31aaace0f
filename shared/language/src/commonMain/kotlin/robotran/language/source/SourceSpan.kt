package robotran.language.source

/**
 * A part of a source text.
 *
 * @property start the offset of its first character, in UTF-16 characters from 0.
 * @property end the offset behind its last character.
 */
data class SourceSpan(val start: Int, val end: Int) {
    val length: Int get() = end - start

    fun textIn(source: String): String = source.substring(start, end)

    operator fun contains(other: SourceSpan): Boolean = start <= other.start && other.end <= end
}
