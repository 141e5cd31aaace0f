package robotran.ui.runbar

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.brick.program.StepKind
import robotran.runcontrol.RunSpeed
import robotran.simulation.Breakpoint
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.uikit.*
import robotran.workshop.event.RunEvent
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.RunPaneState

/**
 * All run controls that are not in the bar, or do not fit on small screens; over everything else until it is closed.
 */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun RunPanel(state: RunPaneState, cursor: Breakpoint, onEvent: (RunEvent) -> Unit, onClose: () -> Unit) {
    val colours = LocalRobotranColours.current

    fun andClose(event: RunEvent) {
        onEvent(event)
        onClose()
    }
    DialogWindow(onClose) {
        Column(
            Modifier
                .testTag(RunTags.RUN_PANEL)
                .widthIn(max = 560.dp)
                .fillMaxWidth()
                .clip(Shapes.SHEET)
                .background(colours.pane)
                .verticalScroll(rememberScrollState())
                .padding(20.dp),
            Arrangement.spacedBy(20.dp),
        ) {
            Row(verticalAlignment = Alignment.CenterVertically) {
                Text(RunTexts.more(spoken), Modifier.weight(1f).heading(), TextStyles.heading.strong)
                IconButton(
                    RunIcons.CLOSE,
                    RunTexts.close(spoken),
                    RunTags.RUN_PANEL_CLOSE,
                    IconButtonKind.RUN,
                    onClick = onClose,
                )
            }
            SpeedAndRobot(state, onEvent)
            Section(RunTexts::look) {
                for (tab in DrawerTab.entries) {
                    Chip(tab.word(spoken), tab == state.drawer.tab, RunTags.panel(tab)) {
                        andClose(RunEvent.DrawerChosen(tab))
                    }
                }
            }
            Steps(cursor, state.hasRecording) { andClose(it) }
            RunSettings(state, onEvent)
        }
    }
}

@Composable
private fun SpeedAndRobot(state: RunPaneState, onEvent: (RunEvent) -> Unit) {
    Section(RunTexts::speed) {
        for (speed in RunSpeed.entries) {
            Chip(speed.word(spoken), speed == state.speed, RunTags.panelSpeed(speed)) {
                onEvent(RunEvent.SpeedChosen(speed))
            }
        }
    }
    if (state.world.robots.size > 1) {
        Section(RunTexts::robot) {
            state.world.robots.forEachIndexed { number, robot ->
                Chip(robot.name, number == state.watched, RunTags.robot(number)) {
                    onEvent(RunEvent.DebuggedRobotChosen(number))
                }
            }
        }
    }
}

@Composable
private fun Steps(cursor: Breakpoint, hasRecording: Boolean, onEvent: (RunEvent) -> Unit) = Section(RunTexts::steps) {
    PanelAction(RunTexts::stepOver, RunTexts::stepOverHelp, RunTags.PANEL_STEP_OVER) {
        onEvent(RunEvent.StepPressed(StepKind.OVER))
    }
    PanelAction(RunTexts::stepOut, RunTexts::stepOutHelp, RunTags.PANEL_STEP_OUT) {
        onEvent(RunEvent.StepPressed(StepKind.OUT))
    }
    PanelAction(RunTexts::toLine, RunTexts::toLineHelp, RunTags.PANEL_TO_LINE) {
        onEvent(RunEvent.RunToLine(cursor))
    }
    PanelAction(RunTexts::startOver, RunTexts::startOverHelp, RunTags.START_OVER) {
        onEvent(RunEvent.StartedOver)
    }
    if (hasRecording) {
        PanelAction(RunTexts::playRecording, RunTexts::playRecordingHelp, RunTags.PLAY_RECORDING) {
            onEvent(RunEvent.RecordingPlayed)
        }
    }
}

@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun Section(name: Label, content: @Composable () -> Unit) {
    Column {
        SectionName(name(spoken))
        FlowRow(horizontalArrangement = Arrangement.spacedBy(8.dp)) { content() }
    }
}

@Composable
private fun PanelAction(name: Label, help: Label, tag: String, onClick: () -> Unit) {
    ButtonFrame(tag, ButtonKind.TOOL, Modifier.fillMaxWidth(), onClick = onClick) {
        Box(Modifier.fillMaxWidth()) { Choice(name(spoken), help(spoken)) }
    }
}
