package robotran.ui.drawer

import androidx.compose.foundation.BorderStroke
import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import robotran.simulation.state.GoalProgress
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.uikit.*
import robotran.workshop.event.RunEvent
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.GoalCount

/**
 * The number of goals met, or praise if all are; empty in a world without goals. A touch opens the goals. Its size fits
 * the longest text.
 *
 * @param isSlim whether there is room for one short line only, as always with large text.
 * @param hasName whether that line may say what it counts; with large text it never does.
 */
@Composable
internal fun GoalChip(
    goals: List<GoalProgress>,
    onEvent: (RunEvent) -> Unit,
    modifier: Modifier = Modifier,
    isSlim: Boolean = false,
    hasName: Boolean = true,
) {
    if (goals.isEmpty()) return
    val colours = LocalRobotranColours.current
    val count = GoalCount.of(goals)
    val allMet = RunTexts.goalsAll(spoken)
    val words = if (count.allMet) allMet else RunTexts.goalsCount(spoken, count.met, count.all)
    val isLarge = LocalDensity.current.fontScale > LARGE
    val isShort = isLarge || isSlim
    val name = if (isLarge || !hasName) "" else RunTexts.tabGoals(spoken) + " "
    val shown = if (isShort) "$name${count.met}/${count.all}" else words
    val longest = if (isShort) {
        "$name${count.all}/${count.all}"
    } else {
        RunTexts.goalsCount(spoken, count.all, count.all)
    }
    val icon = when {
        count.allMet -> RunIcons.DONE
        count.failed > 0 -> RunIcons.CLOSE
        else -> RunIcons.OPEN
    }
    Row(
        modifier
            .testTag(RunTags.GOAL_CHIP)
            .focusRing(CORNER)
            .clip(RoundedCornerShape(CORNER))
            .background(colours.pane)
            .border(BorderStroke(1.dp, if (count.allMet) colours.onPane else colours.line), RoundedCornerShape(CORNER))
            .clickable(role = Role.Button) { onEvent(RunEvent.DrawerChosen(DrawerTab.GOALS)) }
            .defaultMinSize(minHeight = Dimensions.TARGET)
            .padding(horizontal = 16.dp, vertical = 8.dp)
            .semantics(mergeDescendants = true) {
                liveRegion = LiveRegionMode.Polite
                if (isShort) contentDescription = words
            },
        Arrangement.spacedBy(8.dp),
        Alignment.CenterVertically,
    ) {
        IconView(icon, if (icon == RunIcons.CLOSE) colours.error else colours.onPane, size = 18.dp)
        SteadySize(
            shown,
            if (isShort) listOf(longest) else listOf(longest, allMet),
            alignment = Alignment.CenterStart,
        ) {
            val semantics = if (isShort) Modifier.clearAndSetSemantics { } else Modifier
            Text(it, semantics, TextStyles.tightLabel.medium)
        }
    }
}

/** Up to this font scale there is room for words next to the brick. */
private const val LARGE = 1.3f
private val CORNER = Corners.SHEET
