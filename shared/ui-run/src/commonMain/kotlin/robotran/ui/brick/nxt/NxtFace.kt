package robotran.ui.brick.nxt

import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.Dp
import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.sensors.SensorKind
import robotran.brick.state.BrickState
import robotran.nxt.hardware.SensorPortState
import robotran.nxt.state.NxtState
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
import robotran.world.SensorPart

/** An NXT. */
internal object NxtFace : BrickFace {
    override val plan: FrontPlan = NxtPlan.front

    @Composable
    override fun Display(state: BrickState, unit: Dp, modifier: Modifier) =
        NxtDisplayView(state as NxtState, unit * GLASS_MARGIN, modifier)

    @Composable
    override fun StripDisplay(state: BrickState, isLow: Boolean) = NxtRows(state as NxtState, isLow)

    /**
     * What is plugged in and, in its unit, what that measures, also while no program runs. The port is lit while it is
     * powered or its touch sensor is pressed.
     */
    @Composable
    override fun input(state: BrickState, index: Int, robot: RobotDescription): PortView {
        val port = (state as NxtState).sensorPorts[index]
        val plugged = remember(robot) { robot.partOn(port.port) }
        val isPressed = plugged?.kind == SensorKind.TOUCH && port.isPressed
        val value = if (state.poweredOn) valueText(port, plugged?.kind) else null
        val icon = plugged?.let { part ->
            val seen = port.colour?.let { NxtColours.of(it.kind) }
            PortItem.Sign(ICON, ICON) { ink -> drawSensorIcon(part.kind, isPressed, ink, seen) }
        }
        return PortView(
            "${port.port}",
            descriptionOf(port, plugged, value),
            listOf(
                listOfNotNull(PortItem.Words("${port.port}"), icon),
                listOfNotNull(value?.let { PortItem.Words(it, VALUE_SIZE) }),
            ),
            isLit = state.poweredOn && (isPressed || port.isActive),
            isPlugged = plugged != null,
            isPressed = isPressed.takeIf { plugged is FingerTouchPart },
        )
    }

    @Composable
    private fun descriptionOf(state: SensorPortState, plugged: RobotPart?, value: String?): String {
        val name = when {
            plugged == null -> RunTexts.sensorNone(spoken)
            plugged is FingerTouchPart -> RunTexts.sensorTouch(spoken)
            else -> plugged.kind.words(spoken)
        }
        val port = CommonTexts.sensor(spoken, "${state.port}", name)
        return if (value == null) port else RunTexts.sensorValue(spoken, port, value)
    }

    /**
     * The degrees of its counter. The port is lit while its motor is driven, with an arrow for the direction and the
     * power.
     */
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
        val isPlugged = remember(robot) { motor.port in robot.motors }
        val isDriven = motor.mode == MotorMode.FORWARD || motor.mode == MotorMode.BACKWARD
        val driven = listOf(
            PortItem.Sign(11f, 9f) { drawDirectionArrow(motor.mode == MotorMode.FORWARD, it) },
            PortItem.Words("${motor.power}"),
        )
        return PortView(
            name,
            description,
            listOf(
                listOf(PortItem.Words(name)) + if (isDriven) driven else emptyList(),
                if (isPlugged || degrees != 0) listOf(PortItem.Words("$degrees°", VALUE_SIZE)) else emptyList(),
            ),
            isDriven,
            isPlugged,
        )
    }

    @Composable
    override fun BelowHint(state: BrickState, modifier: Modifier) {
        (state as NxtState).exception?.let { ExceptionCalls(it, modifier) }
    }

    /** Of the glass around the dots, of the picture of a sensor and of the letters of a value, in units. */
    private const val GLASS_MARGIN = 7f
    private const val ICON = 17f
    private const val VALUE_SIZE = 14.5f
}

/** The part to show for a port: the one that can be pressed, or the first. */
private fun RobotDescription.partOn(port: Int): RobotPart? {
    val plugged = parts.filter { it.port == port }
    return plugged.find { it is FingerTouchPart } ?: plugged.firstOrNull()
}

private val RobotDescription.motors: Set<MotorPort>
    get() = setOfNotNull(drive.left, drive.right, pen?.motor) +
        parts.filterIsInstance<SensorPart>().mapNotNull { it.turret }
