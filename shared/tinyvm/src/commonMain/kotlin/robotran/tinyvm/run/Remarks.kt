package robotran.tinyvm.run

import robotran.rom.ProgramRemark
import robotran.tinyvm.Quirk
import robotran.tinyvm.RunMessages
import robotran.tinyvm.TinyVmLimits
import robotran.tinyvm.TinyVmMode

/** What a learner is told of a run, each thing once a line. */
internal class Remarks(private val mode: TinyVmMode, private val messages: RunMessages) {
    private val places = HashSet<Triple<Quirk, Int, String?>>()

    /** All so far; a new list with each that comes. */
    var all: List<ProgramRemark> = emptyList()
        private set

    fun add(quirk: Quirk, line: Int, file: String?) {
        if (all.size == TinyVmLimits.REMARKS || !places.add(Triple(quirk, line, file))) return
        val message = if (mode == TinyVmMode.BRICK) messages.bites(quirk) else messages.wouldBite(quirk)
        all = all + ProgramRemark(message, line, file)
    }
}
