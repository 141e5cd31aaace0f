package robotran.tinyvm.programs

import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.config.TinyVmSpeed
import kotlin.test.Test

/** Every program in one of the modes; `thorough` has every program in each. */
class SameEffectsTest {
    @Test
    fun `on a brick at its own speed`() = SameEffects.check(TinyVmMode.BRICK, TinyVmSpeed.BRICK, 0..0)

    @Test
    fun `with garbage collection at its own speed`() = SameEffects.check(TinyVmMode.FORGIVING, TinyVmSpeed.BRICK, 1..1)

    @Test
    fun `on a brick at full speed`() = SameEffects.check(TinyVmMode.BRICK, TinyVmSpeed.UNLIMITED, 2..2)

    @Test
    fun `with garbage collection at full speed`() = SameEffects.check(TinyVmMode.FORGIVING, TinyVmSpeed.UNLIMITED, 3..3)
}
