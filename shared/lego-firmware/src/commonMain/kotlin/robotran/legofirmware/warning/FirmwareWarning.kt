package robotran.legofirmware.warning

import robotran.brick.program.RuntimeWarning
import robotran.legofirmware.messages.FirmwareRunMessages
import robotran.legofirmware.model.Assumptions

/** What a brick does silently, and what a pupil should hear about. */
internal sealed interface FirmwareWarning {
    fun text(messages: FirmwareRunMessages): String

    data object NestedCall : FirmwareWarning {
        override fun text(messages: FirmwareRunMessages) = messages.nestedCall()
    }

    data class InvalidOpcode(val byte: Int, val address: Int) : FirmwareWarning {
        override fun text(messages: FirmwareRunMessages) = messages.invalidOpcode(byte, address)
    }

    data class NewerCommand(val command: String) : FirmwareWarning {
        override fun text(messages: FirmwareRunMessages) = messages.newerCommand(command)
    }

    data class RequestOnly(val command: String) : FirmwareWarning {
        override fun text(messages: FirmwareRunMessages) = messages.requestOnly(command)
    }

    data object DivisionByZero : FirmwareWarning {
        override fun text(messages: FirmwareRunMessages) = messages.divisionByZero()
    }

    data class DatalogFull(val entries: Int) : FirmwareWarning {
        override fun text(messages: FirmwareRunMessages) = messages.datalogFull(entries)
    }

    data object NoDatalog : FirmwareWarning {
        override fun text(messages: FirmwareRunMessages) = messages.noDatalog()
    }

    data class NoTask(val number: Int) : FirmwareWarning {
        override fun text(messages: FirmwareRunMessages) = messages.noTask(number)
    }

    data class NoSub(val number: Int) : FirmwareWarning {
        override fun text(messages: FirmwareRunMessages) = messages.noSub(number)
    }

    data class NoVariable(val number: Int) : FirmwareWarning {
        override fun text(messages: FirmwareRunMessages) = messages.noVariable(number)
    }

    data class NoSource(val source: Int) : FirmwareWarning {
        override fun text(messages: FirmwareRunMessages) = messages.noSource(source)
    }

    data class NotWritable(val source: Int) : FirmwareWarning {
        override fun text(messages: FirmwareRunMessages) = messages.notWritable(source)
    }

    data class WrongPower(val power: Int) : FirmwareWarning {
        override fun text(messages: FirmwareRunMessages) = messages.wrongPower(power)
    }

    data class NoPort(val number: Int) : FirmwareWarning {
        override fun text(messages: FirmwareRunMessages) = messages.noPort(number)
    }

    data object TooManyLoops : FirmwareWarning {
        override fun text(messages: FirmwareRunMessages) = messages.tooManyLoops()
    }

    data object NoLoop : FirmwareWarning {
        override fun text(messages: FirmwareRunMessages) = messages.noLoop()
    }

    data object JumpOut : FirmwareWarning {
        override fun text(messages: FirmwareRunMessages) = messages.jumpOut()
    }
}

/** The warnings of a run: each once per line. */
internal class FirmwareWarnings(private val messages: FirmwareRunMessages) {
    private val places = HashSet<Triple<FirmwareWarning, Int, String?>>()

    /** All so far; each new one makes a new list. */
    var all: List<RuntimeWarning> = emptyList()
        private set

    fun add(warning: FirmwareWarning, line: Int, file: String?) {
        if (all.size >= Assumptions.MAX_WARNINGS || !places.add(Triple(warning, line, file))) return
        all = all + RuntimeWarning(warning.text(messages), line, file)
    }
}
