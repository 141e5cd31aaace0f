package robotran.tinyvm.natives.nxj

import robotran.nxt.program.NxtCall
import robotran.nxt.program.NxtNative
import robotran.tinyvm.run.NativeMethod
import robotran.tinyvm.run.action
import robotran.tinyvm.run.brick

private const val FIRMWARE_VERSION = 0x000901

/** Buttons, battery, sound, events and power of `lejos.nxt`. */
internal val brickMethods: Map<String, NativeMethod> = mapOf(
    "lejos/nxt/Button.getButtons()I" to reads { nxt, _ -> nxt.buttons() },
    "lejos/nxt/Battery.getBatteryStatus()I" to reads { nxt, _ -> nxt.batteryStatus() },
    "lejos/nxt/Sound.getTime()I" to reads { nxt, _ -> nxt.soundMillisecondsLeft() },
    "lejos/nxt/Sound.playFreq(III)V" to calls(NxtNative.PLAY_FREQ),
    "lejos/nxt/Sound.playQueuedSample([BIIII)I" to NativeMethod { machine, thread, first ->
        val stack = thread.stack
        val samples = bytesOf(machine, thread, stack[first], stack[first + 1], stack[first + 2])
        val numbers = intArrayOf(stack[first + 3], stack[first + 4])
        if (samples == null) {
            0
        } else {
            machine.brick.call(thread, NxtCall(NxtNative.PLAY_QUEUED_SAMPLE, numbers, bytes = samples))
        }
    },
    "lejos/nxt/NXTEvent.registerEvent()I" to
        NativeMethod { machine, thread, first -> machine.brick.register(thread.stack[first]) },
    "lejos/nxt/NXTEvent.unregisterEvent()I" to
        NativeMethod { machine, thread, first -> machine.brick.unregister(thread.stack[first]) },
    "lejos/nxt/NXT.shutDown()V" to action { machine, thread, _ ->
        machine.brick.call(thread, NxtCall.of(NxtNative.SHUT_DOWN))
        machine.isExited = true
    },
    "lejos/nxt/NXT.getFirmwareRawVersion()I" to reads { _, _ -> FIRMWARE_VERSION },
    "java/lang/Shutdown.halt(I)V" to action { machine, thread, first ->
        machine.brick.call(thread, NxtCall.of(NxtNative.EXIT, thread.stack[first]))
        machine.isExited = true
    },
)
