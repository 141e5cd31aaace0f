package robotran.microbit.log

import robotran.brick.log.CallGroup
import robotran.brick.log.CallOutcome
import robotran.brick.log.LoggedCall
import robotran.microbit.program.MicrobitCall
import robotran.microbit.program.MicrobitError

/**
 * A call in the log of a micro:bit.
 *
 * @property error why the board refused it; null if it did it.
 */
class MicrobitLogEntry internal constructor(
    override val milliseconds: Long,
    val call: MicrobitCall,
    val error: MicrobitError?,
    override val sourceLine: Int,
    override val sourceFile: String?,
    override val meaning: String,
) : LoggedCall {
    override val group: CallGroup get() = call.native.group
    override val callText: String get() = call.toString()
    override val outcome: CallOutcome get() = if (error == null) CallOutcome.DONE else CallOutcome.WRONG_ARGUMENTS

    override fun identify(add: (Long) -> Unit) {
        add(milliseconds)
        call.identify(add)
    }

    override fun toString(): String = text
}
