package robotran.ui.program.blocks.dialogs

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.ClipboardManager
import androidx.compose.ui.platform.LocalClipboardManager
import androidx.compose.ui.unit.dp
import robotran.blockediting.Block
import robotran.blockediting.BlockEdit
import robotran.blockediting.BlockEditResult
import robotran.blockediting.BlockId
import robotran.blockediting.apply
import robotran.blockediting.formsFor
import robotran.language.source.SourceSpan
import robotran.robolang.words.LineForm
import robotran.robolang.words.ValueUse
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

/** What can be done to the block [id], or to all selected ones if it is among them. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun ActionsDialog(id: BlockId, scope: BlockScope, onClose: () -> Unit, modifier: Modifier) {
    val block = scope.state.program[id] ?: return
    val clipboard = LocalClipboardManager.current
    val reader = clipboardReader()
    val act = { action: BlockAction ->
        onClose()
        action.act()
    }
    BlockDialogFrame(scope.wordsOf(block.head), onClose, modifier) {
        FlowRow(horizontalArrangement = Arrangement.spacedBy(8.dp), verticalArrangement = Arrangement.spacedBy(8.dp)) {
            for (action in actionsOn(block, scope, clipboard, reader)) {
                DialogButton(action.words(spoken), ProgramTags.action(action.tag)) { act(action) }
            }
        }
        Forms(block, scope)
    }
}

/** The other forms that the line can take, each as it would read then. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun Forms(block: Block, scope: BlockScope) {
    val forms = block.head.form?.let { formsFor(it) }.orEmpty()
    val changes = remember(block, scope.state.program) { forms.mapNotNull { changeTo(it, block, scope) } }
    if (changes.isEmpty()) return
    DialogHeading(BlockTexts.forms(spoken))
    FlowRow(horizontalArrangement = Arrangement.spacedBy(8.dp), verticalArrangement = Arrangement.spacedBy(8.dp)) {
        changes.forEachIndexed { index, (words, edit) ->
            DialogButton(words, ProgramTags.form(index)) {
                scope.show(null)
                scope.edit(edit)
            }
        }
    }
}

/** The line after it has taken [form], and the edit; null if it cannot. */
private fun changeTo(form: LineForm, block: Block, scope: BlockScope): Pair<String, BlockEdit>? {
    val edit = BlockEdit.ChangeForm(block.head.index, form)
    val done = apply(scope.state.program, edit) as? BlockEditResult.Success ?: return null
    val line = done.program.outline.lines[block.head.index]
    return SourceSpan(line.parts.first().span.start, line.parts.last().span.end).textIn(done.program.text) to edit
}

private class BlockAction(val words: Label, val tag: String, val act: () -> Unit)

private fun actionsOn(
    block: Block,
    scope: BlockScope,
    clipboard: ClipboardManager,
    reader: ClipboardReader,
): List<BlockAction> =
    actionsOnAll(block, scope, clipboard, reader) + actionsOnLine(block, scope) + actionsOnConstruct(block, scope)

/** What can be done to any blocks. */
private fun actionsOnAll(
    block: Block,
    scope: BlockScope,
    clipboard: ClipboardManager,
    reader: ClipboardReader,
): List<BlockAction> {
    val run = scope.state.runOf(block.id)
    val selected = if (block.id in scope.state.selected) scope.state.selected.toSet() else setOf(block.id)
    val at = {
        if (block.id !in scope.state.selected) scope.onEvent(BlockEvent.CursorPut(BlockCursor.At(block.id)))
    }
    val here = if (block.id in scope.state.selected) scope.state else scope.state.at(BlockCursor.At(block.id))
    val copy = { clipboard.copy(scope.copy(state = here.copy(part = null))) }
    return listOfNotNull(
        BlockAction(BlockTexts::doNow, ProgramTags.NOW) { scope.doNow(DragPayload.Blocks(run)) },
        BlockAction(BlockTexts::duplicate, ProgramTags.DUPLICATE) { scope.edit(BlockEdit.Duplicate(run)) },
        BlockAction(BlockTexts::delete, ProgramTags.DELETE) { scope.edit(BlockEdit.Delete(selected)) },
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
        BlockAction(BlockTexts::wrap, ProgramTags.WRAP) { scope.edit(BlockEdit.Wrap(run, REPEAT)) },
        BlockAction(EditorTexts::cut, ProgramTags.CUT) {
            copy()
            scope.edit(BlockEdit.Delete(selected))
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
    block.head.helpWord(scope.state.program.text)?.let { word ->
        BlockAction(BlockTexts::help, ProgramTags.HELP) { scope.onHelp(word) }
    },
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
        BlockAction(BlockTexts::addElse, ProgramTags.ELSE) { scope.edit(BlockEdit.AddElse(block.id)) },
    )
}

/** What blocks are wrapped in first; its head can then be made another one. */
private const val REPEAT = "repeat 4 times\nend"
