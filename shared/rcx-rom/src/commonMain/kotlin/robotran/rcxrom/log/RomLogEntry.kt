package robotran.rcxrom.log

import robotran.brick.log.CallGroup
import robotran.brick.log.CallOutcome
import robotran.brick.log.LoggedCall
import robotran.rcxrom.call.RomCall
import robotran.rcxrom.call.RomCallText
import robotran.rcxrom.call.RomTable

/** One call of a ROM routine. In its [text], codes and pointers are hexadecimal, numbers signed decimal. */
data class RomLogEntry(
    override val milliseconds: Long,
    val call: RomCall,
    override val meaning: String,
    override val sourceLine: Int,
    override val outcome: CallOutcome,
    override val sourceFile: String? = null,
) : LoggedCall {
    override val group: CallGroup get() = RomTable.groupOf(call.address)
    override val callText: String get() = RomCallText.of(call)

    /** Time, address, number of arguments, arguments. */
    override fun identify(add: (Long) -> Unit) {
        add(milliseconds)
        add(call.address.toLong())
        add(call.arguments.size.toLong())
        call.arguments.forEach { add(it.toLong()) }
    }
}

/** The calls of ROM routines among these, in their order. */
fun Iterable<LoggedCall>.romCalls(): List<RomLogEntry> = filterIsInstance<RomLogEntry>()
