package robotran.ui.brick.rcx

import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.brick.controls.MotorMode
import robotran.brick.state.BrickState
import robotran.rcxrom.state.RcxState
import robotran.ui.brick.front.BrickFace
import robotran.ui.brick.front.FrontPlan
import robotran.ui.brick.front.PortItem
import robotran.ui.brick.front.PortView
import robotran.ui.brick.front.drawDirectionArrow
import robotran.ui.brick.front.drawSensorIcon
import robotran.ui.run.texts.RunTexts
import robotran.ui.texts.CommonTexts
import robotran.uikit.*
import robotran.world.RobotDescription
import robotran.world.pluggedSensors

/** An RCX. */
internal object RcxFace : BrickFace {
    override val plan: FrontPlan = RcxPlan.front

    @Composable
    override fun Display(state: BrickState, unit: Dp, modifier: Modifier) = LcdView((state as RcxState).glass, modifier)

    /** The digits. */
    @Composable
    override fun StripDisplay(state: BrickState, isLow: Boolean) =
        LcdNumbers((state as RcxState).glass, if (isLow) Modifier.size(110.dp, 48.dp) else Modifier.size(134.dp, 58.dp))

    /** A sensor and its value. The port is lit while it is powered or its bumper is pressed. */
    @Composable
    override fun input(state: BrickState, index: Int, robot: RobotDescription): PortView {
        val sensor = (state as RcxState).sensors[index]
        val plugged = remember(robot) { PluggedSensor.of(robot.pluggedSensors.getOrElse(index) { emptyList() }) }
        val isPressed = plugged.isPressed(sensor)
        val value = if (state.poweredOn) "${sensor.value}" else ""
        val port = CommonTexts.sensor(spoken, "${sensor.port}", plugged.words(spoken))
        val icon = PortItem.Sign(ICON, ICON) { ink -> plugged.kind?.let { drawSensorIcon(it, isPressed, ink) } }
        return PortView(
            "${sensor.port}",
            if (state.poweredOn) RunTexts.sensorValue(spoken, port, value) else port,
            listOf(listOf(PortItem.Words("${sensor.port}"), icon), listOf(PortItem.Words(value))),
            isLit = state.poweredOn && (sensor.active || isPressed),
            isPressed = isPressed.takeIf { plugged == PluggedSensor.TOUCH },
        )
    }

    /** The port is lit while its motor is driven, with an arrow for the direction and a digit for the power. */
    @Composable
    override fun output(state: BrickState, index: Int, robot: RobotDescription): PortView {
        val motor = state.motors[index]
        val name = motor.port.name
        val description = when (motor.mode) {
            MotorMode.FORWARD -> RunTexts.motorForward(spoken, name, motor.power)
            MotorMode.BACKWARD -> RunTexts.motorBackward(spoken, name, motor.power)
            MotorMode.BRAKE -> RunTexts.motorBrake(spoken, name)
            MotorMode.FLOAT -> RunTexts.motorFloat(spoken, name)
        }
        val isDriven = motor.mode == MotorMode.FORWARD || motor.mode == MotorMode.BACKWARD
        val arrow = PortItem.Sign(16f, 11f) { drawDirectionArrow(motor.mode == MotorMode.FORWARD, it) }
        val words = PortItem.Words(if (isDriven) "$name ${motor.power}" else name)
        return PortView(
            name,
            description,
            listOf(listOf(words)) + if (isDriven) listOf(listOf(arrow)) else emptyList(),
            isDriven,
        )
    }

    @Composable
    override fun BelowHint(state: BrickState, modifier: Modifier) = Unit

    /** Of the picture of a sensor, in units. */
    private const val ICON = 16f
}
