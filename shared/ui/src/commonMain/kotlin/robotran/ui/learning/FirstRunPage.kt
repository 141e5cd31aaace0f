package robotran.ui.learning

import androidx.compose.foundation.BorderStroke
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.IntrinsicSize
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.Surface
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import org.jetbrains.compose.resources.stringResource
import robotran.projects.ProgramView
import robotran.ui.parts.Icon
import robotran.ui.parts.Page
import robotran.ui.parts.SmallIcon
import robotran.ui.resources.Res
import robotran.ui.resources.learning_map_all
import robotran.ui.resources.learning_try_square
import robotran.ui.resources.learning_try_square_help
import robotran.ui.resources.learning_try_tutorial
import robotran.ui.resources.learning_try_tutorial_help
import robotran.ui.resources.learning_try_worlds
import robotran.ui.resources.learning_try_worlds_help
import robotran.ui.resources.learning_welcome
import robotran.ui.resources.learning_welcome_again
import robotran.ui.resources.learning_welcome_title
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.RobotranColours
import robotran.ui.theme.focusRing
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.LearningPage

/**
 * Explains the app in one sentence, asks how programs shall be shown, and offers three first steps.
 *
 * @param view how programs are shown now: in blocks where there are only fingers, as text where there is a keyboard.
 */
@Composable
internal fun FirstRunPage(view: ProgramView, onEvent: (WorkshopEvent) -> Unit) {
    val colours = LocalRobotranColours.current
    Page(stringResource(Res.string.learning_welcome_title), "first-run", {
        onEvent(LearningEvent.PageClosed)
    }, maxWidth = 960.dp) {
        Column(Modifier.verticalScroll(rememberScrollState()).padding(24.dp), Arrangement.spacedBy(24.dp)) {
            Text(
                stringResource(Res.string.learning_welcome),
                color = colours.onPane,
                fontSize = 20.sp,
                lineHeight = 28.sp,
            )
            ViewChoice(view) { onEvent(BlockEvent.ViewChosen(it)) }
            ThingsToTry(onEvent)
            SecondButton(stringResource(Res.string.learning_map_all), "try-lessons", {
                onEvent(LearningEvent.PageRequested(LearningPage.MAP))
            })
            Text(stringResource(Res.string.learning_welcome_again), color = colours.quiet, fontSize = 16.sp)
        }
    }
}

/** Side by side if there is room, otherwise stacked. */
@Composable
private fun ThingsToTry(onEvent: (LearningEvent) -> Unit) {
    BoxWithConstraints {
        if (maxWidth / LocalDensity.current.fontScale >= BESIDE_WIDTH) {
            Row(Modifier.height(IntrinsicSize.Max), Arrangement.spacedBy(GAP)) {
                Things(onEvent, Modifier.weight(1f).fillMaxHeight())
            }
        } else {
            Column(verticalArrangement = Arrangement.spacedBy(GAP)) { Things(onEvent, Modifier.fillMaxWidth()) }
        }
    }
}

@Composable
private fun Things(onEvent: (LearningEvent) -> Unit, modifier: Modifier) {
    ElementRef(
        PLAY_ICON,
        stringResource(Res.string.learning_try_square),
        stringResource(Res.string.learning_try_square_help),
        "try-square",
        modifier,
        isFirst = true,
    ) { onEvent(LearningEvent.FirstProgramTried) }
    ElementRef(
        Icon.BOOK,
        stringResource(Res.string.learning_try_tutorial),
        stringResource(Res.string.learning_try_tutorial_help),
        "try-tutorial",
        modifier,
    ) { onEvent(LearningEvent.TutorialStarted) }
    ElementRef(
        Icon.WORLDS,
        stringResource(Res.string.learning_try_worlds),
        stringResource(Res.string.learning_try_worlds_help),
        "try-worlds",
        modifier,
    ) { onEvent(LearningEvent.PageRequested(LearningPage.WORLDS)) }
}

/** One suggestion; the first is the recommended one. */
@Composable
private fun ElementRef(
    icon: Icon,
    title: String,
    help: String,
    tag: String,
    modifier: Modifier,
    isFirst: Boolean = false,
    onClick: () -> Unit,
) {
    val colours = LocalRobotranColours.current
    val onGround = if (isFirst) RobotranColours.ON_YELLOW else colours.onPane
    Surface(
        modifier.testTag(
            tag,
        ).focusRing(CORNER).clip(RoundedCornerShape(CORNER)).clickable(role = Role.Button, onClick = onClick),
        shape = RoundedCornerShape(CORNER),
        color = if (isFirst) RobotranColours.YELLOW else colours.pane,
        border = if (isFirst) null else BorderStroke(1.dp, colours.quiet),
    ) {
        Row(Modifier.padding(20.dp), Arrangement.spacedBy(16.dp), Alignment.Top) {
            SmallIcon(icon, onGround, size = 32.dp)
            Column(verticalArrangement = Arrangement.spacedBy(4.dp)) {
                Text(title, color = onGround, fontSize = 20.sp, fontWeight = FontWeight.SemiBold)
                Text(help, color = onGround, fontSize = 16.sp, lineHeight = 22.sp)
            }
        }
    }
}

/** From this width on, at default font size, the three are side by side. */
private val BESIDE_WIDTH = 760.dp
private val GAP = 16.dp
private val CORNER = 16.dp
