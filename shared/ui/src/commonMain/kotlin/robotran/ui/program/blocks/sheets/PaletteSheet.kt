package robotran.ui.program.blocks.sheets

import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.items
import androidx.compose.foundation.rememberScrollState
import androidx.compose.material3.OutlinedTextField
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.graphicsLayer
import androidx.compose.ui.layout.onGloballyPositioned
import androidx.compose.ui.layout.positionInRoot
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import org.jetbrains.compose.resources.stringResource
import robotran.blockediting.BlockGroup
import robotran.blockediting.palette.Palette
import robotran.blockediting.palette.PaletteBlock
import robotran.blockediting.palette.PaletteHelp
import robotran.blockediting.palette.ownBlocks
import robotran.blockediting.palette.searchPalette
import robotran.language.ProgramLanguage
import robotran.learning.WordHelp
import robotran.ui.parts.fieldColours
import robotran.ui.program.blocks.BlockDragging
import robotran.ui.program.blocks.BlockScope
import robotran.ui.program.blocks.DoNowButton
import robotran.ui.resources.Res
import robotran.ui.resources.blocks_none_found
import robotran.ui.resources.blocks_not_yet
import robotran.ui.resources.blocks_palette
import robotran.ui.resources.blocks_search
import robotran.ui.resources.blocks_show_all
import robotran.ui.theme.LocalRobotranColours
import robotran.workshop.blocks.BlockPalette
import robotran.workshop.blocks.BlocksState
import robotran.workshop.blocks.placeForNew
import robotran.workshop.event.BlockEvent

/**
 * The blocks that can be added: a group, or what is searched for; in the tutorial only those that it has introduced. A
 * touch adds one below the cursor; one that is carried out of the sheet lands anywhere.
 */
@Composable
internal fun PaletteSheet(
    scope: BlockScope,
    dragging: BlockDragging,
    hasRail: Boolean,
    onClose: () -> Unit,
    modifier: Modifier,
) {
    val palette = scope.state.palette
    val turn = { next: BlockPalette -> scope.onEvent(BlockEvent.PaletteTurned(next)) }
    var showsAll by remember { mutableStateOf(false) }
    val introduced = scope.introduced.takeIf { !showsAll }
    val shown = remember(palette, scope.state.program, scope.state.cursor, introduced) {
        shownBlocks(scope.state, introduced)
    }
    // While a block is carried out of it, the sheet stays, because its touches come from there.
    val place = modifier
        .graphicsLayer { alpha = if (dragging.isNew) CARRIED_FROM else 1f }
        .onGloballyPositioned { dragging.coveredFrom = it.positionInRoot().y - dragging.corner.y }
    SheetFrame(stringResource(Res.string.blocks_palette), onClose, place, scrolls = false) {
        OutlinedTextField(
            palette.query,
            { turn(palette.copy(query = it)) },
            Modifier.fillMaxWidth().testTag("palette-search"),
            label = { Text(stringResource(Res.string.blocks_search)) },
            singleLine = true,
            colors = fieldColours(),
        )
        if (!hasRail) GroupChips(scope, turn)
        if (shown.isEmpty()) {
            Text(
                stringResource(if (introduced == null) Res.string.blocks_none_found else Res.string.blocks_not_yet),
                color = LocalRobotranColours.current.onPane,
                fontSize = 16.sp,
            )
        }
        if (introduced != null) {
            SheetButton(stringResource(Res.string.blocks_show_all), "palette-all") { showsAll = true }
        }
        LazyColumn(
            Modifier.fillMaxWidth().testTag("palette-blocks"),
            verticalArrangement = Arrangement.spacedBy(8.dp),
        ) {
            items(shown) { block ->
                Row(verticalAlignment = Alignment.Top) {
                    Box(Modifier.weight(1f)) {
                        PaletteItem(block, scope, dragging) { scope.onEvent(BlockEvent.Taken(block)) }
                    }
                    DoNowButton(block, scope)
                }
            }
        }
    }
}

@Composable
private fun GroupChips(scope: BlockScope, onTurn: (BlockPalette) -> Unit) {
    val palette = scope.state.palette
    Row(Modifier.horizontalScroll(rememberScrollState()), Arrangement.spacedBy(8.dp)) {
        for (group in BlockGroup.entries) {
            val isShown = palette.query.isEmpty() && palette.group == group
            SheetButton(scope.messages.group(group), "group-${group.name.lowercase()}", isChosen = isShown) {
                onTurn(BlockPalette(group))
            }
        }
    }
}

/** The lines that can be added. Values are offered where they fit, in the sheet of a socket. */
private fun shownBlocks(state: BlocksState, introduced: Set<String>?): List<PaletteBlock> {
    val own = ownBlocks(state.program, state.placeForNew)
    val all = (Palette.blocks.filter { introduced == null || it.id in introduced } + own).filter { !it.isValue }
    val query = state.palette.query
    return if (query.isBlank()) all.filter { it.group == state.palette.group } else searchPalette(query, all, HELP)
}

private val HELP = PaletteHelp { word, language -> WordHelp.of(language, ProgramLanguage.ROBOLANG, word)?.sentence }

private const val CARRIED_FROM = 0.2f
