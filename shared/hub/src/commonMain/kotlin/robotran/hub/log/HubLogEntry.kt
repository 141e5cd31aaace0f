package robotran.hub.log

import robotran.brick.log.CallGroup
import robotran.brick.log.CallOutcome
import robotran.brick.log.LoggedCall
import robotran.hub.messages.HubMessages
import robotran.hub.messages.describe
import robotran.hub.program.HubCall
import robotran.hub.program.HubError

/**
 * A call in the log of a hub.
 *
 * @property error why the hub refused it; null if it did it.
 */
class HubLogEntry(
    override val milliseconds: Long,
    val call: HubCall,
    val error: HubError?,
    override val sourceLine: Int,
    override val sourceFile: String?,
    private val messages: HubMessages,
) : LoggedCall {
    override val group: CallGroup get() = call.native.group
    override val callText: String get() = call.toString()
    override val outcome: CallOutcome get() = if (error == null) CallOutcome.DONE else CallOutcome.WRONG_ARGUMENTS
    override val meaning: String get() = if (error == null) messages.describe(call) else messages.refused(error.python)

    override fun identify(add: (Long) -> Unit) {
        add(milliseconds)
        call.identify(add)
    }

    override fun toString(): String = text
}
