package robotran.ui.brick.nxt

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.aspectRatio
import androidx.compose.foundation.layout.offset
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.isTraversalGroup
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.Dp
import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorPort
import robotran.nxt.state.NxtState
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.uikit.*
import robotran.world.FingerTouchPart
import robotran.world.RobotDescription
import robotran.world.RobotPart
import robotran.world.SensorPart

/**
 * The front of an NXT, with four buttons that support multi-touch.
 *
 * @param down the buttons drawn pressed.
 * @param robot what is plugged in.
 * @param onTouch called when the user presses or releases the touch sensor on a sensor port, 0..3.
 */
@Composable
internal fun NxtFront(
    state: NxtState,
    down: Set<BrickButton>,
    onPress: (BrickButton) -> Unit,
    onRelease: (BrickButton) -> Unit,
    modifier: Modifier,
    robot: RobotDescription,
    onTouch: (Int, Boolean) -> Unit,
) {
    val description = RunTexts.brick(spoken)
    val motors = remember(robot) { robot.motors }
    BoxWithConstraints(
        modifier
            .aspectRatio(NxtPlan.WIDTH / NxtPlan.HEIGHT)
            .testTag(RunTags.BRICK)
            .semantics {
                contentDescription = description
                isTraversalGroup = true
            },
    ) {
        val unit = maxWidth / NxtPlan.WIDTH
        Canvas(Modifier.matchParentSize()) { drawNxtBody(state.sounding, state.isSending) }
        state.motors.forEachIndexed { index, motor ->
            val place = Modifier.at(NxtPlan.MOTORS.getValue(motor.port), unit)
            MotorPlug(motor, state.motorDegrees[index], motor.port in motors, unit, place)
        }
        NxtDisplayView(state, unit * GLASS_MARGIN, Modifier.at(NxtPlan.GLASS, unit))
        for ((button, place) in NxtPlan.BUTTONS) {
            NxtButtonView(button, unit, button in down, {
                onPress(button)
            }, { onRelease(button) }, Modifier.at(place, unit))
        }
        state.sensorPorts.forEachIndexed { port, sensor ->
            SensorPlug(sensor, robot.partOn(sensor.port), state.poweredOn, unit, {
                onTouch(port, it)
            }, Modifier.at(NxtPlan.SENSORS[port], unit))
        }
    }
}

/** The part to show for a port: the one that can be pressed, or the first. */
private fun RobotDescription.partOn(port: Int): RobotPart? {
    val plugged = parts.filter { it.port == port }
    return plugged.find { it is FingerTouchPart } ?: plugged.firstOrNull()
}

private val RobotDescription.motors: Set<MotorPort>
    get() = setOfNotNull(drive.left, drive.right, pen?.motor) +
        parts.filterIsInstance<SensorPart>().mapNotNull { it.turret }

private fun Modifier.at(bounds: Rect, unit: Dp): Modifier =
    offset(unit * bounds.left, unit * bounds.top).size(unit * bounds.width, unit * bounds.height)

/** Of the glass around the dots, in units of the [NxtPlan]. */
private const val GLASS_MARGIN = 7f
