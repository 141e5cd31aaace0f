package robotran.tinyvm.run

import robotran.brick.program.RuntimeWarning
import robotran.tinyvm.config.MachineModel
import robotran.tinyvm.config.Quirk
import robotran.tinyvm.config.QuirkHandling
import robotran.tinyvm.config.TinyVmLimits
import robotran.tinyvm.messages.TinyVmRunMessages
import robotran.tinyvm.messages.nxt

/**
 * The warnings of a run, at most one per quirk and line.
 * @param programBytes brick memory that the program itself takes.
 * @param allBytes brick memory for the program and its objects.
 */
internal class RuntimeWarnings(
    private val model: MachineModel,
    private val messages: TinyVmRunMessages,
    private val programBytes: Int,
    private val allBytes: Int,
) {
    private var isNearlyFull = false
    private val places = HashSet<Triple<Quirk, Int, String?>>()

    /** All warnings so far; each new warning makes a new list. */
    var all: List<RuntimeWarning> = emptyList()
        private set

    fun add(quirk: Quirk, line: Int, file: String?) {
        if (all.size == TinyVmLimits.RUNTIME_WARNINGS || !places.add(Triple(quirk, line, file))) return
        all = all + RuntimeWarning(messageOf(quirk), line, file)
    }

    /** Adds, once, that an NXT has little memory left. */
    fun addNearlyFull(line: Int, file: String?) {
        if (isNearlyFull || all.size == TinyVmLimits.RUNTIME_WARNINGS) return
        isNearlyFull = true
        all = all + RuntimeWarning(messages.nxt.memoryNearlyFull(), line, file)
    }

    private fun messageOf(quirk: Quirk): String = when {
        quirk == Quirk.UNCHECKED_ELEMENT && model.elements == QuirkHandling.APPLY -> messages.quirkEffect(quirk)
        quirk == Quirk.UNCHECKED_ELEMENT || model.quirks == QuirkHandling.WARN -> messages.quirkWarning(quirk)
        model.isExact -> messages.nxt.memoryFull()

        quirk == Quirk.HEAP_FULL -> messages.quirkEffect(quirk) + " " +
            messages.programMemoryUse(programBytes, allBytes)

        else -> messages.quirkEffect(quirk)
    }
}
