package robotran.tinyvm.natives

import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCall
import robotran.rcxrom.sensors.SensorCode
import robotran.rcxrom.sensors.SensorField
import robotran.rcxrom.sensors.SensorRequest
import robotran.tinyvm.run.NativeMethod
import robotran.tinyvm.run.action
import robotran.tinyvm.run.rcx

/** `josx.platform.rcx.Sensor`, `Poll` and `Serial.resetSerial`. Source: leJOS `native.c`. */
internal val sensorMethods: Map<String, NativeMethod> = mapOf(
    "josx/platform/rcx/Sensor.readSensorValue(II)I" to NativeMethod { machine, thread, first ->
        val port = thread.stack[first]
        val request = SensorRequest.entries.find { it.code == thread.stack[first + 1] }
        if (port in 0 until SensorCode.PORTS && request != null) machine.rcx.rom.readSensor(port, request) else 0
    },
    "josx/platform/rcx/Sensor.setSensorValue(III)V" to action { machine, thread, first ->
        val port = thread.stack[first]
        val field = SensorField.entries.find { it.code == thread.stack[first + 2] }
        if (port in 0 until SensorCode.PORTS && field != null) {
            machine.rcx.rom.setSensorValue(port, thread.stack[first + 1], field)
            if (field == SensorField.MODE) machine.rcx.poller.modeSet(port)
        }
    },
    "josx/platform/rcx/Poll.setPoller()V" to
        action { machine, thread, first -> machine.rcx.poller.register(thread.stack[first]) },
    "josx/platform/rcx/Throttle.setThrottle(I)V" to action { machine, thread, first ->
        machine.rcx.poller.setThrottle(thread.stack[first])
    },
    "josx/platform/rcx/Serial.resetSerial()V" to action { machine, _, _ ->
        machine.rcx.rom.call(RomCall(RomAddress.INIT_SERIAL, listOf(0, 0, 1, 1)), 0)
    },
)
