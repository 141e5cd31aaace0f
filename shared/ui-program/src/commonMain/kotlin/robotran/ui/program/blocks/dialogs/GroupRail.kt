package robotran.ui.program.blocks.dialogs

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
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
            GroupButton(group, isShown, scope) {
                scope.onEvent(BlockEvent.PaletteGroupSelected(BlockPalette(group)))
                scope.show(BlockDialog.Palette.takeIf { !isShown })
            }
        }
    }
}

@Composable
private fun GroupButton(group: BlockGroup, isShown: Boolean, scope: BlockScope, onClick: () -> Unit) {
    val colours = LocalRobotranColours.current
    val words = scope.messages.group(group)
    Column(
        Modifier
            .fillMaxWidth()
            .testTag(ProgramTags.group(group))
            .defaultMinSize(minHeight = BUTTON_HEIGHT)
            .focusRing()
            .background(if (isShown) colours.pane else Color.Transparent)
            .clickable(role = Role.Button, onClick = onClick)
            .semantics {
                contentDescription = words
                selected = isShown
            }
            .padding(horizontal = 2.dp, vertical = 4.dp),
        Arrangement.spacedBy(2.dp, Alignment.CenterVertically),
        Alignment.CenterHorizontally,
    ) {
        GroupBadge(group, scope)
        Text(words, style = TextStyles.signLines, textAlign = TextAlign.Center)
    }
}

/** A group in a row of groups. */
@Composable
internal fun GroupChip(group: BlockGroup, isShown: Boolean, scope: BlockScope, onClick: () -> Unit) {
    val colours = LocalRobotranColours.current
    val words = scope.messages.group(group)
    val shape = Shapes.MEDIUM
    Row(
        Modifier
            .testTag(ProgramTags.group(group))
            .broughtIntoSight(isShown)
            .defaultMinSize(minHeight = Dimensions.TARGET)
            .focusRing()
            .clip(shape)
            .background(if (isShown) colours.onPane else colours.pane)
            .border(1.dp, colours.quiet, shape)
            .clickable(role = Role.Button, onClick = onClick)
            .semantics {
                contentDescription = words
                selected = isShown
            }
            .padding(start = 8.dp, end = 14.dp),
        Arrangement.spacedBy(8.dp),
        Alignment.CenterVertically,
    ) {
        GroupBadge(group, scope)
        Text(words, style = TextStyles.body, color = if (isShown) colours.pane else colours.onPane)
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

private val BUTTON_HEIGHT = 64.dp
private val GRID_CELL = 50.dp
private val BADGE = 34.dp
