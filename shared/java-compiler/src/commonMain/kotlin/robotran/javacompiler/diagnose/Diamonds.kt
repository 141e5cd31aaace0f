package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.ecj.ProblemId
import robotran.languagesupport.SourceFile

/**
 * The empty `<>` of [sources]. Where the Java of a brick has none, they keep ECJ from telling the syntax errors around
 * them: it guesses others, or none.
 */
internal class Diamonds(private val sources: List<SourceFile>) {
    private val places: Map<String, List<Diamond>> = sources.associate { source ->
        source.name to DIAMOND.findAll(CodeOnly(source.text).text)
            .map { found ->
                Diamond(found.range.last + 1, found.groupValues[1].length, found.groupValues[2].length)
            }.toList()
    }

    val isEmpty: Boolean get() = places.values.all { it.isEmpty() }

    /** The sources with blanks for the `<>`, as long as before. */
    fun blanked(): List<SourceFile> = sources.map { source ->
        val text = StringBuilder(source.text)
        for (place in places.getValue(source.name)) {
            for (each in place.end - place.bracketsLength..<place.end) text[each] = ' '
        }
        source.copy(text = text.toString())
    }

    /** A problem for each of them. */
    fun problems(): List<EcjProblem> = places.flatMap { (path, all) ->
        all.map { place ->
            EcjProblem(
                path,
                ProblemId.DIAMOND,
                isError = true,
                isSyntax = false,
                start = place.end - place.length,
                end = place.end,
                message = "",
                arguments = emptyList(),
                members = emptyList(),
            )
        }
    }

    /** The class and its brackets, of [length] characters together, before the offset [end]. */
    private class Diamond(val end: Int, val length: Int, val bracketsLength: Int)

    private companion object {
        /** The class of a new object, and the brackets behind it. */
        val DIAMOND = Regex("""\bnew\s+([\w.]+\s*(<\s*>))""")
    }
}
