package robotran.ui.drawer

import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.shape.CircleShape
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.text.style.TextDecoration
import androidx.compose.ui.unit.dp
import robotran.simulation.messages.SimulationMessages
import robotran.simulation.messages.sentenceFor
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.ui.sheet.SheetColours
import robotran.uikit.*
import robotran.workshop.event.RunEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.ShortfallMark

/** What was missing for a goal, with the letter of its pin. A touch shows the moment and the place. */
@Composable
fun ShortfallRow(mark: ShortfallMark, onEvent: (WorkshopEvent) -> Unit, modifier: Modifier = Modifier) {
    val colours = LocalRobotranColours.current
    val sentence = SimulationMessages.of(LocalLanguage.current).sentenceFor(mark.shortfall)
    val help = RunTexts.shortfallShow(spoken)
    val canShow = mark.shortfall.moment != null || mark.shortfall.place != null
    Row(
        modifier
            .testTag(RunTags.SHORTFALL)
            .focusRing(CORNER)
            .clip(RoundedCornerShape(CORNER))
            .then(
                if (canShow) {
                    Modifier.clickable(onClickLabel = help, role = Role.Button) {
                        onEvent(RunEvent.ShortfallShown(mark.shortfall))
                    }.defaultMinSize(minHeight = Dimensions.TARGET)
                } else {
                    Modifier
                },
            )
            .semantics(mergeDescendants = true) { },
        Arrangement.spacedBy(8.dp),
        Alignment.CenterVertically,
    ) {
        mark.sign?.let { PinLetter(it) }
        Column(Modifier.padding(vertical = 4.dp)) {
            Text(
                sentence,
                Modifier.testTag(RunTags.SHORTFALL_TEXT),
                TextStyles.label.medium.copy(textDecoration = if (canShow) TextDecoration.Underline else null),
            )
            lineText(mark)?.let {
                Text(it, style = TextStyles.smallLines, color = colours.quiet)
            }
        }
    }
}

/** The program's line at the moment; null if there is none. */
@Composable
private fun lineText(mark: ShortfallMark): String? {
    val moment = mark.shortfall.moment?.takeIf { it.sourceLine > 0 } ?: return null
    val line = moment.sourceLine
    val file = moment.sourceFile
    val robot = moment.robot
    return when {
        robot != null && file != null -> RunTexts.shortfallLineOfRobotsFile(spoken, robot, line, file)
        robot != null -> RunTexts.shortfallLineOfRobot(spoken, robot, line)
        file != null -> RunTexts.shortfallLineOfFile(spoken, line, file)
        else -> RunTexts.shortfallLine(spoken, line)
    }
}

/** The letter as on the pin on the sheet. */
@Composable
private fun PinLetter(letter: String) {
    Box(
        Modifier
            .clearAndSetSemantics { }
            .background(SheetColours.SHORTFALL, CircleShape)
            .size(PIN * LocalDensity.current.fontScale.coerceAtLeast(1f)),
        Alignment.Center,
    ) {
        Text(
            letter,
            style = TextStyles.small.copy(fontWeight = FontWeight.Bold),
            color = RobotranColours.ON_COLOUR,
            textAlign = TextAlign.Center,
        )
    }
}

private val PIN = 26.dp
private val CORNER = Corners.SMALL
