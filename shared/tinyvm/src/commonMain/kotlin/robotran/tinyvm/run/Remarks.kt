package robotran.tinyvm.run

import robotran.tinyvm.Quirk
import robotran.tinyvm.Remark
import robotran.tinyvm.RunMessages
import robotran.tinyvm.TinyVmLimits
import robotran.tinyvm.TinyVmMode

/** What a learner is told of a run, each thing once a line. */
internal class Remarks(private val mode: TinyVmMode, private val messages: RunMessages) {
    private val remarks = LinkedHashMap<Pair<Quirk, Int>, Remark>()

    val all: List<Remark> get() = remarks.values.toList()

    fun add(quirk: Quirk, line: Int) {
        if (remarks.size == TinyVmLimits.REMARKS || quirk to line in remarks) return
        val message = if (mode == TinyVmMode.BRICK) messages.bites(quirk) else messages.wouldBite(quirk)
        remarks[quirk to line] = Remark(quirk, message, line)
    }
}
