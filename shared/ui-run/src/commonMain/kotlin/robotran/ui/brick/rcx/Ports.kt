package robotran.ui.brick.rcx

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.onClick
import androidx.compose.ui.semantics.role
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorState
import robotran.rcxrom.sensors.SensorState
import robotran.ui.common.BrickColours
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.ui.texts.CommonTexts
import robotran.uikit.*

/**
 * A grey input port with its sensor and value. It is lit while it is powered or its bumper is pressed.
 *
 * @param on whether the brick is switched on and measures.
 * @param onTouch called when the user presses or releases the touch sensor; never called for other sensors.
 */
@Composable
internal fun InputPort(
    sensor: SensorState,
    plugged: PluggedSensor,
    on: Boolean,
    unit: Dp,
    onTouch: (Boolean) -> Unit,
    modifier: Modifier = Modifier,
) {
    val name = plugged.words(spoken)
    val port = CommonTexts.sensor(spoken, sensor.port, name)
    val description = if (on) RunTexts.sensorValue(spoken, port, "${sensor.value}") else port
    val highlighted = on && (sensor.active || plugged.isPressed(sensor))
    PortBlock(
        if (highlighted) BrickColours.READ else BrickColours.INPUT,
        unit,
        modifier
            .testTag(RunTags.port(sensor.port))
            .touchable(plugged == PluggedSensor.TOUCH, onTouch)
            .clearAndSetSemantics {
                contentDescription = description
                if (plugged == PluggedSensor.TOUCH) {
                    role = Role.Button
                    // An immediate release would be missed: one click presses it, the next releases it.
                    onClick {
                        onTouch(!plugged.isPressed(sensor))
                        true
                    }
                }
            },
    ) {
        Row(verticalAlignment = Alignment.CenterVertically) {
            PortLabel("${sensor.port}", BrickColours.LABEL, unit)
            Canvas(Modifier.padding(start = unit * 4).size(unit * 16)) {
                drawPlugged(plugged, plugged.isPressed(sensor))
            }
        }
        PortLabel(if (on) "${sensor.value}" else "", BrickColours.LABEL, unit)
    }
}

@Composable
private fun Modifier.touchable(isTouch: Boolean, onTouch: (Boolean) -> Unit): Modifier =
    if (isTouch) focusRing(12.dp).holdable({ onTouch(true) }, { onTouch(false) }) else this

/**
 * A black output port. It is lit while its motor is driven, with an arrow for the direction and a digit for the power.
 */
@Composable
internal fun OutputPort(motor: MotorState, unit: Dp, modifier: Modifier = Modifier) {
    val name = motor.port.name
    val description = when (motor.mode) {
        MotorMode.FORWARD -> RunTexts.motorForward(spoken, name, motor.power)
        MotorMode.BACKWARD -> RunTexts.motorBackward(spoken, name, motor.power)
        MotorMode.BRAKE -> RunTexts.motorBrake(spoken, name)
        MotorMode.FLOAT -> RunTexts.motorFloat(spoken, name)
    }
    val driven = motor.mode == MotorMode.FORWARD || motor.mode == MotorMode.BACKWARD
    PortBlock(
        if (driven) BrickColours.DRIVEN else BrickColours.OUTPUT,
        unit,
        modifier.testTag(RunTags.port(name)).clearAndSetSemantics { contentDescription = description },
    ) {
        PortLabel(
            if (driven) "$name ${motor.power}" else name,
            if (driven) BrickColours.LABEL else RobotranColours.ON_COLOUR,
            unit,
        )
        if (driven) DirectionArrow(forward = motor.mode == MotorMode.FORWARD, unit = unit)
    }
}

@Composable
private fun PortBlock(colour: Color, unit: Dp, modifier: Modifier, content: @Composable () -> Unit) {
    Box(
        modifier
            .background(BrickColours.EDGE, RoundedCornerShape(unit * 7))
            .drawBehind { drawPort(colour) },
        contentAlignment = Alignment.Center,
    ) {
        Column(horizontalAlignment = Alignment.CenterHorizontally) { content() }
    }
}

@Composable
private fun PortLabel(text: String, colour: Color, unit: Dp) {
    Text(
        text,
        style = TextStyles.scaled(unit, 16f, 18f).copy(fontWeight = FontWeight.Bold),
        color = colour,
        maxLines = 1,
    )
}

@Composable
private fun DirectionArrow(forward: Boolean, unit: Dp) {
    Box(Modifier.size(unit * 16, unit * 11).drawBehind { drawDirectionArrow(forward) })
}
