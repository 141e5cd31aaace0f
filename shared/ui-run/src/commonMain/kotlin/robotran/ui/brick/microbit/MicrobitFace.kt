package robotran.ui.brick.microbit

import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.controls.MotorState
import robotran.brick.state.BrickState
import robotran.microbit.display.BoardScreen
import robotran.microbit.model.MicrobitModel
import robotran.microbit.state.MicrobitState
import robotran.ui.brick.front.BrickFace
import robotran.ui.brick.front.FrontPlan
import robotran.ui.brick.front.LightMatrix
import robotran.ui.brick.front.MatrixLook
import robotran.ui.brick.front.PortItem
import robotran.ui.brick.front.PortView
import robotran.ui.brick.front.drawDirectionArrow
import robotran.ui.brick.front.drawSensorIcon
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.ui.sheet.valueText
import robotran.ui.texts.CommonTexts
import robotran.ui.texts.HubTexts
import robotran.ui.texts.MicrobitTexts
import robotran.ui.texts.words
import robotran.uikit.*
import robotran.world.RobotDescription
import robotran.world.pluggedMotors

/** A micro:bit on its buggy. */
internal class MicrobitFace(private val model: MicrobitModel) : BrickFace {
    override val plan: FrontPlan = microbitPlan(model)

    @Composable
    override fun Display(state: BrickState, unit: Dp, modifier: Modifier) = Lights(state, modifier)

    @Composable
    override fun StripDisplay(state: BrickState, isLow: Boolean) =
        Lights(state, Modifier.size(if (isLow) 48.dp else 58.dp))

    /** A sensor of the buggy, and what it measures. */
    @Composable
    override fun input(state: BrickState, index: Int, robot: RobotDescription): PortView {
        val port = (state as MicrobitState).ports[index]
        val plugged = remember(robot) { robot.parts.firstOrNull { it.port == port.port } }
        val value = valueText(port, plugged?.kind)
        val name = plugged?.kind?.words(spoken) ?: RunTexts.sensorNone(spoken)
        val sensor = CommonTexts.sensor(spoken, "${port.port}", name)
        val icon = plugged?.let { part ->
            PortItem.Sign(ICON, ICON) { ink -> drawSensorIcon(part.kind, false, ink, null) }
        }
        return PortView(
            "${port.port}",
            if (value == null) sensor else RunTexts.sensorValue(spoken, sensor, value),
            listOf(
                listOfNotNull(PortItem.Words("${port.port}"), icon),
                listOfNotNull(value?.let { PortItem.Words(it, VALUE_SIZE) }),
            ),
            isLit = port.isActive,
            isPlugged = plugged != null,
        )
    }

    /** A wheel with an arrow and its percents, or the pen. */
    @Composable
    override fun output(state: BrickState, index: Int, robot: RobotDescription): PortView {
        val motor = state.motors[index]
        val isPlugged = remember(robot) { motor.port in robot.pluggedMotors }
        val isForward = motor.mode == MotorMode.FORWARD
        val isDriven = isForward || motor.mode == MotorMode.BACKWARD
        val name = motor.port.name
        val arrow = PortItem.Sign(ARROW, ARROW_HEIGHT) { drawDirectionArrow(isForward, it) }
        val percent = PortItem.Words("${motor.power} %", VALUE_SIZE)
        return PortView(
            name,
            "$name, ${descriptionOf(motor, isPlugged)}",
            when {
                !isDriven -> listOf(listOf(PortItem.Words(name)))
                motor.port == MotorPort.B -> listOf(listOf(PortItem.Words(name), arrow))
                else -> listOf(listOf(PortItem.Words(name), arrow), listOf(percent))
            },
            isDriven,
            isPlugged,
        )
    }

    @Composable
    override fun BelowHint(state: BrickState, modifier: Modifier) = Unit

    /** 5 by 5 red lights, and what they show in words. */
    @Composable
    private fun Lights(state: BrickState, modifier: Modifier) {
        val screen = (state as MicrobitState).screen
        val description =
            if (screen.shown.isBlank()) HubTexts.lightsOff(spoken) else HubTexts.lights(spoken, screen.shown)
        LightMatrix(
            screen.lights.map { it.toFloat() / BoardScreen.BRIGHTEST },
            MATRIX,
            modifier.testTag(RunTags.LCD).clearAndSetSemantics {
                contentDescription = description
                liveRegion = LiveRegionMode.Polite
            },
        )
    }

    @Composable
    private fun descriptionOf(motor: MotorState, isPlugged: Boolean): String {
        val isForward = motor.mode == MotorMode.FORWARD
        return when {
            motor.port != MotorPort.B -> {
                val percent = if (isForward) motor.power else -motor.power
                MicrobitTexts.wheel(spoken, motor.port == MotorPort.A, percent)
            }

            isPlugged -> MicrobitTexts.pen(spoken, isForward)
            else -> MicrobitTexts.noPen(spoken)
        }
    }

    private companion object {
        const val ICON = 17f
        const val VALUE_SIZE = 14.5f
        const val ARROW = 12f
        const val ARROW_HEIGHT = 9f
        val MATRIX = MatrixLook(MicrobitColours.LIGHT_EDGE, MicrobitColours.LIGHT_OFF, MicrobitColours.LIGHT_ON)
    }
}
