package robotran.robolang.run

import robotran.brick.kind.BrickKind
import robotran.robolang.robot.SensorPorts
import robotran.robolang.syntax.Sense
import robotran.robolang.words.BrickDialect

/** Pushes a sensor's value. */
internal fun lowerSense(sense: Sense, emitter: Emitter, ports: SensorPorts, kind: BrickKind) {
    when (sense) {
        Sense.LeftBumper -> lowerBumper(ports.leftBumperPort, emitter)
        Sense.RightBumper -> lowerBumper(ports.rightBumperPort, emitter)
        Sense.Light -> ports.lightPort.let { port -> emitter.emit { it.push(it.machine.robot.light(port)) } }

        is Sense.Sensor -> if (kind.readsInUnits && !readsWhatIsThere(sense, ports, kind)) {
            lowerAt(sense.port, ports.senseAt(sense.port), emitter)
        } else {
            emitter.emit { it.push(it.machine.robot.value(sense.port)) }
        }

        is Sense.Button -> emitter.emit { it.pushTruth(it.machine.robot.isHeld(sense.button, it.currentLine)) }
        Sense.Timer -> emitter.emit { it.pushDecimal(it.machine.timer.seconds()) }
        Sense.Battery -> emitter.emit { it.pushDecimal(it.machine.robot.batteryVolts(it.currentLine)) }
        Sense.Distance, Sense.Loudness, Sense.Colour -> lowerAt(checkNotNull(ports.portOf(sense)), sense, emitter)
        is Sense.Turned -> emitter.emit { it.push(it.machine.robot.turned(sense.port)) }
    }
}

/** Whether `sensor 4` is whatever the robot has there, not what the words of the program say. */
private fun readsWhatIsThere(sense: Sense.Sensor, ports: SensorPorts, kind: BrickKind): Boolean =
    BrickDialect.of(kind).asksRobot && ports.senseAt(sense.port) != Sense.Colour

private fun lowerBumper(port: Int, emitter: Emitter) = emitter.emit { it.pushTruth(it.machine.robot.isPressed(port)) }

/** Pushes the value of the sensor on [port] that [sense] reads: a colour as its number, anything else as a whole number. */
private fun lowerAt(port: Int, sense: Sense, emitter: Emitter) = when (sense) {
    Sense.Distance -> {
        emitter.emit { it.machine.robot.measureDistance(port, it.currentLine) }
        emitter.emit {
            val robot = it.machine.robot
            if (robot.hasDistance(port)) it.push(robot.distance(port)) else it.lookAgain()
        }
    }

    Sense.Loudness -> emitter.emit { it.push(it.machine.robot.loudness(port)) }
    Sense.Colour -> emitter.emit { it.push(it.machine.robot.colour(port)) }
    Sense.Light -> emitter.emit { it.push(it.machine.robot.light(port)) }
    else -> lowerBumper(port, emitter)
}
