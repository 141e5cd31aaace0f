package robotran.ui.export

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.selection.selectable
import androidx.compose.foundation.selection.selectableGroup
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.unit.dp
import robotran.ui.school.tags.ExportTags
import robotran.ui.school.texts.ExportTexts
import robotran.uikit.*
import robotran.workshop.event.ExportEvent
import robotran.workshop.state.MovingKind
import robotran.workshop.state.ShowError
import robotran.workshop.state.ShowSpeed
import robotran.workshop.state.ShowStep
import kotlin.math.roundToInt

@Composable
internal fun SpeedChoice(step: ShowStep.ChoosingSpeed, onEvent: (ExportEvent) -> Unit) {
    Column(Modifier.fillMaxSize().verticalScroll(rememberScrollState()), Arrangement.spacedBy(8.dp)) {
        Text(ExportTexts.speedTitle(spoken), Modifier.heading(), TextStyles.cardTitle.medium)
        Column(Modifier.selectableGroup()) {
            for (speed in step.speeds) {
                SpeedRow(speed, speed == step.chosen) { onEvent(ExportEvent.SpeedChosen(speed)) }
            }
        }
        if (step.kind == MovingKind.VIDEO) Explanation(ExportTexts.videoTime(spoken))
    }
}

@Composable
private fun SpeedRow(speed: ShowSpeed, isChosen: Boolean, onClick: () -> Unit) {
    val colours = LocalRobotranColours.current
    Row(
        Modifier
            .fillMaxWidth()
            .heightIn(min = Dimensions.TARGET)
            .focusRing()
            .selectable(isChosen, role = Role.RadioButton, onClick = onClick)
            .testTag(ExportTags.speed(speed.factor))
            .padding(horizontal = 4.dp),
        Arrangement.spacedBy(12.dp),
        Alignment.CenterVertically,
    ) {
        RadioMark(isChosen)
        val words = if (speed.factor == 1) {
            ExportTexts.speedOwn(spoken)
        } else {
            ExportTexts.speedTimes(spoken, speed.factor)
        }
        Text(words, Modifier.weight(1f), TextStyles.label)
        Text(ExportTexts.seconds(spoken, speed.seconds), style = TextStyles.body, color = colours.quiet)
    }
}

@Composable
internal fun MakingView(step: ShowStep.Making) {
    val colours = LocalRobotranColours.current
    val words = when (step.kind) {
        MovingKind.PICTURE -> ExportTexts.makingMoving(spoken)
        MovingKind.VIDEO -> ExportTexts.makingVideo(spoken)
    }
    val percent = ExportTexts.percent(spoken, (step.progress * PERCENT).roundToInt())
    Column(Modifier.fillMaxSize(), Arrangement.spacedBy(16.dp, Alignment.CenterVertically)) {
        Text(
            words,
            Modifier.fillMaxWidth().testTag(ExportTags.SHOW_MAKING).announced(),
            TextStyles.cardTitle,
        )
        Progress(
            { step.progress },
            Modifier.fillMaxWidth().height(10.dp).testTag(ExportTags.SHOW_PROGRESS).named(percent),
        )
        Text(percent, style = TextStyles.body, color = colours.quiet)
    }
}

/** One sentence in the middle. */
@Composable
internal fun FailedView(error: ShowError) {
    Column(Modifier.fillMaxSize(), Arrangement.Center) {
        Text(
            sentenceOf(error),
            Modifier.fillMaxWidth().testTag(ExportTags.SHOW_FAILED).announced(),
            TextStyles.leadSentence,
            color = LocalRobotranColours.current.error,
        )
    }
}

@Composable
internal fun sentenceOf(error: ShowError): String = when (error) {
    ShowError.TooLarge -> ExportTexts.tooLarge(spoken)
    ShowError.NoVideo -> ExportTexts.noVideo(spoken)
    ShowError.NotShared -> ExportTexts.notShared(spoken)
    is ShowError.NotPrinted -> ExportTexts.notPrinted(spoken, error.reason).trim()

    is ShowError.NotSaved -> when {
        error.isFull -> ExportTexts.full(spoken)
        else -> ExportTexts.notSaved(spoken, error.reason).trim()
    }
}

private const val PERCENT = 100
