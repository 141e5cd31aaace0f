package robotran.tinyvm.natives.nxj

import robotran.brick.kind.BrickKind
import robotran.brick.kind.JavaPlatform
import robotran.brick.sensors.SensorKind
import robotran.nxt.hardware.I2cStatus
import robotran.nxt.program.NxtCall
import robotran.nxt.program.NxtNative
import robotran.tinyvm.config.NxtCosts
import robotran.tinyvm.link.LinkedClass
import robotran.tinyvm.run.Frame
import robotran.tinyvm.run.Heap
import robotran.tinyvm.run.NativeMethod
import robotran.tinyvm.run.VirtualMachine
import robotran.tinyvm.run.VmThread
import robotran.tinyvm.run.brick

private const val PORT = "lejos/nxt/SensorPort"
private val PORTS = 0 until BrickKind.with(JavaPlatform.NXJ).inputPorts
private const val MOST_ANALOG = 1023
private const val COLOURS = 4

/** `lejos.nxt.SensorPort`. */
internal val nxtSensorMethods: Map<String, NativeMethod> = mapOf(
    "$PORT.readSensorValue(I)I" to reads { nxt, arguments ->
        val port = arguments(0)
        if (port in PORTS) nxt.analog(port) else 0
    },
    "$PORT.setPowerTypeById(II)V" to calls(NxtNative.SET_POWER_TYPE),
    "$PORT.setSensorPinMode(III)V" to calls(NxtNative.SET_SENSOR_PIN_MODE),
    "$PORT.setSensorPin(III)V" to calls(NxtNative.SET_SENSOR_PIN),
    "$PORT.getSensorPin(II)I" to reads { nxt, arguments -> pin(arguments) { port, pin -> nxt.pin(port, pin) } },
    "$PORT.readSensorPin(II)I" to reads { nxt, arguments ->
        pin(arguments) { port, pin -> nxt.pin(port, pin) } * MOST_ANALOG
    },
    "$PORT.setTypeById(II)V" to calls(NxtNative.SET_TYPE),
    "$PORT.readColourById(I[I)I" to NativeMethod(::readColour),
    "$PORT.i2cEnableById(II)V" to calls(NxtNative.I2C_ENABLE, NxtCosts.I2C_ENABLE),
    "$PORT.i2cDisableById(I)V" to calls(NxtNative.I2C_DISABLE, NxtCosts.I2C_ENABLE),
    "$PORT.i2cStatusById(I)I" to reads { nxt, arguments ->
        val port = arguments(0)
        if (port in PORTS) nxt.i2cStatus(port) else I2cStatus.INVALID_PORT
    },
    "$PORT.i2cStartById(II[BIII)I" to NativeMethod(::startI2c),
    "$PORT.i2cCompleteById(I[BII)I" to NativeMethod(::completeI2c),
)

private inline fun pin(arguments: (Int) -> Int, read: (port: Int, pin: Int) -> Boolean): Int {
    val port = arguments(0)
    val pin = arguments(1)
    val isThere = port in PORTS && pin in 0..1
    return if (isThere && read(port, pin)) 1 else 0
}

private fun readColour(machine: VirtualMachine, thread: VmThread, first: Int): Int {
    val port = thread.stack[first]
    val into = thread.stack[first + 1]
    machine.charge(NxtCosts.READ_COLOUR)
    if (!hasPart(machine, thread, into, 0, COLOURS) || port !in PORTS) return -1
    val seen = machine.brick.nxt.colour(port) ?: return -1
    val start = into + Heap.HEADER_WORDS
    machine.heap.words[start] = seen.red
    machine.heap.words[start + 1] = seen.green
    machine.heap.words[start + 2] = seen.blue
    machine.heap.words[start + 3] = seen.background
    return seen.kind.code
}

private fun startI2c(machine: VirtualMachine, thread: VmThread, first: Int): Int {
    val stack = thread.stack
    val length = stack[first + 4]
    val isEmpty = stack[first + 2] == 0 && length == 0
    val bytes = if (isEmpty) {
        ByteArray(0)
    } else {
        bytesOf(machine, thread, stack[first + 2], stack[first + 3], length) ?: return 0
    }
    machine.charge(NxtCosts.I2C_START)
    val numbers = intArrayOf(stack[first], stack[first + 1], stack[first + 5])
    if (numbers[0] !in PORTS) return I2cStatus.INVALID_PORT
    val sensor = thread.callStack.firstNotNullOfOrNull { sensorOf(machine, thread, it) }
    return machine.brick.call(thread, NxtCall(NxtNative.I2C_START, numbers, bytes = bytes, sensor = sensor))
}

/** Which sensor the object is whose method runs in [frame]; null if it is none that the library knows. */
private fun sensorOf(machine: VirtualMachine, thread: VmThread, frame: Frame): SensorKind? {
    if (frame.method.owner.name != I2C_SENSOR) return SENSORS[frame.method.owner.name]
    val type = machine.heap.typeOf(thread.stack[frame.base]) as? LinkedClass
    return generateSequence(type) { it.superclass }.firstNotNullOfOrNull { SENSORS[it.name] }
}

private const val I2C_SENSOR = "lejos/nxt/I2CSensor"

/** The classes of the library that ask sensors that send bytes. */
private val SENSORS = mapOf(
    "lejos/nxt/UltrasonicSensor" to SensorKind.ULTRASONIC,
    "lejos/nxt/TemperatureSensor" to SensorKind.NXT_TEMPERATURE,
    "lejos/nxt/addon/AccelHTSensor" to SensorKind.HITECHNIC_ACCELERATION,
    "lejos/nxt/addon/AccelMindSensor" to SensorKind.MINDSENSORS_ACCELERATION,
    "lejos/nxt/addon/ColorHTSensor" to SensorKind.HITECHNIC_COLOUR,
    "lejos/nxt/addon/CompassHTSensor" to SensorKind.COMPASS,
    "lejos/nxt/addon/CompassMindSensor" to SensorKind.MINDSENSORS_COMPASS,
    "lejos/nxt/addon/IRSeeker" to SensorKind.INFRARED_SEEKER,
    "lejos/nxt/addon/IRSeekerV2" to SensorKind.INFRARED_SEEKER_2,
    "lejos/nxt/addon/OpticalDistanceSensor" to SensorKind.OPTICAL_DISTANCE,
    "lejos/nxt/addon/RCXLink" to SensorKind.RCX_LINK,
)

private fun completeI2c(machine: VirtualMachine, thread: VmThread, first: Int): Int {
    val stack = thread.stack
    val port = stack[first]
    val into = stack[first + 1]
    val length = if (into == 0) 0 else stack[first + 3]
    if (into != 0 && !hasPart(machine, thread, into, stack[first + 2], length)) return 0
    if (port !in PORTS) return I2cStatus.INVALID_PORT
    val answer = ByteArray(length)
    val count = machine.brick.nxt.i2cComplete(port, answer)
    putBytes(machine, into, stack[first + 2], answer, count.coerceIn(0, length))
    return count
}
