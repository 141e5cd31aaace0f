package robotran.blockediting

import robotran.language.Language
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.outline.OutlineLine

/** The blocks of a program, one a line, indented by nesting: what a test compares. */
internal fun shapeOf(program: BlockProgram): String =
    buildString { addShape(program, program.blocks, "") }.trimEnd('\n')

private fun StringBuilder.addShape(program: BlockProgram, blocks: List<Block>, indentation: String) {
    fun add(kind: String, line: OutlineLine) {
        append(indentation).append(kind).append(line.span.textIn(program.text).trim()).append('\n')
    }
    for (block in blocks) {
        when (block) {
            is Block.Command -> add("", block.head)
            is Block.Comment -> add("", block.head)
            is Block.Blank -> add("blank", block.head)
            is Block.Loose -> add("loose ", block.head)

            is Block.Construct -> {
                for (slot in block.slots) {
                    add(if (slot.head.form == null) "loose: " else ": ", slot.head)
                    addShape(program, slot.blocks, "$indentation  ")
                }
                block.foot?.let { add(if (it.form == null) "loose: " else ": ", it) }
            }
        }
    }
}

/** The first block whose line begins with [text]. */
internal fun BlockProgram.find(text: String): Block =
    all.first { it.head.span.textIn(this.text).trim().startsWith(text) }

internal fun BlockProgram.idOf(text: String): BlockId = find(text).id

/** The place behind the block whose line begins with [text]. */
internal fun BlockProgram.behind(text: String): BlockPlace = checkNotNull(placeOf(idOf(text))).next

/** The place of the block whose line begins with [text]. */
internal fun BlockProgram.at(text: String): BlockPlace = checkNotNull(placeOf(idOf(text)))

/** The place at the start of a branch of the construct whose line begins with [text]. */
internal fun BlockProgram.inside(text: String, slot: Int = 0): BlockPlace = BlockPlace(idOf(text), slot, 0)

/** The result of an edit that must be possible. */
internal fun BlockProgram.done(edit: BlockEdit): BlockEditResult.Success = when (val result = apply(this, edit)) {
    is BlockEditResult.Success -> result.also { checkConsistent(this, it) }
    is BlockEditResult.Failure -> error("refused: ${result.reason}")
}

internal fun BlockProgram.editError(edit: BlockEdit): BlockEditError = when (val result = apply(this, edit)) {
    is BlockEditResult.Success -> error("not refused: ${result.program.text}")
    is BlockEditResult.Failure -> result.reason
}

/** Checks what holds for every edit: its changes make the new text, and none changes more than it must. */
internal fun checkConsistent(before: BlockProgram, result: BlockEditResult.Success) {
    val after = result.program.text
    check(changed(before.text, result.changes) == after) { "the changes do not make the text: ${result.changes}" }
    check((result.change?.applyTo(before.text) ?: before.text) == after) { "the change does not make the text" }
    check((result.change?.inverse?.applyTo(after) ?: after) == before.text) { "the change cannot be undone" }
    check(result.changes.zipWithNext().all { (one, next) -> one.start + one.removed.length <= next.start })
    for (change in result.changes) {
        check(change.removed != change.inserted)
        val common = change.removed.isNotEmpty() && change.inserted.isNotEmpty() &&
            (change.removed.first() == change.inserted.first() || change.removed.last() == change.inserted.last())
        check(!common) { "$change is larger than it must be" }
    }
    check(result.selection.start in 0..after.length && result.selection.end in result.selection.start..after.length)
    check(result.selected.all { result.program[it] != null })
    check(shapeOf(blocksOf(after, messages = RobolangMessages.of(Language.ENGLISH))) == shapeOf(result.program)) {
        "the text does not read back as the blocks"
    }
}
