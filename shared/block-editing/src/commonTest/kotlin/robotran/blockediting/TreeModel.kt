package robotran.blockediting

/**
 * A second, simple idea of blocks: a tree of lines without their indentation. It says what an edit should make of the
 * blocks, without any text.
 */
internal class TreeModel private constructor(val nodes: MutableList<Node>) {
    class Node(val heads: MutableList<String>, val slots: MutableList<MutableList<Node>>, val isConstruct: Boolean)

    /** The tree after [edit] of [program]; null if this model does not know. */
    fun after(program: BlockProgram, edit: BlockEdit): String? {
        when (edit) {
            is BlockEdit.Move -> move(program, edit)

            is BlockEdit.Insert -> list(program, edit.place).addAll(edit.place.index, of(blocksOf(edit.text)).nodes)

            is BlockEdit.Duplicate -> {
                val place = checkNotNull(program.placeOf(edit.run.first))
                val count = checkNotNull(program.blocksOf(edit.run)).size
                val copies = of(program).list(program, place).subList(place.index, place.index + count)
                list(program, place).addAll(place.index + count, copies)
            }

            is BlockEdit.Delete -> {
                val place = checkNotNull(program.placeOf(edit.blocks.single()))
                list(program, place).removeAt(place.index)
            }

            else -> return null
        }
        return toString()
    }

    private fun move(program: BlockProgram, edit: BlockEdit.Move) {
        val from = checkNotNull(program.placeOf(edit.run.first))
        val count = checkNotNull(program.blocksOf(edit.run)).size
        val target = list(program, edit.place)
        val source = list(program, from)
        val moved = source.subList(from.index, from.index + count).toList()
        val isBehind = source === target && edit.place.index > from.index
        if (source === target && edit.place.index in from.index..from.index + count) return
        repeat(count) { source.removeAt(from.index) }
        target.addAll(if (isBehind) edit.place.index - count else edit.place.index, moved)
    }

    private fun list(program: BlockProgram, place: BlockPlace): MutableList<Node> {
        val parent = place.parent ?: return nodes
        val at = checkNotNull(program.placeOf(parent))
        return list(program, at)[at.index].slots[place.slot]
    }

    override fun toString(): String = buildString { add(nodes, "") }

    private fun StringBuilder.add(nodes: List<Node>, indentation: String) {
        for (node in nodes) {
            node.heads.forEachIndexed { index, head ->
                append(indentation).append(head).append('\n')
                node.slots.getOrNull(index)?.let { add(it, "$indentation  ") }
            }
            // Whether the end is there does not matter: an edit may write it.
            if (node.isConstruct) append(indentation).append("end\n")
        }
    }

    companion object {
        fun of(program: BlockProgram): TreeModel = TreeModel(nodes(program, program.blocks))

        private fun nodes(program: BlockProgram, blocks: List<Block>): MutableList<Node> = blocks.mapTo(mutableListOf()) { block ->
            fun text(line: robotran.robolang.outline.OutlineLine) = line.span.textIn(program.text).trim()
            if (block is Block.Construct) {
                Node(
                    block.slots.mapTo(mutableListOf()) { text(it.head) },
                    block.slots.mapTo(mutableListOf()) { nodes(program, it.blocks) },
                    isConstruct = true,
                )
            } else {
                Node(mutableListOf(text(block.head)), mutableListOf(), isConstruct = false)
            }
        }
    }
}
