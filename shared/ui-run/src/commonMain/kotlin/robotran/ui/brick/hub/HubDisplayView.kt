package robotran.ui.brick.hub

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.text.BasicText
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.lerp
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import robotran.hub.display.HubScreen
import robotran.hub.state.HubState
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.ui.texts.HubTexts
import robotran.uikit.*

/** The lights of a hub, its rows of text, or nothing. */
@Composable
internal fun HubDisplayView(state: HubState, modifier: Modifier = Modifier) {
    val screen = state.screen
    val description = descriptionOf(screen)
    val spokenModifier = modifier.testTag(RunTags.LCD).clearAndSetSemantics {
        contentDescription = description
        liveRegion = LiveRegionMode.Polite
    }
    if (screen.rows.isEmpty()) Lights(screen.lights, spokenModifier) else Rows(screen.rows, spokenModifier)
}

@Composable
private fun descriptionOf(screen: HubScreen): String {
    val words = screen.lines.filter { it.isNotBlank() }
    return when {
        screen.lights.isEmpty() && words.isEmpty() -> RunTexts.displayBlank(spoken)
        screen.lights.isEmpty() -> RunTexts.display(spoken, words.joinToString("\n"))
        words.isEmpty() -> HubTexts.lightsOff(spoken)
        else -> HubTexts.lights(spoken, words.joinToString(" "))
    }
}

/** 5 by 5 lights, each as bright as it is. */
@Composable
private fun Lights(lights: List<Int>, modifier: Modifier) = Canvas(modifier) {
    if (lights.isEmpty()) return@Canvas
    val cell = size.minDimension / SIDE
    val left = (size.width - SIDE * cell) / 2
    for ((place, light) in lights.withIndex()) {
        val middle = Offset(left + (place % SIDE + HALF) * cell, (place / SIDE + HALF) * cell)
        val colour = lerp(HubColours.LIGHT_OFF, HubColours.LIGHT_ON, light / FULL)
        drawCircle(colour, cell * RADIUS, middle)
    }
}

@Composable
private fun Rows(rows: List<String>, modifier: Modifier) = Column(modifier.background(HubColours.GLASS).padding(4.dp)) {
    for (row in rows) BasicText(row, style = TextStyle(color = HubColours.INK, fontSize = 9.sp), maxLines = 1)
}

private const val SIDE = 5
private const val HALF = 0.5f
private const val RADIUS = 0.36f
private const val FULL = 100f
