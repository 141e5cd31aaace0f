package robotran.ui.brick.nxt

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.SemanticsPropertyReceiver
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.onClick
import androidx.compose.ui.semantics.role
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorState
import robotran.brick.sensors.SensorKind
import robotran.nxt.hardware.SensorPortState
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.ui.sheet.valueText
import robotran.ui.texts.CommonTexts
import robotran.ui.texts.NxtTexts
import robotran.ui.texts.words
import robotran.uikit.*
import robotran.world.FingerTouchPart
import robotran.world.RobotPart

/**
 * A sensor port with what is plugged in and, in its unit, what that measures, also while no program runs. It is lit while
 * it is powered or its touch sensor is pressed.
 *
 * @param plugged the part on the port; null if it is empty.
 * @param isOn whether the brick is switched on.
 * @param onTouch called when the user presses or releases a touch sensor for fingers; never called for other sensors.
 */
@Composable
internal fun SensorPlug(
    state: SensorPortState,
    plugged: RobotPart?,
    isOn: Boolean,
    unit: Dp,
    onTouch: (Boolean) -> Unit,
    modifier: Modifier = Modifier,
) {
    val isForFingers = plugged is FingerTouchPart
    val isPressed = plugged?.kind == SensorKind.TOUCH && state.isPressed
    val value = if (isOn) valueText(state, plugged?.kind) else null
    val highlighted = isOn && (isPressed || state.isActive)
    Plug(
        if (highlighted) NxtColours.READ else NxtColours.SENSOR_PLUG,
        isAbove = false,
        isPlugged = plugged != null,
        unit,
        modifier
            .testTag(RunTags.port(state.port))
            .touchable(isForFingers, onTouch)
            .described(descriptionOf(state, plugged, value)) {
                if (isForFingers) {
                    role = Role.Button
                    // An immediate release would be missed: one click presses it, the next releases it.
                    onClick {
                        onTouch(!isPressed)
                        true
                    }
                }
            },
    ) {
        val label = if (plugged == null) NxtColours.ON_PLUG else NxtColours.LABEL
        Row(verticalAlignment = Alignment.CenterVertically) {
            PlugLabel("${state.port}", label, unit, PORT_SIZE)
            if (plugged != null) {
                val seen = state.colour?.let { NxtColours.of(it.kind) }
                Canvas(Modifier.padding(start = unit * 4).size(unit * 17)) {
                    drawSensorIcon(plugged.kind, isPressed, seen)
                }
            }
        }
        if (value != null) PlugLabel(value, label, unit, VALUE_SIZE)
    }
}

@Composable
private fun descriptionOf(state: SensorPortState, plugged: RobotPart?, value: String?): String {
    val name = when {
        plugged == null -> RunTexts.sensorNone(spoken)
        plugged is FingerTouchPart -> RunTexts.sensorTouch(spoken)
        else -> plugged.kind.words(spoken)
    }
    val port = CommonTexts.sensor(spoken, state.port, name)
    return if (value == null) port else RunTexts.sensorValue(spoken, port, value)
}

@Composable
private fun Modifier.touchable(isForFingers: Boolean, onTouch: (Boolean) -> Unit): Modifier =
    if (isForFingers) focusRing(12.dp).holdable({ onTouch(true) }, { onTouch(false) }) else this

/**
 * A motor port with the degrees of its counter. It is lit while its motor is driven, with an arrow for the direction
 * and the power.
 *
 * @param isPlugged whether the robot has a motor there.
 */
@Composable
internal fun MotorPlug(motor: MotorState, degrees: Int, isPlugged: Boolean, unit: Dp, modifier: Modifier = Modifier) {
    val name = motor.port.name
    val description = when (motor.mode) {
        MotorMode.FORWARD -> NxtTexts.motorForward(spoken, name, motor.power, degrees)
        MotorMode.BACKWARD -> NxtTexts.motorBackward(spoken, name, motor.power, degrees)
        MotorMode.BRAKE -> NxtTexts.motorBrake(spoken, name, degrees)
        MotorMode.FLOAT -> NxtTexts.motorFloat(spoken, name, degrees)
    }
    val isDriven = motor.mode == MotorMode.FORWARD || motor.mode == MotorMode.BACKWARD
    val label = if (isDriven && isPlugged) NxtColours.LABEL else NxtColours.ON_PLUG
    Plug(
        if (isDriven) NxtColours.DRIVEN else NxtColours.PLUG,
        isAbove = true,
        isPlugged,
        unit,
        modifier.testTag(RunTags.port(name)).described(description) { },
    ) {
        Row(
            horizontalArrangement = Arrangement.spacedBy(unit * 4),
            verticalAlignment = Alignment.CenterVertically,
        ) {
            PlugLabel(name, label, unit, PORT_SIZE)
            if (isDriven) {
                Box(Modifier.size(unit * 11, unit * 9).drawBehind { drawPath(arrow(motor.mode), label) })
                PlugLabel("${motor.power}", label, unit, PORT_SIZE)
            }
        }
        if (isPlugged || degrees != 0) PlugLabel("$degrees°", label, unit, VALUE_SIZE)
    }
}

private fun DrawScope.arrow(mode: MotorMode) = Path().apply {
    val tip = if (mode == MotorMode.FORWARD) 0f else size.height
    val base = size.height - tip
    moveTo(size.width / 2, tip)
    lineTo(size.width, base)
    lineTo(0f, base)
    close()
}

private fun Modifier.described(description: String, more: SemanticsPropertyReceiver.() -> Unit): Modifier =
    clearAndSetSemantics {
        contentDescription = description
        more()
    }
