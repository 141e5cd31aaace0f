package robotran.legofirmware.run

import robotran.legofirmware.device.Outputs

/** What the remote control wants of the brick's shell. */
internal sealed interface RemoteCommand {
    /** @property slot index of the program. */
    data class Start(val slot: Int) : RemoteCommand

    data object Stop : RemoteCommand
}

/** LEGO's remote control: buttons for messages, motors, programs, stop and a sound. Source: Proudfoot. */
internal class RemoteControl(private val core: Core) {
    private var command: RemoteCommand? = null
    private var drivenMotors = 0
    private var lastKeys = 0

    fun takeCommand(): RemoteCommand? = command.also { command = null }

    /** Starts the selected program, as another device asks for. */
    fun startSelected() {
        command = RemoteCommand.Start(core.devices.slot)
    }

    /** Takes what the remote control sends over and over while keys are held down, and once when they are released. */
    fun press(word: Int) {
        val keys = (word shr Byte.SIZE_BITS and BYTE) or (word and BYTE shl Byte.SIZE_BITS)
        val new = keys and lastKeys.inv()
        lastKeys = keys
        for (message in 1..MESSAGES) if (new and (1 shl message - 1) != 0) core.setMessage(message)
        drive(keys)
        for (slot in 0 until SLOTS) if (new and (FIRST_SLOT shl slot) != 0) command = RemoteCommand.Start(slot)
        if (new and STOP != 0) command = RemoteCommand.Stop
        if (new and SOUND != 0) core.devices.sounds.play(1)
    }

    private fun drive(keys: Int) {
        val outputs = core.devices.outputs
        val forward = keys shr FORWARD_SHIFT and MOTORS
        val backward = keys shr BACKWARD_SHIFT and MOTORS
        val driven = forward or backward
        val released = drivenMotors and driven.inv()
        if (released != 0) outputs.switch(Outputs.OFF or released)
        val new = driven and drivenMotors.inv()
        if (new and forward != 0) outputs.turn(Outputs.FORWARD or (new and forward))
        if (new and backward and forward.inv() != 0) outputs.turn(new and backward and forward.inv())
        if (new != 0) outputs.switch(Outputs.ON or new)
        drivenMotors = driven
    }

    private companion object {
        const val BYTE = 0xFF
        const val MESSAGES = 3
        const val MOTORS = 7
        const val FORWARD_SHIFT = 3
        const val BACKWARD_SHIFT = 6
        const val FIRST_SLOT = 0x200
        const val SLOTS = 5
        const val STOP = 0x4000
        const val SOUND = 0x8000
    }
}
