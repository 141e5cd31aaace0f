package robotran.build.wasm

import java.util.BitSet

/**
 * What a part of a module needs: all that its own functions, initial values and segments refer to, and the types of all
 * these.
 *
 * @param owns whether what is at an index belongs to the part. What belongs to another part is imported from there.
 */
internal class WasmReach(private val contents: WasmContents, private val owns: (IndexSpace, Int) -> Boolean) {
    private val found = IndexSpace.entries.associateWith { BitSet() }
    private val waiting = ArrayDeque<Pair<IndexSpace, Int>>()

    /** The functions whose references are taken by code of the part. The format wants them to be declared. */
    private val taken = BitSet()

    val declared: List<Int> get() = taken.toList()

    /** What the part needs in [space], in ascending order. */
    operator fun get(space: IndexSpace): List<Int> = found.getValue(space).toList()

    fun has(space: IndexSpace, index: Int): Boolean = found.getValue(space)[index]

    /** Adds all that is needed for what is [index] in [space]. */
    fun add(space: IndexSpace, index: Int) {
        note(space, index)
        while (waiting.isNotEmpty()) {
            val (next, at) = waiting.removeLast()
            if (next == IndexSpace.TYPE) search(contents.types.groupOf(at)) else search(next, at)
        }
    }

    private fun note(space: IndexSpace, index: Int) {
        val indices = found.getValue(space)
        if (indices[index]) return
        if (space == IndexSpace.TYPE) {
            contents.types.typesOf(contents.types.groupOf(index)).forEach(indices::set)
        } else {
            indices.set(index)
        }
        waiting.add(space to index)
    }

    private fun search(group: Int) {
        val types = contents.types.groups[group]
        WasmCopier(WasmReader(types)) { space, index -> index.also { note(space, it) } }.typeGroup()
    }

    private fun search(space: IndexSpace, index: Int) {
        val isCode = space == IndexSpace.FUNCTION
        val notice = IndexMap { where, target ->
            if (where == IndexSpace.REFERENCE && isCode) taken.set(target)
            note(if (where == IndexSpace.REFERENCE) IndexSpace.FUNCTION else where, target)
            target
        }
        if (space !in SEGMENTS) contents.copyType(space, index, notice)
        if (index in contents.definedIn(space) && owns(space, index)) contents.copyDefinition(space, index, notice)
    }

    private fun BitSet.toList(): List<Int> = stream().toArray().asList()

    private companion object {
        val SEGMENTS = setOf(IndexSpace.ELEMENT, IndexSpace.DATA)
    }
}
