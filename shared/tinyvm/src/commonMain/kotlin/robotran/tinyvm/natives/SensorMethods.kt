package robotran.tinyvm.natives

import robotran.rom.SensorCode
import robotran.rom.SensorRequest
import robotran.tinyvm.run.Machine

/** `josx.platform.rcx.Sensor` and `Poll`, and what of `Serial` needs nobody else. Source: leJOS `native.c`. */
internal val sensorMethods: Map<String, NativeMethod> = mapOf(
    "josx/platform/rcx/Sensor.readSensorValue(II)I" to NativeMethod { machine, thread, first ->
        val port = thread.stack[first]
        val request = SensorRequest.entries.find { it.code == thread.stack[first + 1] }
        if (port in 0 until SensorCode.PORTS && request != null) machine.rom.readSensor(port, request) else 0
    },
    "josx/platform/rcx/Sensor.setSensorValue(III)V" to action { machine, thread, first ->
        set(machine, thread.stack[first], thread.stack[first + 1], thread.stack[first + 2])
    },
    "josx/platform/rcx/Poll.setPoller()V" to action { machine, thread, first -> machine.poller.register(thread.stack[first]) },
    "josx/platform/rcx/Poll.setThrottle(I)V" to action { machine, thread, first ->
        machine.poller.setThrottle(thread.stack[first + 1])
    },
    "josx/platform/rcx/Serial.resetSerial()V" to action { _, _, _ -> },
)

/** Sets what [request] says of the sensor on [port]: 0 its mode, 1 its type. */
private fun set(machine: Machine, port: Int, value: Int, request: Int) {
    if (port !in 0 until SensorCode.PORTS) return
    val settings = machine.sensorSettings[port]
    when (request) {
        0 -> settings.mode = value and 0xFF
        1 -> settings.type = value and 0xFF
        else -> return
    }
    machine.rom.setSensorTypeAndMode(port, settings.type, settings.mode)
}
