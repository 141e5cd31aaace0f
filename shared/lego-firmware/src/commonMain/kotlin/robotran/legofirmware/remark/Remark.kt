package robotran.legofirmware.remark

import robotran.brick.program.RuntimeWarning
import robotran.legofirmware.messages.RunMessages
import robotran.legofirmware.model.Assumptions

/** What a brick does silently, and what a pupil should hear about. */
internal sealed interface Remark {
    fun text(messages: RunMessages): String

    data object NestedCall : Remark {
        override fun text(messages: RunMessages) = messages.nestedCall()
    }

    data class InvalidOpcode(val byte: Int, val address: Int) : Remark {
        override fun text(messages: RunMessages) = messages.invalidOpcode(byte, address)
    }

    data class NewerCommand(val command: String) : Remark {
        override fun text(messages: RunMessages) = messages.newerCommand(command)
    }

    data class RequestOnly(val command: String) : Remark {
        override fun text(messages: RunMessages) = messages.requestOnly(command)
    }

    data object DivisionByZero : Remark {
        override fun text(messages: RunMessages) = messages.divisionByZero()
    }

    data class DatalogFull(val entries: Int) : Remark {
        override fun text(messages: RunMessages) = messages.datalogFull(entries)
    }

    data object NoDatalog : Remark {
        override fun text(messages: RunMessages) = messages.noDatalog()
    }

    data class NoTask(val number: Int) : Remark {
        override fun text(messages: RunMessages) = messages.noTask(number)
    }

    data class NoSub(val number: Int) : Remark {
        override fun text(messages: RunMessages) = messages.noSub(number)
    }

    data class NoVariable(val number: Int) : Remark {
        override fun text(messages: RunMessages) = messages.noVariable(number)
    }

    data class NoSource(val source: Int) : Remark {
        override fun text(messages: RunMessages) = messages.noSource(source)
    }

    data class NotWritable(val source: Int) : Remark {
        override fun text(messages: RunMessages) = messages.notWritable(source)
    }

    data class WrongPower(val power: Int) : Remark {
        override fun text(messages: RunMessages) = messages.wrongPower(power)
    }

    data class NoPort(val number: Int) : Remark {
        override fun text(messages: RunMessages) = messages.noPort(number)
    }

    data object TooManyLoops : Remark {
        override fun text(messages: RunMessages) = messages.tooManyLoops()
    }

    data object NoLoop : Remark {
        override fun text(messages: RunMessages) = messages.noLoop()
    }

    data object JumpOut : Remark {
        override fun text(messages: RunMessages) = messages.jumpOut()
    }
}

/** The remarks of a run: each once per line. */
internal class Remarks(private val messages: RunMessages) {
    private val places = HashSet<Triple<Remark, Int, String?>>()

    /** All so far; each new one makes a new list. */
    var all: List<RuntimeWarning> = emptyList()
        private set

    fun add(remark: Remark, line: Int, file: String?) {
        if (all.size >= Assumptions.REMARKS || !places.add(Triple(remark, line, file))) return
        all = all + RuntimeWarning(remark.text(messages), line, file)
    }
}
