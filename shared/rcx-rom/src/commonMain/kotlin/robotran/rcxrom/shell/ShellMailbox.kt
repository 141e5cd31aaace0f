package robotran.rcxrom.shell

import robotran.brick.log.CallLog
import robotran.brick.log.CallOutcome
import robotran.rcxrom.call.RomGap
import robotran.rcxrom.infrared.SerialReceiver
import robotran.rcxrom.log.RomLogEntry
import robotran.rcxrom.memory.FirmwareMemory
import robotran.rcxrom.memory.RcxMemory
import robotran.rcxrom.memory.SerialMemory
import robotran.rcxrom.messages.BrickMessages

/** Handles messages for the leJOS shell while no program runs. Source: leJOS `main.c`. */
internal class ShellMailbox(
    private val memory: RcxMemory,
    private val firmware: Firmware,
    private val messages: BrickMessages,
    private val log: CallLog,
) {
    /** What the shell must do after a message. */
    enum class ShellAction { NONE, START, UNKNOWN }

    val hasMessage: Boolean get() = memory.readByte(SerialMemory.VALID) != 0

    /** Takes the message, answers it, and returns what else to do. */
    fun answer(): ShellAction {
        firmware.receive(LONGEST)
        val opcode = memory.readByte(FirmwareMemory.MESSAGE)
        return when (opcode and SerialReceiver.TOGGLE_BIT.inv()) {
            ALIVE -> reply(opcode)
            GET_VERSIONS -> reply(opcode, VERSIONS)

            REMOTE_COMMAND -> if (memory.readByte(FirmwareMemory.MESSAGE + 1) and PROGRAM_1 != 0) {
                ShellAction.START
            } else {
                ShellAction.UNKNOWN
            }

            GET_VALUE, TRANSFER_DATA, DELETE_FIRMWARE -> report()
            else -> ShellAction.UNKNOWN
        }
    }

    private fun reply(opcode: Int, rest: List<Int> = emptyList()): ShellAction {
        firmware.send(listOf(opcode.inv()) + rest)
        return ShellAction.NONE
    }

    private fun report(): ShellAction {
        log.amendLast {
            (it as RomLogEntry).copy(
                meaning = messages.messageNotModelled(it.meaning, RomGap.DOWNLOAD),
                outcome = CallOutcome.NOT_MODELLED,
            )
        }
        return ShellAction.UNKNOWN
    }

    private companion object {
        const val LONGEST = 9
        const val ALIVE = 0x10
        const val GET_VALUE = 0x12
        const val GET_VERSIONS = 0x15
        const val TRANSFER_DATA = 0x45
        const val DELETE_FIRMWARE = 0x65
        const val REMOTE_COMMAND = 0xD2

        /** The bit of the remote control's P1 button, in the byte after the opcode. */
        const val PROGRAM_1 = 0x02

        /** ROM and firmware versions that leJOS reports. */
        val VERSIONS = listOf(0, 3, 0, 1, 0, 0, 0, 0)
    }
}
