package robotran.robolang.check

import robotran.robolang.syntax.Name
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.Routine

/** A symbol during name resolution. */
internal class UnresolvedSymbol(
    val name: Name,
    val kind: SymbolKind,
    val owner: Routine?,
    val index: Int,
    val isGlobal: Boolean,
    val type: TypeNode = TypeNode(),
) {
    var isRead = false
    var isAssigned = false

    /** The value of a constant with a literal number. */
    var constant: NumberValue? = null

    /** The length of its initial list. */
    var listLength: Int? = null

    fun symbol(): Symbol = Symbol(name.text, kind, type.type, name.range, owner, index, isGlobal)
}

/** The variables in scope: those of the open blocks. */
internal class Scopes {
    private val visible = mutableMapOf<String, UnresolvedSymbol>()
    private val blocks = ArrayDeque<MutableList<Pair<String, UnresolvedSymbol?>>>()

    fun enter() {
        blocks.addLast(mutableListOf())
    }

    fun leave() {
        for ((key, hidden) in blocks.removeLast().asReversed()) {
            if (hidden == null) visible.remove(key) else visible[key] = hidden
        }
    }

    operator fun get(key: String): UnresolvedSymbol? = visible[key]

    fun declare(draft: UnresolvedSymbol) {
        blocks.lastOrNull()?.add(draft.name.key to visible[draft.name.key])
        visible[draft.name.key] = draft
    }

    val keys: Collection<String> get() = visible.keys
}
