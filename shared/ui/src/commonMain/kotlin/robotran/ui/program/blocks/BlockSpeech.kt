package robotran.ui.program.blocks

import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.CustomAccessibilityAction
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.customActions
import androidx.compose.ui.semantics.selected
import androidx.compose.ui.semantics.semantics
import org.jetbrains.compose.resources.stringResource
import robotran.blockediting.BlockEdit
import robotran.blockediting.BlockRun
import robotran.blockediting.describe.BlockDescription
import robotran.blockediting.describe.describe
import robotran.ui.resources.Res
import robotran.ui.resources.blocks_delete
import robotran.ui.resources.blocks_do_now
import robotran.ui.resources.blocks_down
import robotran.ui.resources.blocks_duplicate
import robotran.ui.resources.blocks_empty_in
import robotran.ui.resources.blocks_end_of
import robotran.ui.resources.blocks_more
import robotran.ui.resources.blocks_up
import robotran.workshop.blocks.BlockCursor
import robotran.workshop.blocks.BlockLoad
import robotran.workshop.blocks.BlockRow
import robotran.workshop.blocks.BlockSheet
import robotran.workshop.event.BlockEvent

/** What a screen reader says about [row], and what it can do to the block. */
@Composable
internal fun Modifier.spokenAs(row: BlockRow, scope: BlockScope): Modifier {
    val words = wordsFor(row, scope)
    val isSelected = row.block.id in scope.state.selected
    val actions = if (row is BlockRow.First) actionsOn(row, scope) else emptyList()
    return semantics {
        contentDescription = words
        selected = isSelected
        customActions = actions
    }
}

@Composable
private fun wordsFor(row: BlockRow, scope: BlockScope): String {
    val program = scope.state.program
    return when (row) {
        is BlockRow.First -> describe(program, row.block.id, scope.messages).inWords()
        is BlockRow.Branch -> describe(program, row.block.id, row.slot, scope.messages).inWords()
        is BlockRow.Empty -> stringResource(Res.string.blocks_empty_in, scope.wordsOf(row.block.slots[row.slot].head))
        is BlockRow.End -> stringResource(Res.string.blocks_end_of, scope.wordsOf(row.block.head))
    }
}

private fun BlockDescription?.inWords(): String = listOfNotNull(this?.sentence, this?.context).joinToString(", ")

@Composable
private fun actionsOn(row: BlockRow.First, scope: BlockScope): List<CustomAccessibilityAction> {
    val id = row.block.id
    val at = BlockEvent.CursorPut(BlockCursor.At(id))
    return listOf(
        action(stringResource(Res.string.blocks_more)) { scope.show(BlockSheet.Actions(id)) },
        action(stringResource(Res.string.blocks_do_now)) { scope.doNow(BlockLoad.Blocks(scope.state.runOf(id))) },
        action(stringResource(Res.string.blocks_up)) {
            scope.onEvent(at)
            scope.onEvent(BlockEvent.Moved(isUp = true))
        },
        action(stringResource(Res.string.blocks_down)) {
            scope.onEvent(at)
            scope.onEvent(BlockEvent.Moved(isUp = false))
        },
        action(stringResource(Res.string.blocks_duplicate)) { scope.edit(BlockEdit.Duplicate(BlockRun(id))) },
        action(stringResource(Res.string.blocks_delete)) { scope.edit(BlockEdit.Delete(setOf(id))) },
    )
}

private fun action(words: String, act: () -> Unit) = CustomAccessibilityAction(words) {
    act()
    true
}
