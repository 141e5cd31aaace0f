package robotran.ui.program.blocks.dialogs

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.IntrinsicSize
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.selected
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.unit.dp
import robotran.robolang.words.BlockGroup
import robotran.ui.code.GroupSigns
import robotran.ui.program.blocks.BlockScope
import robotran.ui.program.tags.ProgramTags
import robotran.uikit.*
import robotran.workshop.blocks.BlockDialog
import robotran.workshop.blocks.BlockPalette
import robotran.workshop.event.BlockEvent

/** The groups of the palette beside the blocks. A touch opens the palette at that group, or closes it. */
@Composable
internal fun GroupRail(scope: BlockScope, modifier: Modifier = Modifier) {
    val colours = LocalRobotranColours.current
    val scroll = rememberScrollState()
    Column(
        modifier
            .background(colours.desk)
            .scrollHint(scroll, ground = colours.desk)
            .verticalScroll(scroll)
            .padding(vertical = 4.dp)
            .testTag(ProgramTags.BLOCK_GROUPS),
        Arrangement.spacedBy(2.dp),
    ) {
        for (group in BlockGroup.entries) {
            val isShown = scope.state.sheet == BlockDialog.Palette && scope.state.palette.group == group
            GroupButton(group, isShown, scope, colours.pane) {
                scope.onEvent(BlockEvent.PaletteGroupSelected(BlockPalette(group)))
                scope.show(BlockDialog.Palette.takeIf { !isShown })
            }
        }
    }
}

/**
 * All groups in two rows, for a sheet. They are in sight at once, and stay where they are.
 *
 * @param hasNames whether each says its name below its sign.
 * @param saysShown whether, without names, that of the shown group is behind the signs.
 */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun GroupGrid(
    palette: BlockPalette,
    hasNames: Boolean,
    saysShown: Boolean,
    scope: BlockScope,
    onTurn: (BlockPalette) -> Unit,
) {
    val isShown = { group: BlockGroup -> palette.query.isEmpty() && palette.group == group }
    if (!hasNames) {
        FlowRow {
            for (group in BlockGroup.entries) {
                GroupSign(group, isShown(group), scope) { onTurn(BlockPalette(group)) }
            }
            if (saysShown && palette.query.isEmpty()) {
                Box(Modifier.height(GRID_CELL).padding(start = Space.SMALL), Alignment.CenterStart) {
                    Text(scope.messages.group(palette.group), style = TextStyles.body.medium)
                }
            }
        }
        return
    }
    val shown = LocalRobotranColours.current.desk
    Column(Modifier.testTag(ProgramTags.BLOCK_GROUPS)) {
        for (row in BlockGroup.entries.chunked(GROUPS_IN_ROW)) {
            Row(Modifier.height(IntrinsicSize.Max)) {
                for (group in row) {
                    val place = Modifier.weight(1f).fillMaxHeight().clip(Shapes.MEDIUM)
                    GroupButton(group, isShown(group), scope, shown, place) { onTurn(BlockPalette(group)) }
                }
            }
        }
    }
}

/** A group with its name below its sign, on [shownColour] if its blocks are shown. */
@Composable
private fun GroupButton(
    group: BlockGroup,
    isShown: Boolean,
    scope: BlockScope,
    shownColour: Color,
    modifier: Modifier = Modifier,
    onClick: () -> Unit,
) {
    val words = scope.messages.group(group)
    Column(
        Modifier
            .testTag(ProgramTags.group(group))
            .focusRing()
            .then(modifier)
            .fillMaxWidth()
            .defaultMinSize(minHeight = BUTTON_HEIGHT)
            .background(if (isShown) shownColour else Color.Transparent)
            .clickable(role = Role.Button, onClick = onClick)
            .semantics {
                contentDescription = words
                selected = isShown
            }
            .padding(horizontal = 2.dp, vertical = 2.dp),
        Arrangement.spacedBy(2.dp, Alignment.CenterVertically),
        Alignment.CenterHorizontally,
    ) {
        GroupBadge(group, scope)
        Text(words, style = TextStyles.signLines, textAlign = TextAlign.Center)
    }
}

/** A group in a grid of groups, by its sign alone. */
@Composable
internal fun GroupSign(group: BlockGroup, isShown: Boolean, scope: BlockScope, onClick: () -> Unit) {
    val words = scope.messages.group(group)
    Box(
        Modifier
            .testTag(ProgramTags.group(group))
            .size(GRID_CELL)
            .focusRing()
            .border(
                2.dp,
                if (isShown) LocalRobotranColours.current.onPane else Color.Transparent,
                Shapes.MEDIUM,
            )
            .clickable(role = Role.Button, onClick = onClick)
            .semantics {
                contentDescription = words
                selected = isShown
            },
        Alignment.Center,
    ) { GroupBadge(group, scope) }
}

/** The sign of a group on its colour. */
@Composable
internal fun GroupBadge(group: BlockGroup, scope: BlockScope) {
    val look = scope.looks.of(group)
    val shape = Shapes.SMALL
    Box(
        Modifier.size(BADGE).clip(shape).background(look.fill).border(2.dp, look.edge, shape),
        Alignment.Center,
    ) { IconView(GroupSigns.of(group), look.ink, size = 20.dp) }
}

private val BUTTON_HEIGHT = 56.dp
private val GRID_CELL = 50.dp
private val BADGE = 34.dp
private const val GROUPS_IN_ROW = 4
