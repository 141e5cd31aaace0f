package robotran.tinyvm.programs.thorough

import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.config.TinyVmSpeed
import robotran.tinyvm.programs.SameEffects
import kotlin.test.Test

class AllSameEffectsTest {
    @Test
    fun `every program in every mode at every speed does the same as stack code and as register code`() {
        for (mode in TinyVmMode.entries) {
            for (speed in TinyVmSpeed.entries) SameEffects.check(mode, speed, 0 until SameEffects.SHARES)
        }
    }
}
