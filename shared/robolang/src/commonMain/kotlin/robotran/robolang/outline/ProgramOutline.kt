package robotran.robolang.outline

import robotran.brick.kind.BrickKind
import robotran.language.source.SourceSpan
import robotran.robolang.syntax.ParsedText
import robotran.robolang.words.ValueKind

/**
 * The lines of a program, each with what it says and the blocks that it is in. An editor that shows a program in another
 * way, such as in blocks, works on it. A line with a mistake does not change what the other lines say.
 *
 * @property brick the brick of the robot that it was read for.
 * @property lines all lines; a text that ends in a line break has an empty last one. Their offsets have neither gaps nor
 * overlaps, except that a byte order mark stands before the first line.
 * @property parsed what the compiler needs of it; null for a text that is too long.
 */
class ProgramOutline internal constructor(
    val source: String,
    val brick: BrickKind,
    val lines: List<OutlineLine>,
    val parsed: ParsedText?,
    findNames: (ProgramOutline) -> List<DeclaredName>,
) {
    /** The names that the program declares, with all their uses, in source order. */
    val names: List<DeclaredName> by lazy { findNames(this) }

    /**
     * The names that a line may use if it is inserted before the line [index], from 0 to the number of lines. A name
     * that is hidden by a nearer one of the same spelling is left out.
     */
    fun namesBefore(index: Int): List<DeclaredName> {
        val visible = LinkedHashMap<Pair<String, Boolean>, DeclaredName>()
        for (name in names) {
            if (index !in name.visibleAt) continue
            // Of two routines with one name the first counts, of two variables the nearest.
            if (name.isRoutine) visible.getOrPut(name.key to true) { name } else visible[name.key to false] = name
        }
        return visible.values.toList()
    }
}

/** The kinds of names that a program can declare. */
enum class NameKind { CONSTANT, VARIABLE, PARAMETER, LOOP_VARIABLE, PROCEDURE, FUNCTION }

/**
 * A name that a program declares.
 *
 * @property text its spelling in its declaration.
 * @property key its spelling for comparison; names ignore the case of A to Z.
 * @property type the type of its value, or of what a function returns.
 * @property parameters the names of a routine's parameters.
 * @property declaredAt where it is declared.
 * @property uses where it is declared and used, in source order.
 * @property visibleAt the indices of the lines, from 0, before which a line that uses it may be inserted.
 */
class DeclaredName internal constructor(
    val text: String,
    val key: String,
    val kind: NameKind,
    val type: ValueKind,
    val parameters: List<String>,
    val declaredAt: SourceSpan,
    val uses: List<SourceSpan>,
    val visibleAt: IntRange,
) {
    /** Whether it is called with brackets. A variable may have the same name as a routine. */
    val isRoutine: Boolean get() = kind == NameKind.PROCEDURE || kind == NameKind.FUNCTION
}
