package robotran.ui.program.blocks

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.CustomAccessibilityAction
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.customActions
import androidx.compose.ui.semantics.focused
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.selected
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.stateDescription
import androidx.compose.ui.unit.dp
import robotran.blockediting.Block
import robotran.blockediting.BlockEdit
import robotran.blockediting.describe.BlockDescription
import robotran.blockediting.describe.describe
import robotran.blockediting.describe.place
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.BlockTexts
import robotran.uikit.*
import robotran.workshop.blocks.BlockCursor
import robotran.workshop.blocks.BlockDialog
import robotran.workshop.blocks.BlockRow
import robotran.workshop.blocks.DragPayload
import robotran.workshop.blocks.editableParts
import robotran.workshop.event.BlockEvent

/** What a screen reader says about [row], and what it can do to the block. */
@Composable
internal fun Modifier.spokenAs(row: BlockRow, scope: BlockScope, marks: RowMarks): Modifier {
    val description = descriptionOf(row, scope)
    val words = wordsFor(row, description, scope)
    val said = LocalRowWords.current
    val states = statesOf(row, marks, words, said)
    val isSelected = row !is BlockRow.Empty && row.block.id in scope.state.selected
    val actions = if (row is BlockRow.First) actionsOn(row, scope, said) else emptyList()
    val isAt = row.cursor != null && row.cursor == scope.state.cursor && scope.state.part == null
    val isFocused = isAt && LocalBlockDragging.current?.hasFocus == true
    return semantics {
        contentDescription = words
        if (states.isNotEmpty()) stateDescription = states
        selected = isSelected
        if (isFocused) focused = true
        if (actions.isNotEmpty()) customActions = actions
        treePlace = placeOf(row, description)
    }
}

private fun descriptionOf(row: BlockRow, scope: BlockScope): BlockDescription? = when (row) {
    is BlockRow.Branch -> describe(scope.state.program, row.block.id, row.slot, scope.messages)
    is BlockRow.First, is BlockRow.Empty, is BlockRow.End -> describe(scope.state.program, row.block.id, scope.messages)
}

private fun placeOf(row: BlockRow, description: BlockDescription?): TreePlace {
    val level = description?.level ?: 1
    val isOpen = when (row) {
        is BlockRow.First -> if (row.block is Block.Construct) !row.isCollapsed else null
        is BlockRow.Branch -> true
        is BlockRow.End, is BlockRow.Empty -> null
    }
    return when (row) {
        is BlockRow.Empty -> TreePlace(level + 1, 1, 1, isOpen)

        else -> TreePlace(
            level,
            description?.position ?: 1,
            description?.siblings ?: 1,
            isOpen,
            treeWords(row, description),
        )
    }
}

private fun treeWords(row: BlockRow, description: BlockDescription?): String? = when (row) {
    is BlockRow.First, is BlockRow.Branch -> listOfNotNull(description?.words, description?.context).joinToString(", ")
    is BlockRow.End, is BlockRow.Empty -> null
}

@Composable
private fun wordsFor(row: BlockRow, description: BlockDescription?, scope: BlockScope): String = when (row) {
    is BlockRow.First -> listOfNotNull(description?.sentence, description?.place(scope.messages)).joinToString(", ")
    is BlockRow.Branch -> listOfNotNull(description?.sentence, description?.context).joinToString(", ")
    is BlockRow.Empty -> BlockTexts.emptyIn(spoken, scope.wordsOf(row.block.slots[row.slot].head))
    is BlockRow.End -> BlockTexts.endOf(spoken, scope.wordsOf(row.block.head))
}

/** What else is true of the row now: that it runs, that the program stops there, its mistakes. */
private fun statesOf(row: BlockRow, marks: RowMarks, label: String, said: RowWords): String = listOfNotNull(
    if (marks.isRunning) said.runsNow else null,
    if (marks.hasBreakpoint) said.stopsBefore else null,
    if (row is BlockRow.First && row.isCollapsed) said.folded else null,
).plus(marks.notes.map { it.diagnostic.message }.filter { it !in label }).joinToString(", ")

/** All that fingers and keys can do, for those who have neither; the last one shows them all. */
private fun actionsOn(row: BlockRow.First, scope: BlockScope, said: RowWords): List<CustomAccessibilityAction> {
    val id = row.block.id
    val part = row.line.editableParts.firstOrNull()
    val toHere = {
        if (id !in scope.state.selected) scope.onEvent(BlockEvent.CursorPut(BlockCursor.At(id)))
    }
    val fold = if (row.isCollapsed) said.unfold else said.fold
    return listOfNotNull(
        part?.let { action(said.change) { scope.show(BlockDialog.Part(it.span)) } },
        action(said.addBelow) {
            scope.onEvent(BlockEvent.CursorPut(BlockCursor.At(id)))
            scope.show(BlockDialog.Palette)
        },
        action(said.doNow) { scope.doNow(DragPayload.Blocks(scope.state.runOf(id))) },
        action(said.up) {
            toHere()
            scope.onEvent(BlockEvent.Moved(isUp = true))
        },
        action(said.down) {
            toHere()
            scope.onEvent(BlockEvent.Moved(isUp = false))
        },
        action(said.duplicate) {
            scope.edit(BlockEdit.Duplicate(scope.state.runOf(id)))
        },
        action(said.delete) {
            scope.edit(BlockEdit.Delete(if (id in scope.state.selected) scope.state.selected.toSet() else setOf(id)))
        },
        if (row.block is Block.Construct) {
            action(fold) {
                scope.onEvent(BlockEvent.Folded(id))
            }
        } else {
            null
        },
        action(said.more) { scope.show(BlockDialog.Actions(id)) },
    )
}

private fun action(label: String, act: () -> Unit) = CustomAccessibilityAction(label) {
    act()
    true
}

/** Tells a screen reader what an edit has done. It cannot be seen. */
@Composable
internal fun SaidAloud(label: String?) = Box(
    Modifier.size(1.dp).testTag(ProgramTags.BLOCKS_SAID).semantics {
        liveRegion = LiveRegionMode.Polite
        contentDescription = label.orEmpty()
    },
)
