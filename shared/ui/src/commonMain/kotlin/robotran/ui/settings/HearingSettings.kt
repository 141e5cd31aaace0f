package robotran.ui.settings

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.runsound.SoundSample
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.screen.texts.ScreenTexts
import robotran.uikit.*
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.Settings

/** Whether runs are heard, what that is for, and a button for each sound to learn what it means. */
@Composable
internal fun HearingSettings(settings: Settings, onEvent: (WorkshopEvent) -> Unit) {
    val colours = LocalRobotranColours.current
    Column(verticalArrangement = Arrangement.spacedBy(GAP)) {
        SwitchRow(ScreenTexts.settingsHearRun(spoken), settings.hearsRun, ScreenTags.HEARING_SETTING) {
            onEvent(SettingsEvent.SettingsChanged(settings.copy(hearsRun = it)))
        }
        Text(ScreenTexts.settingsHearRunHelp(spoken), style = TextStyles.small, color = colours.quiet)
        if (settings.hearsRun) Samples(settings.soundOn) { onEvent(RunEvent.SampleRequested(it)) }
    }
}

@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun Samples(isAudible: Boolean, play: (SoundSample) -> Unit) {
    val words = if (isAudible) ScreenTexts.settingsListen(spoken) else ScreenTexts.settingsListenMuted(spoken)
    Text(words, style = TextStyles.body)
    FlowRow(Modifier, Arrangement.spacedBy(GAP), Arrangement.spacedBy(GAP)) {
        for (sample in SoundSample.entries) {
            Button(sample.title(spoken), ScreenTags.sample(sample), ButtonKind.SECOND, enabled = isAudible) {
                play(sample)
            }
        }
    }
}

private val SoundSample.title: Label
    get() = when (this) {
        SoundSample.WHEELS -> ScreenTexts::sampleWheels
        SoundSample.WALL_AHEAD -> ScreenTexts::sampleWall
        SoundSample.LINE -> ScreenTexts::sampleLine
        SoundSample.INK -> ScreenTexts::sampleInk
        SoundSample.BUMP -> ScreenTexts::sampleBump
        SoundSample.GOAL -> ScreenTexts::sampleGoal
        SoundSample.GOAL_LOST -> ScreenTexts::sampleGoalLost
        SoundSample.END -> ScreenTexts::sampleEnd
    }

private val GAP = 8.dp
