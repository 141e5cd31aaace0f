package robotran.ui.program.blocks.dialogs

import androidx.compose.ui.platform.ClipboardManager
import robotran.blockediting.Block
import robotran.blockediting.BlockEdit
import robotran.robolang.words.BlockGroup
import robotran.robolang.words.LineForm
import robotran.robolang.words.ValueUse
import robotran.ui.code.GroupSigns
import robotran.ui.program.blocks.BlockScope
import robotran.ui.program.blocks.copy
import robotran.ui.program.blocks.doNow
import robotran.ui.program.blocks.paste
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.BlockTexts
import robotran.ui.program.texts.EditorTexts
import robotran.uikit.*
import robotran.workshop.blocks.BlockCursor
import robotran.workshop.blocks.BlockDialog
import robotran.workshop.blocks.DragPayload
import robotran.workshop.blocks.at
import robotran.workshop.blocks.helpWord
import robotran.workshop.blocks.placeNested
import robotran.workshop.event.BlockEvent

/** @property sign what the button shows besides [words]; only the usual actions and deleting have one. */
internal class BlockAction(val words: Label, val tag: String, val sign: Icon? = null, val act: () -> Unit)

/**
 * What can be done to a block, or to all selected ones if it is among them.
 *
 * @property usual what pupils do most, each with a sign.
 */
internal class BlockActions(val usual: List<BlockAction>, val more: List<BlockAction>, val delete: BlockAction)

/** What can be done to [block]. */
internal fun actionsOn(
    block: Block,
    scope: BlockScope,
    clipboard: ClipboardManager,
    reader: ClipboardReader,
): BlockActions {
    val run = scope.state.runOf(block.id)
    val now = BlockAction(BlockTexts::doNow, ProgramTags.NOW, EditIcons.PLAY) { scope.doNow(DragPayload.Blocks(run)) }
    val double = BlockAction(BlockTexts::duplicate, ProgramTags.DUPLICATE, EditIcons.COPY) {
        scope.edit(BlockEdit.Duplicate(run))
    }
    val wrap = BlockAction(BlockTexts::wrap, ProgramTags.WRAP, GroupSigns.of(BlockGroup.CONTROL)) {
        scope.edit(BlockEdit.Wrap(run, REPEAT))
    }
    val help = block.head.helpWord(scope.state.program.text)?.let { word ->
        BlockAction(BlockTexts::help, ProgramTags.HELP, QUESTION) { scope.onHelp(word) }
    }
    val branch = BlockAction(BlockTexts::addElse, ProgramTags.ELSE, FORK) {
        scope.edit(BlockEdit.AddElse(block.id))
    }.takeIf { block.head.form == LineForm.IF }
    // A block with an else is what one wants of an "if".
    val first = listOfNotNull(double, branch ?: wrap, now, help)
    return BlockActions(
        first,
        listOfNotNull(wrap.takeIf { branch != null }) + actionsOnAll(block, scope, clipboard, reader) +
            actionsOnLine(block, scope) + actionsOnConstruct(block, scope),
        BlockAction(BlockTexts::delete, ProgramTags.DELETE, EditIcons.DELETE) {
            scope.edit(BlockEdit.Delete(scope.selectedWith(block)))
        },
    )
}

private fun BlockScope.selectedWith(block: Block) =
    if (block.id in state.selected) state.selected.toSet() else setOf(block.id)

/** What else can be done to any blocks. */
private fun actionsOnAll(
    block: Block,
    scope: BlockScope,
    clipboard: ClipboardManager,
    reader: ClipboardReader,
): List<BlockAction> {
    val at = {
        if (block.id !in scope.state.selected) scope.onEvent(BlockEvent.CursorPut(BlockCursor.At(block.id)))
    }
    val here = if (block.id in scope.state.selected) scope.state else scope.state.at(BlockCursor.At(block.id))
    val copy = { clipboard.copy(scope.copy(state = here.copy(part = null))) }
    return listOfNotNull(
        BlockAction(BlockTexts::up, ProgramTags.UP) {
            at()
            scope.onEvent(BlockEvent.Moved(isUp = true))
        },
        BlockAction(BlockTexts::down, ProgramTags.DOWN) {
            at()
            scope.onEvent(BlockEvent.Moved(isUp = false))
        },
        BlockAction(BlockTexts::out, ProgramTags.OUT) {
            at()
            scope.onEvent(BlockEvent.Nested(isOut = true))
        }.takeIf { here.placeNested(isOut = true) != null },
        BlockAction(BlockTexts::blocksIn, ProgramTags.IN) {
            at()
            scope.onEvent(BlockEvent.Nested(isOut = false))
        }.takeIf { here.placeNested(isOut = false) != null },
        BlockAction(BlockTexts::chooseSeveral, ProgramTags.CHOOSE) {
            at()
            scope.onEvent(BlockEvent.MultiSelectChanged(true))
        },
        BlockAction(BlockTexts::selectStack, ProgramTags.STACK) { scope.onEvent(BlockEvent.StackSelected(block.id)) },
        BlockAction(EditorTexts::cut, ProgramTags.CUT) {
            copy()
            scope.edit(BlockEdit.Delete(scope.selectedWith(block)))
        },
        BlockAction(EditorTexts::copy, ProgramTags.COPY) { copy() },
        BlockAction(EditorTexts::paste, ProgramTags.PASTE) {
            at()
            reader.read(scope::paste)
        },
    )
}

private fun actionsOnLine(block: Block, scope: BlockScope): List<BlockAction> = listOfNotNull(
    BlockAction(BlockTexts::note, ProgramTags.NOTE) { scope.show(BlockDialog.Note(block.head.index)) },
    BlockAction(BlockTexts::asText, ProgramTags.LINE) { scope.show(BlockDialog.Line(block.head.index)) },
)

private fun actionsOnConstruct(block: Block, scope: BlockScope): List<BlockAction> {
    if (block !is Block.Construct) return emptyList()
    val unwrap = BlockAction(BlockTexts::unwrap, ProgramTags.UNWRAP) { scope.edit(BlockEdit.Unwrap(block.id)) }
    if (block.head.form != LineForm.IF) return listOf(unwrap)
    val branch = (scope.state.cursor as? BlockCursor.Branch)?.takeIf { it.block == block.id }
    return listOfNotNull(
        unwrap,
        branch?.let { at ->
            BlockAction(BlockTexts::removeElse, ProgramTags.REMOVE_ELSE) {
                scope.edit(BlockEdit.RemoveElse(block.id, at.slot))
            }
        },
        BlockAction(BlockTexts::addElseIf, ProgramTags.ELSE_IF) {
            scope.edit(BlockEdit.AddElse(block.id, ValueUse.CONDITION.example))
        },
    )
}

/** What blocks are wrapped in first; its head can then be made another one. */
private const val REPEAT = "repeat 4 times\nend"

private val QUESTION = Icon.strokes("M8 8L9.5 5.5L12 5L14.5 5.5L16 8L15 10.5L12 13V15", "M12 19V19.2")

/** A way that forks. */
private val FORK = Icon.strokes("M12 20V13L6 8V4", "M12 13L18 8V4")
