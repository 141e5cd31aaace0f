package robotran.tinyvm.programs

import robotran.tinyvm.TinyVmResult
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.testPrograms
import kotlin.test.Test
import kotlin.test.assertEquals

/** What the machine for a newer brick needs must not change the code of programs for an RCX. */
class SameCodeTest {
    @Test
    fun `the code of all test programs is the one that was recorded`() {
        var hash = 1L
        var methods = 0
        for (path in testPrograms.keys.sorted()) {
            for (mode in TinyVmMode.entries) {
                val ready = link(path, mode = mode) as? TinyVmResult.Success ?: continue
                for (body in ready.program.linked.methods.mapNotNull { it.body }) {
                    methods++
                    for (word in body.code.asList() + body.handlers.asList()) hash = hash * FACTOR + word
                }
            }
        }
        assertEquals(RECORDED, "$methods methods, $hash")
    }

    private companion object {
        const val FACTOR = 1_000_003L
        const val RECORDED = "45222 methods, 112796220782831323"
    }
}
