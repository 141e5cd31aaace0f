package robotran.robolang.run

import robotran.robolang.syntax.BrickButton
import robotran.robolang.syntax.Sense

/** Pushes a sensor's value. */
internal fun lowerSense(sense: Sense, emitter: Emitter, lightPort: Int) {
    when (sense) {
        Sense.LeftBumper -> emitter.emit { it.pushTruth(it.machine.senses.isPressed(RobotConstants.LEFT_BUMPER_PORT)) }

        Sense.RightBumper -> emitter.emit {
            it.pushTruth(it.machine.senses.isPressed(RobotConstants.RIGHT_BUMPER_PORT))
        }

        Sense.Light -> emitter.emit { it.push(it.machine.senses.value(lightPort)) }

        is Sense.Sensor -> emitter.emit { it.push(it.machine.senses.value(sense.port)) }

        is Sense.Button -> emitter.emit { it.pushTruth(it.machine.senses.isHeld(bitOf(sense.button), it.currentLine)) }

        Sense.Timer -> emitter.emit { it.pushDecimal(it.machine.senses.timerSeconds()) }

        Sense.Battery -> emitter.emit { it.pushDecimal(it.machine.senses.batteryVolts(it.currentLine)) }
    }
}

/** Source: leJOS `Button.java`. */
private fun bitOf(button: BrickButton): Int = when (button) {
    BrickButton.RUN -> 1
    BrickButton.VIEW -> 2
    BrickButton.PRGM -> 4
}
