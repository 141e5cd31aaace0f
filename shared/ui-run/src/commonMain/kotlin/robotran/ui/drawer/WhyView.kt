package robotran.ui.drawer

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.ui.common.PlugInButton
import robotran.ui.empty.EmptyPicture
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.uikit.*
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.state.RunPaneState

/** Why the robot deviated from its ideal path, and advice on the run. */
@Composable
internal fun WhyView(state: RunPaneState, onEvent: (WorkshopEvent) -> Unit, modifier: Modifier = Modifier) {
    val why = state.drawer.why
    if (why.deviationCauses.isEmpty() &&
        why.warnings.isEmpty()
    ) {
        return EmptyDrawer(emptyWords(state), EmptyPicture.WAY, modifier)
    }
    val several = state.world.robots.size > 1
    Column(modifier.verticalScroll(rememberScrollState()).padding(16.dp), Arrangement.spacedBy(12.dp)) {
        if (why.deviationCauses.isNotEmpty()) SectionName(RunTexts.whyInfluences(spoken))
        for (influence in why.deviationCauses) {
            Sentence(
                if (several) "${influence.robot}: ${influence.sentence}" else influence.sentence,
                RunTags.INFLUENCE,
            )
        }
        if (why.warnings.isNotEmpty()) SectionName(RunTexts.whyRemarks(spoken))
        for (warning in why.warnings) {
            val text = if (warning.sourceLine == 0) {
                warning.message
            } else {
                RunTexts.whyLine(spoken, warning.sourceLine, warning.message)
            }
            Sentence(text, RunTags.WHY_REMARK)
            state.session.robots[state.watched].missingSensors?.takeIf { it.warning == warning }?.let { missing ->
                val robot = state.world.robots[state.watched].name
                PlugInButton(missing, { onEvent(WorldEditEvent.SensorsPluggedIn(robot, it)) })
            }
        }
    }
}

private fun emptyWords(state: RunPaneState): Label =
    if (state.world.realism == 0.0) RunTexts::whyExact else RunTexts::whyEmpty

@Composable
private fun Sentence(text: String, tag: String) {
    Text(text, Modifier.testTag(tag), TextStyles.label)
}
