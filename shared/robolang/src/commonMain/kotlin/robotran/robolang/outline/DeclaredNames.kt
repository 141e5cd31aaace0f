package robotran.robolang.outline

import robotran.language.source.SourceRange
import robotran.robolang.check.CheckContext
import robotran.robolang.check.NameResolver
import robotran.robolang.check.SymbolKind
import robotran.robolang.check.UnresolvedSymbol
import robotran.robolang.check.ValueType
import robotran.robolang.diagnostic.DiagnosticSink
import robotran.robolang.syntax.ParsedProgram
import robotran.robolang.words.ValueKind

/**
 * The names that the checker resolves in [parsed], the program of [outline].
 *
 * @param diagnostics the parser's mistakes; those of the checker are added.
 */
internal fun declaredNames(
    outline: ProgramOutline,
    parsed: ParsedProgram,
    offsets: LineOffsets,
    diagnostics: DiagnosticSink,
): List<DeclaredName> {
    val context = CheckContext(parsed, diagnostics)
    NameResolver(context).resolve()
    val uses = context.draftsByName.entries.groupBy({ it.value.name.range }) { it.key }
    val visibility = NameVisibility(outline.lines)
    return context.drafts.filter { it.name.text.isNotEmpty() }.map { draft ->
        val range = draft.name.range
        DeclaredName(
            draft.name.text,
            draft.name.key,
            checkNotNull(KINDS[draft.kind]),
            kindOf(draft.type.type),
            context.routinesByName[range]?.parameters.orEmpty().map { it.text },
            offsets.span(range),
            (uses[range].orEmpty() + range).distinct().sortedWith(IN_ORDER).map(offsets::span),
            visibility.of(draft),
        )
    }.sortedBy { it.declaredAt.start }
}

private val IN_ORDER = compareBy<SourceRange>({ it.line }, { it.column })

private val KINDS = mapOf(
    SymbolKind.CONSTANT to NameKind.CONSTANT,
    SymbolKind.VARIABLE to NameKind.VARIABLE,
    SymbolKind.PARAMETER to NameKind.PARAMETER,
    SymbolKind.LOOP_VARIABLE to NameKind.LOOP_VARIABLE,
    SymbolKind.PROCEDURE to NameKind.PROCEDURE,
    SymbolKind.FUNCTION to NameKind.FUNCTION,
)

private fun kindOf(type: ValueType): ValueKind = when {
    type.isNumber -> ValueKind.NUMBER
    type.isList -> ValueKind.LIST
    type == ValueType.TRUTH -> ValueKind.CONDITION
    type == ValueType.COLOUR -> ValueKind.COLOUR
    else -> ValueKind.UNKNOWN
}

/** Where names are visible, by the blocks of a program. The name resolver has the same rules; a test compares them. */
private class NameVisibility(private val lines: List<OutlineLine>) {
    /** The first line below each that is in fewer blocks. */
    private val shallower = IntArray(lines.size) { lines.size }

    /** The first line below each that is in no more blocks. */
    private val notDeeper = IntArray(lines.size) { lines.size }

    init {
        fill(shallower) { above, line -> line < above }
        fill(notDeeper) { above, line -> line <= above }
    }

    private fun fill(found: IntArray, ends: (above: Int, line: Int) -> Boolean) {
        val open = ArrayDeque<Int>()
        lines.forEachIndexed { index, line ->
            while (open.isNotEmpty() && ends(lines[open.last()].depth, line.depth)) found[open.removeLast()] = index
            open.addLast(index)
        }
    }

    fun of(draft: UnresolvedSymbol): IntRange {
        val declaring = draft.name.range.line - 1
        return when (draft.kind) {
            SymbolKind.PROCEDURE, SymbolKind.FUNCTION, SymbolKind.BUILT_IN -> 0..lines.size
            SymbolKind.PARAMETER, SymbolKind.LOOP_VARIABLE -> declaring + 1..notDeeper[declaring]
            SymbolKind.CONSTANT, SymbolKind.VARIABLE -> declaring + 1..shallower[declaring]
        }
    }
}
