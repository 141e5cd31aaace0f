package robotran.ui.brick.hub

import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.brick.controls.MotorMode
import robotran.brick.sensors.SensorKind
import robotran.brick.state.BrickState
import robotran.hub.model.HubColor
import robotran.hub.model.HubModel
import robotran.hub.state.HubInput
import robotran.hub.state.HubState
import robotran.ui.brick.front.BrickFace
import robotran.ui.brick.front.FrontPlan
import robotran.ui.brick.front.PortItem
import robotran.ui.brick.front.PortView
import robotran.ui.brick.front.drawDirectionArrow
import robotran.ui.brick.front.drawSensorIcon
import robotran.ui.run.texts.RunTexts
import robotran.ui.sheet.valueText
import robotran.ui.texts.CommonTexts
import robotran.ui.texts.NxtTexts
import robotran.ui.texts.words
import robotran.uikit.*
import robotran.world.FingerTouchPart
import robotran.world.RobotDescription
import robotran.world.RobotPart
import robotran.world.pluggedMotors

/** A hub with Pybricks. */
internal class HubFace(private val model: HubModel) : BrickFace {
    override val plan: FrontPlan = HubPlan.of(model)
    private val ring = HubPlan.planOf(model)?.ring

    @Composable
    override fun Display(state: BrickState, unit: Dp, modifier: Modifier) =
        HubDisplayView(state as HubState, unit, modifier)

    @Composable
    override fun StripDisplay(state: BrickState, isLow: Boolean) {
        val height = if (isLow) 48.dp else 58.dp
        val width = if (model.hasMatrix) height else height * 2
        val hasOwn = model.hasMatrix || model.hasScreen
        val unit = if (hasOwn) width / STRIP_UNITS else 1.dp
        HubDisplayView(state as HubState, unit, Modifier.size(width, height), printed = STRIP_LINES)
    }

    /** The ring of the status light around the button. */
    override fun DrawScope.drawLamps(state: BrickState) {
        val (middle, radius) = ring ?: return
        drawCircle(colourOf((state as HubState).light), radius, middle, style = Stroke(RING_WIDTH))
    }

    private fun colourOf(light: HubColor): Color = if (light == HubColor.NONE) {
        HubColours.RING_OFF
    } else {
        Color.hsv(light.hue.toFloat(), light.saturation / PERCENT, light.value / PERCENT)
    }

    /** What is plugged in, and what it measures; on a hub with letters that may be a motor. */
    @Composable
    override fun input(state: BrickState, index: Int, robot: RobotDescription): PortView {
        val port = (state as HubState).ports[index]
        val plugged = remember(robot) { robot.partOn(port.port) }
        val motor = if (model.kind.hasLetteredInputs) model.kind.motorPorts.getOrNull(index) else null
        if (motor != null && plugged == null) return output(state, motor.ordinal, robot)
        val isPressed = plugged?.kind == SensorKind.TOUCH && port.isPressed
        val value = valueText(port, plugged?.kind)
        val name = model.kind.inputLabel(port.port)
        val icon = plugged?.let { part ->
            PortItem.Sign(ICON, ICON) { ink -> drawSensorIcon(part.kind, isPressed, ink, null) }
        }
        return PortView(
            name,
            descriptionOf(port, plugged, value),
            listOf(
                listOfNotNull(PortItem.Words(name), icon),
                listOfNotNull(value?.let { PortItem.Words(it, VALUE_SIZE) }),
            ),
            isLit = isPressed || port.isActive,
            isPlugged = plugged != null,
            isPressed = isPressed.takeIf { plugged is FingerTouchPart },
        )
    }

    @Composable
    private fun descriptionOf(port: HubInput, plugged: RobotPart?, value: String?): String {
        val name = when {
            plugged == null -> RunTexts.sensorNone(spoken)
            plugged is FingerTouchPart -> RunTexts.sensorTouch(spoken)
            else -> plugged.kind.words(spoken)
        }
        val sensor = CommonTexts.sensor(spoken, model.kind.inputLabel(port.port), name)
        return if (value == null) sensor else RunTexts.sensorValue(spoken, sensor, value)
    }

    @Composable
    override fun output(state: BrickState, index: Int, robot: RobotDescription): PortView {
        val motor = state.motors[index]
        val degrees = state.motorDegrees[index]
        val name = motor.port.name
        val description = when (motor.mode) {
            MotorMode.FORWARD -> NxtTexts.motorForward(spoken, name, motor.power, degrees)
            MotorMode.BACKWARD -> NxtTexts.motorBackward(spoken, name, motor.power, degrees)
            MotorMode.BRAKE -> NxtTexts.motorBrake(spoken, name, degrees)
            MotorMode.FLOAT -> NxtTexts.motorFloat(spoken, name, degrees)
        }
        val isPlugged = remember(robot) { motor.port in robot.pluggedMotors }
        val isDriven = motor.mode == MotorMode.FORWARD || motor.mode == MotorMode.BACKWARD
        val isNarrow = !model.kind.hasLetteredInputs && model.motorPorts.size > NARROW_FROM
        val words = if (isNarrow) NARROW_SIZE else WORDS_SIZE
        val driven = listOf(
            PortItem.Sign(words * ARROW, 9f) { drawDirectionArrow(motor.mode == MotorMode.FORWARD, it) },
            PortItem.Words("${motor.power}", words),
        )
        return PortView(
            name,
            description,
            listOf(
                listOf(PortItem.Words(name, words)) + if (isDriven) driven else emptyList(),
                if (isPlugged || degrees != 0) listOf(PortItem.Words("$degrees°", VALUE_SIZE)) else emptyList(),
            ),
            isDriven,
            isPlugged,
        )
    }

    @Composable
    override fun BelowHint(state: BrickState, modifier: Modifier) = Unit

    private companion object {
        const val ICON = 17f
        const val VALUE_SIZE = 14.5f
        const val RING_WIDTH = 5f
        const val PERCENT = 100f

        /** How many units wide a screen would be that is as wide as that of a brick in one row. */
        const val STRIP_UNITS = 184f

        /** How many lines of output a brick in one row has room for. */
        const val STRIP_LINES = 2

        /** The size of the words on a port where four of them are in a row. */
        const val NARROW_SIZE = 14f
        const val WORDS_SIZE = 16f
        const val NARROW_FROM = 3
        const val ARROW = 0.68f
    }
}

/** The part to show for a port: the one that can be pressed, or the first. */
private fun RobotDescription.partOn(port: Int): RobotPart? {
    val plugged = parts.filter { it.port == port }
    return plugged.find { it is FingerTouchPart } ?: plugged.firstOrNull()
}
