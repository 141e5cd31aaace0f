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
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import org.jetbrains.compose.resources.stringResource
import robotran.ui.resources.Res
import robotran.ui.resources.run_goals_all
import robotran.ui.resources.run_goals_count
import robotran.ui.runbar.RunIcon
import robotran.ui.runbar.RunIconView
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.Measures
import robotran.ui.theme.focusRing
import robotran.ui.workshop.DrawerTab
import robotran.ui.workshop.RunEvent
import robotran.world.GoalProgress
import robotran.world.GoalStatus

/** How many of the world's goals are reached, and a kind word when all are; nothing in a world without goals. A touch shows them. */
@Composable
internal fun GoalChip(goals: List<GoalProgress>, onEvent: (RunEvent) -> Unit, modifier: Modifier = Modifier) {
    if (goals.isEmpty()) return
    val colours = LocalRobotranColours.current
    val met = goals.count { it.status == GoalStatus.MET }
    val all = met == goals.size
    Row(
        modifier
            .testTag("goal-chip")
            .focusRing(CORNER)
            .clip(RoundedCornerShape(CORNER))
            .background(colours.pane)
            .border(BorderStroke(1.dp, if (all) colours.onPane else colours.line), RoundedCornerShape(CORNER))
            .clickable(role = Role.Button) { onEvent(RunEvent.DrawerChosen(DrawerTab.GOALS)) }
            .defaultMinSize(minHeight = Measures.TARGET)
            .padding(horizontal = 16.dp, vertical = 8.dp)
            .semantics(mergeDescendants = true) { liveRegion = LiveRegionMode.Polite },
        Arrangement.spacedBy(8.dp),
        Alignment.CenterVertically,
    ) {
        RunIconView(if (all) RunIcon.DONE else RunIcon.OPEN, side = 18.dp, colour = colours.onPane)
        Text(
            if (all) stringResource(Res.string.run_goals_all) else stringResource(Res.string.run_goals_count, met, goals.size),
            color = colours.onPane,
            fontSize = 16.sp,
            lineHeight = 20.sp,
            fontWeight = FontWeight.Medium,
        )
    }
}

private val CORNER = 24.dp
