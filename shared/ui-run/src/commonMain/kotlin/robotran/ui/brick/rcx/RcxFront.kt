package robotran.ui.brick.rcx

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.aspectRatio
import androidx.compose.foundation.layout.offset
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.isTraversalGroup
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.Dp
import robotran.brick.controls.BrickButton
import robotran.rcxrom.state.RcxState
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.uikit.*
import robotran.world.PortSensor

/**
 * The front of an RCX, with four buttons that support multi-touch.
 *
 * @param down the buttons drawn pressed.
 * @param ports the sensors on the input ports.
 * @param onTouch called when the user presses or releases the touch sensor on an input port, 0..2.
 */
@Composable
internal fun RcxFront(
    state: RcxState,
    down: Set<BrickButton>,
    onPress: (BrickButton) -> Unit,
    onRelease: (BrickButton) -> Unit,
    modifier: Modifier,
    ports: List<List<PortSensor>>,
    onTouch: (Int, Boolean) -> Unit,
) {
    val description = RunTexts.brick(spoken)
    BoxWithConstraints(
        modifier
            .aspectRatio(BrickPlan.ASPECT)
            .testTag(RunTags.BRICK)
            .semantics {
                contentDescription = description
                isTraversalGroup = true
            },
    ) {
        val unit = maxWidth / BrickPlan.WIDTH
        Canvas(Modifier.matchParentSize()) { drawBrickBody(state.infrared.sending) }
        state.sensors.forEachIndexed { port, sensor ->
            val plugged = PluggedSensor.of(ports.getOrElse(port) { emptyList() })
            InputPort(sensor, plugged, state.poweredOn, unit, {
                onTouch(port, it)
            }, Modifier.at(BrickPlan.INPUTS[port], unit))
        }
        for ((button, place) in BrickPlan.BUTTONS) {
            BrickButtonView(button, unit, button in down, {
                onPress(button)
            }, { onRelease(button) }, Modifier.at(place, unit))
        }
        LcdView(state.glass, Modifier.at(BrickPlan.DISPLAY, unit))
        for (motor in state.motors) {
            OutputPort(motor, unit, Modifier.at(BrickPlan.OUTPUTS.getValue(motor.port), unit))
        }
    }
}

private fun Modifier.at(bounds: Rect, unit: Dp): Modifier =
    offset(unit * bounds.left, unit * bounds.top).size(unit * bounds.width, unit * bounds.height)
