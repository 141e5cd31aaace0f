package robotran.javacompiler.diagnose

import robotran.javacompiler.messages.JavaMessages
import robotran.language.pasted.PastedCharacter
import robotran.language.pasted.pastedCharacter
import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.language.source.SourceFix
import robotran.languagesupport.SourceFile

/**
 * The characters of [source] that come from a word processor or a web page, outside of its comments and texts.
 *
 * @param linesWithErrors the lines, from 1, in which the compiler finds a mistake. Letters that are only wide or
 * invisible may be part of a name, so they are told only if their line has a mistake.
 */
internal class PastedCharacters(private val source: SourceFile, linesWithErrors: Set<Int>) {
    private class Found(val place: Int, val pasted: PastedCharacter)

    private val text = SourceText(source)
    private val found = inCode().groupBy { text.range(it.place, it.place).line }.filter { (line, all) ->
        line in linesWithErrors || all.any { !isPartOfName(it.pasted) }
    }

    /** The lines with such characters, from 1. */
    val lines: Set<Int> get() = found.keys

    /** The source as the keyboard would have written it, with the same lines. */
    fun plain(): SourceFile {
        val byPlace = found.values.flatten().associateBy { it.place }
        val plain = source.text.mapIndexed { place, character ->
            byPlace[place]?.pasted?.plain?.replace('\n', ' ') ?: character.toString()
        }
        return source.copy(text = plain.joinToString(""))
    }

    /** A mistake for each line, with a fix for the whole line. */
    fun diagnostics(messages: JavaMessages): List<Diagnostic> = found.map { (_, all) ->
        val first = all.first()
        val span = text.range(first.place, first.place + 1)
        Diagnostic(
            file = source.name,
            severity = Severity.ERROR,
            range = span,
            text = first.pasted.character.toString(),
            message = messages.pasted(first.pasted),
            fix = SourceFix(text.range(first.place, all.last().place + 1), plainPart(all)),
        )
    }

    private fun plainPart(all: List<Found>): String {
        val byPlace = all.associateBy { it.place }
        return (all.first().place..all.last().place).joinToString("") { place ->
            byPlace[place]?.pasted?.plain ?: source.text[place].toString()
        }
    }

    private fun isPartOfName(pasted: PastedCharacter) =
        pasted.plain.isEmpty() || (pasted.plain.length == 1 && pasted.plain[0].isLetterOrDigit())

    private fun inCode(): List<Found> {
        val found = mutableListOf<Found>()
        val written = source.text
        var place = 0
        while (place < written.length) {
            val pasted = pastedCharacter(written[place])
            if (pasted != null) found += Found(place, pasted)
            val mark = pasted?.plain ?: written[place].toString()
            val end = when {
                written.startsWith("//", place) -> endOfLine(place)
                written.startsWith("/*", place) -> endOfComment(place)
                mark == "\"" || mark == "'" -> endOfQuoted(place, mark, found)
                else -> place + 1
            }
            place = end
        }
        return found
    }

    /** The place behind the quoted text that begins at [start] with a [mark], curly or not. */
    private fun endOfQuoted(start: Int, mark: String, found: MutableList<Found>): Int {
        val lineEnd = endOfLine(start)
        val straight = mark.single()
        var end = start + 1
        while (end < lineEnd && source.text[end] != straight) {
            val pasted = pastedCharacter(source.text[end])
            val isClosed = pasted?.plain == mark && (source.text[start] != straight || !isClosedLater(end, straight))
            if (isClosed) {
                found += Found(end, checkNotNull(pasted))
                return end + 1
            }
            end += if (source.text[end] == '\\') 2 else 1
        }
        return minOf(end + 1, source.text.length)
    }

    private fun isClosedLater(offset: Int, mark: Char) = source.text.substring(offset, endOfLine(offset)).contains(mark)

    private fun endOfComment(offset: Int): Int =
        source.text.indexOf("*/", offset + 2).let { if (it < 0) source.text.length else it + 2 }

    private fun endOfLine(offset: Int): Int =
        source.text.indexOfAny(charArrayOf('\n', '\r'), offset).let { if (it < 0) source.text.length else it }
}
