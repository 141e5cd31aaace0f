package robotran.blockediting

import robotran.language.Language
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.outline.OutlineLine

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
            is BlockEdit.Insert -> list(
                program,
                edit.place,
            ).addAll(edit.place.index, of(blocksOf(edit.text, messages = RobolangMessages.of(Language.ENGLISH))).nodes)

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

            is BlockEdit.Wrap -> wrap(program, edit)
            is BlockEdit.Unwrap -> unwrap(program, edit)

            is BlockEdit.AddElse -> {
                val heads = node(program, edit.construct).heads
                val otherwise = heads.indexOfFirst { it.substringBefore("//").trim().lowercase() == "else" }
                val index = if (otherwise < 0) heads.size else otherwise
                heads.add(index, if (edit.condition == null) "else" else "else if ${edit.condition}")
                node(program, edit.construct).slots.add(index, mutableListOf())
            }

            is BlockEdit.RemoveElse -> {
                node(program, edit.construct).heads.removeAt(edit.slot)
                node(program, edit.construct).slots.removeAt(edit.slot)
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

    private fun wrap(program: BlockProgram, edit: BlockEdit.Wrap) {
        val place = checkNotNull(program.placeOf(edit.run.first))
        val count = checkNotNull(program.blocksOf(edit.run)).size
        val list = list(program, place)
        val construct = of(blocksOf(edit.construct, messages = RobolangMessages.of(Language.ENGLISH))).nodes.single()
        construct.slots.first().clear()
        repeat(count) { construct.slots.first() += list.removeAt(place.index) }
        list.add(place.index, construct)
    }

    private fun unwrap(program: BlockProgram, edit: BlockEdit.Unwrap) {
        val place = checkNotNull(program.placeOf(edit.construct))
        val construct = program[edit.construct] as Block.Construct
        val node = list(program, place).removeAt(place.index)

        fun comment(line: OutlineLine): List<Node> = listOfNotNull(line.comment).map {
            Node(mutableListOf(it.textIn(program.text)), mutableListOf(), isConstruct = false)
        }
        val inside = node.slots.flatMapIndexed { index, slot -> comment(construct.slots[index].head) + slot }
        list(program, place).addAll(place.index, inside + construct.foot?.let(::comment).orEmpty())
    }

    private fun node(program: BlockProgram, id: BlockId): Node =
        checkNotNull(program.placeOf(id)).let { list(program, it)[it.index] }

    private fun list(program: BlockProgram, place: BlockPlace): MutableList<Node> {
        val parent = place.parent ?: return nodes
        val at = checkNotNull(program.placeOf(parent))
        return list(program, at)[at.index].slots[place.slot]
    }

    override fun toString(): String = buildString { add(nodes, "") }

    private fun StringBuilder.add(nodes: List<Node>, indentation: String) {
        for (node in nodes) {
            // An `end` that is written goes before the empty lines at the end of its block.
            if (node.heads == listOf("")) continue
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

        private fun nodes(program: BlockProgram, blocks: List<Block>): MutableList<Node> =
            blocks.mapTo(mutableListOf()) { block ->
                fun text(line: OutlineLine) = line.span.textIn(program.text).trim()
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
