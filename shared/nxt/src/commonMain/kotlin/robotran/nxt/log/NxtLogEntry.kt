package robotran.nxt.log

import robotran.brick.log.CallGroup
import robotran.brick.log.CallOutcome
import robotran.brick.log.LoggedCall
import robotran.nxt.messages.NxtMessages
import robotran.nxt.messages.describe
import robotran.nxt.program.NxtCall

/** Who made a call. */
enum class CallOrigin {
    PROGRAM,

    /** The class library, without the program's doing at that moment, or the regulator of a motor. */
    LIBRARY,

    /** The brick itself, such as after the end of a program. */
    FIRMWARE,
}

/**
 * A call in the log of an NXT. Its [text] is as `1204 controlMotorById 0 75 1 ; motor A forward 75 ; Square.java:7`;
 * the location of calls that no line of the program makes is `library` or `firmware`.
 *
 * @property result what the call returned.
 */
class NxtLogEntry(
    override val milliseconds: Long,
    val call: NxtCall,
    val result: Int,
    override val outcome: CallOutcome,
    val origin: CallOrigin,
    override val sourceLine: Int,
    override val sourceFile: String?,
    private val messages: NxtMessages,
) : LoggedCall {
    override val group: CallGroup get() = call.native.group
    override val callText: String get() = call.toString()
    override val isByLibrary: Boolean get() = origin == CallOrigin.LIBRARY
    override val meaning: String
        get() = if (outcome == CallOutcome.DONE) messages.describe(call, result) else messages.wrongArguments()

    override val sourceLocation: String
        get() = if (isByLibrary) LIBRARY else super.sourceLocation

    /** Time, id of the call, its numbers, its text, its bytes. */
    override fun identify(add: (Long) -> Unit) {
        add(milliseconds)
        call.identify(add)
    }

    override fun toString(): String = text

    private companion object {
        const val LIBRARY = "library"
    }
}
