package robotran.robolang.check

import robotran.language.source.SourceRange
import robotran.robolang.syntax.Name
import robotran.robolang.syntax.Routine

/** The variables and routines that each routine uses, directly or through other routines. */
internal class CallGraph(private val context: CheckContext) {
    private val routines = context.tree.routines
    private val uses = routines.map { routine -> Uses().apply { add(routine.body) } }
    private val places = routines.withIndex().associate { (place, routine) -> routine.range to place }
    private val callees: List<Set<Int>> = uses.map { use -> use.calls.mapNotNullTo(mutableSetOf(), ::placeOf) }

    /** The global declared last that a call of [routine] may use; null if there is none. */
    fun latestGlobal(routine: Routine): UnresolvedSymbol? = latestGlobals[places.getValue(routine.range)]

    /** The routines that may run repeatedly: recursive ones, those called [repeatedly], and all that these call. */
    fun repeated(repeatedly: List<Routine>): Set<SourceRange> {
        val recursive = routines.indices.filter { it in reached(callees[it]) }
        return reached(
            recursive + repeatedly.map {
                places.getValue(it.range)
            },
        ).mapTo(mutableSetOf()) { routines[it].range }
    }

    private val latestGlobals: Map<Int, UnresolvedSymbol> by lazy {
        val callers = List(routines.size) { mutableSetOf<Int>() }
        callees.forEachIndexed { caller, called -> called.forEach { callers[it] += caller } }
        val users = mutableMapOf<UnresolvedSymbol, MutableSet<Int>>()
        uses.forEachIndexed { place, use ->
            use.variables.mapNotNull(context::globalOf).forEach { users.getOrPut(it) { mutableSetOf() } += place }
        }
        val latest = mutableMapOf<Int, UnresolvedSymbol>()
        for ((global, direct) in users.entries.sortedByDescending { it.key.name.range.line }) {
            val waiting = ArrayDeque(direct)
            while (waiting.isNotEmpty()) {
                val place = waiting.removeLast()
                if (latest.put(place, latest[place] ?: global) == null) waiting += callers[place]
            }
        }
        latest
    }

    /** The routines [from] and all that they call, directly or indirectly. */
    private fun reached(from: Collection<Int>): Set<Int> {
        val reached = mutableSetOf<Int>()
        val waiting = ArrayDeque(from)
        while (waiting.isNotEmpty()) {
            val place = waiting.removeLast()
            if (reached.add(place)) waiting += callees[place]
        }
        return reached
    }

    private fun placeOf(call: Name): Int? = context.routineOf(call)?.let { places[it.range] }
}

/** The global variable or constant [name]. */
internal fun CheckContext.globalOf(name: Name): UnresolvedSymbol? = draftsByName[name.range]?.takeIf {
    it.isGlobal && it.kind != SymbolKind.PROCEDURE && it.kind != SymbolKind.FUNCTION
}
